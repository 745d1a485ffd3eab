#include <cmath>

#include "solid/stress/stress.hpp"
#include "statistics/estimate.hpp"
#include "statistics/numbers.hpp"

namespace arenite::stress {
namespace {

using statistics::Declared;
using statistics::put;

constexpr Declared<NodeCounts> node_numbers[] = {{"nodes", "", "Nodes of particles and matrix that count", &NodeCounts::nodes},
                                                 {"clamp_nodes", "", "Nodes left out as clamp rows", &NodeCounts::clamp_nodes},
                                                 {"surface_nodes", "", "Nodes left out that border another phase or grain", &NodeCounts::surface_nodes},
                                                 {"unloaded_nodes", "", "Nodes without any stress", &NodeCounts::unloaded_nodes}};

constexpr Declared<Distribution> distribution_numbers[] = {
    {"count", "", "Nodes of the set", &Distribution::count},
    {"mean_Pa", "Pa", "Mean stress of the set, tension positive", &Distribution::mean},
    {"mean_over_sample_mean", "", "Mean stress of the set over that of the sample", &Distribution::relative_mean},
    {"variance", "", "Variance of the stress over the sample's mean", &Distribution::variance},
    {"own_variance", "", "Variance of the stress over the set's own mean", &Distribution::own_variance},
    {"skewness", "", "Skewness of the stress", &Distribution::skewness},
    {"excess_kurtosis", "", "Excess kurtosis of the stress; 0: as a Gaussian", &Distribution::excess_kurtosis},
    {"fraction_above_own_mean", "", "Share of nodes above the set's own mean", &Distribution::fraction_above_mean},
    {"fraction_above_sample_mean", "", "Share of nodes above the sample's mean", &Distribution::fraction_above_mean_of_all},
    {"quantiles", "", "Stress over the sample's mean below which this share of nodes lies", &Distribution::quantiles},
    {"minimum", "", "Least stress over the sample's mean", &Distribution::minimum},
    {"maximum", "", "Largest stress over the sample's mean", &Distribution::maximum}};

constexpr Declared<ComponentStatistics> component_numbers[] = {
    {"sample_mean_Pa", "Pa", "The mean that stresses are divided by", &ComponentStatistics::sample_mean},
    {"mean_over_nodes_Pa", "Pa", "Mean over nodes of particles and matrix", &ComponentStatistics::mean_over_nodes},
    {"mean_over_area_Pa", "Pa", "Mean over the whole area, the void as zero", &ComponentStatistics::mean_over_area}};

/// Six digits are more than counting gives.
Numbers rounded(const statistics::Histogram& pdf) {
  Numbers density = Numbers::list();
  for (const double y : pdf.density) density.push_back(std::round(y * 1e6) * 1e-6);
  return {{"low", pdf.bins.low}, {"width", pdf.bins.width}, {"density", density}};
}

Numbers distribution(const Distribution& d, bool curves) {
  Numbers j = tree_of(d, distribution_numbers);
  if (d.tail.count > 0) j["tail"] = tree_of(d.tail, statistics::tail_numbers);
  if (Numbers fit = tree_of(d.q_gaussian, statistics::q_gaussian_numbers); !fit.empty()) j["q_gaussian"] = fit;
  if (std::isfinite(d.peak.at)) j["peak"] = {{"at", d.peak.at}, {"height", d.peak.height}};
  if (!d.histogram.density.empty()) j["histogram"] = rounded(d.histogram);
  if (!d.own_histogram.density.empty()) j["own_histogram"] = rounded(d.own_histogram);
  if (curves && !d.pdf.x.empty()) j["pdf"] = d.pdf;
  if (curves && !d.own_pdf.x.empty()) j["own_pdf"] = d.own_pdf;
  return j;
}

Numbers component(const ComponentStatistics& c, bool curves) {
  Numbers j = tree_of(c, component_numbers);
  j["normalised_by"] = c.over_mean ? "mean" : "root mean square";
  for (const auto& [name, set] : c.sets) j["sets"][name] = distribution(set, curves);
  return j;
}

Numbers grains(const GrainStresses& g, bool rows) {
  std::size_t whole = 0;
  for (const auto w : g.whole) whole += w;
  Numbers j{{"whole", whole}};
  for (const auto& [name, mean] : g.mean) put(j["mean_stress_Pa"], name, mean, "Pa", "Mean stress of whole grains, tension positive");
  if (!rows) return j;
  Numbers centres = Numbers::list(), stresses = Numbers::list();
  for (std::size_t i = 0; i < g.nodes.size(); ++i) {
    centres.push_back({g.centre[i].x, g.centre[i].y});
    stresses.push_back(g.stress[i]);
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

}  // namespace

Numbers numbers(const Statistics& s, bool curves) {
  Numbers j = statistics::tree_of<NodeCounts>(s, node_numbers);
  j["options"] = options(s.options);
  for (const auto& c : s.components) j[name_of(c.component)] = component(c, curves);
  if (!s.grains.nodes.empty()) j["grains"] = grains(s.grains, curves);
  j["notes"] = s.notes;
  return j;
}

std::string to_text(const Statistics& s) {
  return arenite::to_text(numbers(s), {"options quantiles own_variance mean_over_nodes_Pa mean_over_area_Pa line_slope line_r2 log_likelihood_ratio "
                                       "p_value centre peak"});
}

}  // namespace arenite::stress
