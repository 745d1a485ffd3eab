#include <fmt/format.h>

#include <cmath>

#include "solid/stress/stress.hpp"
#include "statistics/estimate.hpp"
#include "statistics/numbers.hpp"

namespace arenite::stress {
namespace {

using statistics::curve;
using statistics::matrix;
using statistics::put;

/// Six digits are more than counting gives.
Numbers even(const statistics::EvenDensity& pdf) {
  Numbers density = Numbers::list();
  for (const double y : pdf.density) density.push_back(std::round(y * 1e6) * 1e-6);
  return {{"low", pdf.bins.low}, {"width", pdf.bins.width}, {"density", density}};
}

Numbers distribution(const Distribution& d, bool curves) {
  Numbers j{{"count", d.count}};
  put(j, "mean_Pa", d.mean);
  put(j, "mean_over_sample_mean", d.relative_mean);
  put(j, "variance", d.variance);
  put(j, "own_variance", d.own_variance);
  put(j, "skewness", d.skewness);
  put(j, "excess_kurtosis", d.excess_kurtosis);
  put(j, "fraction_above_own_mean", d.fraction_above_mean);
  put(j, "fraction_above_sample_mean", d.fraction_above_mean_of_all);
  put(j, "quantiles", d.quantiles);
  put(j, "minimum", d.minimum);
  put(j, "maximum", d.maximum);
  if (d.tail.count > 0) j["tail"] = tree_of(d.tail, statistics::tail_numbers);
  if (Numbers fit = tree_of(d.q_gaussian, statistics::q_gaussian_numbers); !fit.empty()) j["q_gaussian"] = fit;
  if (std::isfinite(d.peak.at)) j["peak"] = {{"at", d.peak.at}, {"height", d.peak.height}};
  if (!d.even_pdf.density.empty()) j["even_pdf"] = even(d.even_pdf);
  if (!d.own_even_pdf.density.empty()) j["own_even_pdf"] = even(d.own_even_pdf);
  if (curves && !d.pdf.x.empty()) j["pdf"] = curve(d.pdf);
  if (curves && !d.own_pdf.x.empty()) j["own_pdf"] = curve(d.own_pdf);
  return j;
}

Numbers component(const ComponentStatistics& c, bool curves) {
  Numbers j = Numbers::tree();
  put(j, "sample_mean_Pa", c.sample_mean);
  put(j, "mean_over_nodes_Pa", c.mean_over_nodes);
  put(j, "mean_over_area_Pa", c.mean_over_area);
  j["normalised_by"] = c.over_mean ? "mean" : "root mean square";
  for (const auto& [name, set] : c.sets) j["sets"][name] = distribution(set, curves);
  return j;
}

Numbers grains(const GrainStresses& g, bool rows) {
  std::size_t whole = 0;
  for (const auto w : g.whole) whole += w;
  Numbers j{{"whole", whole}};
  for (const auto& [name, mean] : g.mean) put(j["mean_stress_Pa"], name, mean);
  if (!rows) return j;
  Numbers centres = Numbers::list(), stresses = Numbers::list();
  for (std::size_t i = 0; i < g.nodes.size(); ++i) {
    centres.push_back({g.centre[i].x, g.centre[i].y});
    stresses.push_back(matrix(g.stress[i]));
  }
  j["by_grain"] = {{"nodes", g.nodes}, {"whole", g.whole}, {"centre_m", centres}, {"sigma_Pa", stresses}};
  return j;
}

Numbers options(const StressOptions& o) {
  return {{"clamp_rows", o.clamp_rows},
          {"leave_out_surface", o.leave_out_surface},
          {"leave_out_unloaded", o.leave_out_unloaded},
          {"sample_mean_over", o.mean_over_area ? "area" : "particles and matrix"},
          {"blocks", o.blocks}};
}

using statistics::Lines;
using statistics::with_error;

void put_set(Lines& lines, const std::string& what, const Distribution& d) {
  if (d.relative_mean.error > 1e-12) lines.put("mean, " + what, d.relative_mean, "of the sample's");
  lines.put("variance, " + what, d.variance);
  lines.put("share above the mean, " + what, d.fraction_above_mean);
  if (const Estimate* q = statistics::find(d.quantiles, "99.9 %")) lines.put("99.9 % quantile, " + what, *q);
  lines.put("excess kurtosis, " + what, d.excess_kurtosis);
  if (std::isfinite(d.tail.slope.value))
    lines.put("slope of the tail, " + what, fmt::format("{} between {:.3g} and {:.3g} own means", with_error(d.tail.slope), d.tail.low, d.tail.high));
  if (std::isfinite(d.q_gaussian.q.value))
    lines.put("q of the q-Gaussian, " + what, fmt::format("{}, R^2 {:.3f}", with_error(d.q_gaussian.q), d.q_gaussian.r2));
}

}  // namespace

Numbers numbers(const Statistics& s, bool curves) {
  Numbers j{{"nodes", s.nodes}, {"clamp_nodes", s.clamp_nodes}, {"surface_nodes", s.surface_nodes}, {"unloaded_nodes", s.unloaded_nodes}};
  j["options"] = options(s.options);
  for (const auto& c : s.components) j[name_of(c.component)] = component(c, curves);
  if (!s.grains.nodes.empty()) j["grains"] = grains(s.grains, curves);
  j["notes"] = s.notes;
  return j;
}

std::string to_text(const Statistics& s) {
  Lines lines;
  lines.put("nodes of particles and matrix", fmt::format("{}", s.nodes));
  for (const auto& c : s.components) {
    const std::string stress = name_of(c.component);
    const auto [unit, scale] = statistics::stress_unit(std::abs(c.sample_mean.value));
    lines.put("mean " + stress, c.sample_mean, unit, scale);
    for (const auto& [name, set] : c.sets) put_set(lines, name == "all" ? stress : stress + " in " + name, set);
  }
  for (const auto& note : s.notes) lines.note(note);
  return lines.text();
}

}  // namespace arenite::stress
