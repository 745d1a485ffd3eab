#include <cmath>

#include "statistics/put_numbers.hpp"
#include "solid/stress/stress.hpp"

namespace arenite::stress {
namespace {

using statistics::curve;
using statistics::matrix;
using statistics::put;

Numbers tail(const statistics::TailFit& t) {
  Numbers j = Numbers::tree();
  put(j, "slope", t.slope);
  put(j, "line_slope", t.line_slope);
  put(j, "line_r2", t.line_r2);
  put(j, "low", t.low);
  put(j, "high", t.high);
  j["count"] = t.count;
  put(j, "log_likelihood_ratio", t.likelihood_ratio);
  put(j, "p_value", t.p_value);
  return j;
}

Numbers q_gaussian(const statistics::QGaussian& g) {
  Numbers j = Numbers::tree();
  put(j, "q", g.q);
  put(j, "beta", g.beta);
  put(j, "centre", g.centre);
  put(j, "r2", g.r2);
  return j;
}

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
  put(j, "share_above_own_mean", d.share_above);
  put(j, "share_above_sample_mean", d.share_above_all);
  put(j, "quantiles", d.quantiles);
  put(j, "minimum", d.minimum);
  put(j, "maximum", d.maximum);
  if (d.tail.count > 0) j["tail"] = tail(d.tail);
  if (Numbers fit = q_gaussian(d.q_gaussian); !fit.empty()) j["q_gaussian"] = fit;
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
  return {{"clamp_rows", o.clamp_rows}, {"leave_out_surface", o.leave_out_surface}, {"leave_out_unloaded", o.leave_out_unloaded},
          {"sample_mean_over", o.mean_over_area ? "area" : "particles and matrix"}, {"blocks", o.blocks}};
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

}  // namespace arenite::stress
