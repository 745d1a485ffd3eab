#include "report/figures/field_figures.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include "report/figures/failure.hpp"
#include "statistics/q_gaussian.hpp"
#include "statistics/tails.hpp"

namespace arenite::report::figures {
namespace {

using Pairs = std::pair<std::vector<double>, std::vector<double>>;

/// A set of nodes: its numbers, and its density over the sample's mean or over its own.
struct NodeSet {
  std::string name;
  const Numbers* of = nullptr;
  const Numbers* density = nullptr;
};

/// Those that have a density; particles only where they have no classes.
std::vector<NodeSet> node_sets(const Numbers& component, bool own) {
  std::vector<NodeSet> found;
  const Numbers* sets = component.at_path("/sets");
  for (const char* name : {"all", "large", "small", "particle", "matrix"}) {
    const bool classed = sets && (sets->contains("large") || sets->contains("small"));
    if (!sets || !sets->contains(name) || (classed && std::string_view(name) == "particle")) continue;
    const Numbers& set = *sets->find(name);
    if (const auto density = set.find(own ? "own_pdf" : "pdf"); density != set.end() && density->is_tree())
      found.push_back({name, &set, &*density});
  }
  return found;
}

/// The fitted fall-off exp(-s x) between its ends, which holds as many nodes as were counted there.
Pairs tail_of(const Numbers& set) {
  const statistics::CutExponential tail{
      .rate = estimate_at(set, "/tail/slope").value,
      .low = estimate_at(set, "/tail/low").value,
      .high = estimate_at(set, "/tail/high").value,
      .share = estimate_at(set, "/tail/count").value / estimate_at(set, "/count").value};
  if (!tail.is_known()) return {};
  return sampled(
      tail.low, tail.high, [&](double x) { return tail.at(x); }, 1);
}

Pairs q_gaussian_of(const Numbers& set, double low, double high) {
  const double q = estimate_at(set, "/q_gaussian/q").value, beta = estimate_at(set, "/q_gaussian/beta").value,
               centre = estimate_at(set, "/q_gaussian/centre").value;
  if (!std::isfinite(q) || !std::isfinite(beta) || !std::isfinite(centre)) return {};
  return sampled(
      low, high, [&](double x) { return statistics::q_gaussian_density(x, centre, beta, q); }, 120);
}

Panel density_panel(const std::vector<NodeSet>& sets, const std::string& label, bool logarithmic, bool own) {
  double most = 0;
  for (const NodeSet& set : sets) most = largest_of(reals_at(*set.density, "/y"), most);
  const double least = most * (logarithmic ? 2e-5 : 6e-3);
  double low = 1e300, high = -1e300;
  for (const NodeSet& set : sets) {
    const auto x = reals_at(*set.density, "/x"), y = reals_at(*set.density, "/y");
    for (std::size_t k = 0; k < x.size(); ++k)
      if (y[k] >= least) low = std::min(low, x[k]), high = std::max(high, x[k]);
  }
  Panel panel{{.label = label, .low = low, .high = high}};
  if (logarithmic) panel.y = decades_about("probability density", least, most);
  else panel.y = {.label = "probability density", .low = 0, .high = 1.05 * most};
  panel.y.brief = "density";
  for (const NodeSet& set : sets) {
    auto y = reals_at(*set.density, "/y");
    for (double& value : y)
      if (!(value > 0)) value = statistics::unknown;
    panel.series.push_back({.name = set.name,
                            .colour = "set " + set.name,
                            .x = reals_at(*set.density, "/x"),
                            .y = std::move(y),
                            .line = Line::solid,
                            .weight = set.name == "all" ? 1.25 : 0.9,
                            .opacity = own ? 0.55 : 1});
  }
  for (const NodeSet& set : sets) {
    if (!own) break;
    const auto [x, y] = logarithmic ? tail_of(*set.of) : q_gaussian_of(*set.of, low, high);
    if (!x.empty())
      panel.series.push_back({.colour = "set " + set.name,
                              .x = x,
                              .y = y,
                              .line = logarithmic ? Line::dashed : Line::dotted,
                              .is_read = false});
  }
  panel.references = {{.x = 1}};
  return panel;
}

std::vector<KeyEntry> density_key(const std::vector<NodeSet>& sets, bool own) {
  std::vector<KeyEntry> key;
  for (const NodeSet& set : sets) {
    KeyEntry entry{set.name, "set " + set.name};
    const auto add = [&](const char* symbol, const char* path) {
      if (const auto number = estimate_at(*set.of, path); std::isfinite(number.value))
        entry.numbers.push_back(said(symbol, number));
    };
    if (own) add("s", "/tail/slope"), add("q", "/q_gaussian/q");
    else if (set.name != "all") add("mean", "/mean_over_sample_mean");
    if (!own) add("var", "/variance");
    key.push_back(std::move(entry));
  }
  if (own) {
    key.push_back({"q-Gaussian", "strong", {}, Line::dotted});
    key.push_back({"exp(\u2212s\u2009x)", "strong", {}, Line::dashed});
  }
  return key;
}

/// Densities of every component over the sample's mean or r.m.s. and over each phase's own (P Figs. 9, 13, 14).
Drawings stress_densities(const FieldData& data) {
  Drawings drawings;
  for (const auto& [component, name, symbol] : {std::tuple{"yy", "sigma_yy", "\u03c3_{yy}"},
                                                {"xx", "sigma_xx", "\u03c3_{xx}"},
                                                {"xy", "sigma_xy", "\u03c3_{xy}"},
                                                {"zz", "sigma_zz", "\u03c3_{zz}"},
                                                {"xz", "sigma_xz", "\u03c3_{xz}"},
                                                {"hydrostatic", "sigma_hyd", "\u03c3_{hyd}"}}) {
    const auto of = data.densities.find(name);
    if (of == data.densities.end() || !of->is_tree()) continue;
    const bool over_mean = of->value("normalised_by", "mean") == "mean";
    for (const bool own : {false, true}) {
      const auto sets = node_sets(*of, own);
      if (sets.empty()) continue;
      const std::string over =
          over_mean ? std::string("\u27e8") + symbol + "\u27e9" + (own ? " of the phase" : "") : "r.m.s.";
      Drawing drawing{.chosen = {{"component", component}, {"norm", own ? "own" : "sample"}}};
      for (const bool logarithmic : {false, true})
        drawing.panels.push_back(density_panel(sets, std::string(symbol) + " / " + over, logarithmic, own));
      drawing.key = density_key(sets, own);
      drawings.push_back(std::move(drawing));
    }
  }
  return drawings;
}

/// Volumes of single pores and voids over that of a large grain, with counting errors.
Drawings cavities(const FieldData& data) {
  Drawing drawing;
  Panel panel;
  double low = 1e300, high = 0, least = 1e300, most = 0;
  bool any = false;
  for (const auto& [kind, colour] : {std::pair{"pores", "material 0"}, {"voids", "material 1"}}) {
    const auto of = data.numbers.find(kind);
    if (of == data.numbers.end()) continue;
    const auto edge = reals_at(*of, "/pdf/edge"), density = reals_at(*of, "/pdf/density"),
               error = reals_at(*of, "/pdf/error");
    Series series{.name = kind, .colour = colour, .line = Line::solid, .points = true, .weight = 0.9};
    for (std::size_t k = 0; k < density.size(); ++k) {
      const double x = std::sqrt(edge[k] * edge[k + 1]);
      if (!(density[k] > 0 && x > 0)) continue;
      series.x.push_back(x), series.y.push_back(density[k]), series.error.push_back(error[k]);
      low = std::min(low, edge[k]), high = std::max(high, edge[k + 1]);
      least = std::min(least, density[k]), most = std::max(most, density[k]);
    }
    any = any || series.x.size() > 2;
    if (density.empty()) continue;
    KeyEntry entry{std::string(kind) + " " + counted(estimate_at(*of, "/count").value), colour};
    for (const auto& [symbol, path] : {std::pair{"mean", "/mean"}, {"c.v.", "/cv"}})
      if (const double value = estimate_at(*of, path).value; std::isfinite(value))
        entry.numbers.push_back(said(symbol, {value}));
    drawing.key.push_back(std::move(entry));
    panel.series.push_back(std::move(series));
  }
  if (!any) return {};
  panel.x = {.label = "V / (\u03c0 r_{L}\u00b2)", .logarithmic = true, .low = low, .high = high};
  panel.y = decades_about("probability density", least, most);
  panel.y.brief = "density";
  drawing.panels = {panel};
  return {drawing};
}

Drawings convergence(const FieldData& data) {
  const auto* residual = data.convergence.find("residual");
  if (!residual || residual->size() < 2) return {};
  const auto* iteration = data.convergence.find("iteration");
  Series series{.colour = "material 0", .y = *residual, .line = Line::solid, .points = residual->size() < 200};
  for (std::size_t k = 0; k < residual->size(); ++k)
    series.x.push_back(iteration ? (*iteration)[k] : static_cast<double>(k));
  for (double& value : series.y)
    if (!(value > 0)) value = statistics::unknown;
  const double most = largest_of(series.y, 0), least = least_above_zero(series.y, most);
  if (!(most > 0)) return {};
  return {{.panels = {{{.label = "iteration"}, decades_about("residual", least, most), {series}}}}};
}

/// What densities of these components are called and say.
Head densities_of(std::vector<Option> components) {
  return {"stress-pdf",
          "stress-pdf",
          "Stress of nodes by phase",
          {"Probability density of the component shown in the picture, over the mean of the sample or of the phase, "
           "without the clamped rows.",
           "Over the mean of the phase: dotted (left), q-Gaussian fits; dashed (right), tails exp(\u2212s\u2009x) by "
           "maximum likelihood where the density falls from 0.1 to 0.001 of its peak."},
          true,
          {{"component", "", std::move(components), Choice::Print::files, false},
           {"norm", "Over the mean of", {{"sample", "the sample"}, {"own", "the phase"}}}}};
}

Head solver_head() {
  return {"convergence", "convergence", "Convergence of the solver",
          "Residual relative to that of uniform strain, after every iteration."};
}

}  // namespace

const std::vector<Row<FieldData>>& field_figures() {
  static const std::vector<Row<FieldData>> list{
      {{"stress-strain",
        "stress-strain",
        "Stress and strain",
        {"Mean stress of the loaded row against strain, one point before each round of breaking.",
         "Dot: the step shown in the picture. A click on the curve selects a step."}},
       stress_strain},
      {{"broken-bonds", "broken-bonds", "Broken bonds",
        "Number of broken bonds by type over the steps of the test; vertical line: the step shown."},
       broken_bonds},
      {{"energy-balance",
        "energy-balance",
        "Energy balance of the test",
        {"Energies per unit thickness, against strain.",
         "The work of the clamp is stored in bonds (elastic) or released when they break. Line: work; areas: its "
         "parts."}},
       energy_balance},
      {densities_of({{"yy", "\u03c3_{yy}"},
                     {"xx", "\u03c3_{xx}", "xx"},
                     {"xy", "\u03c3_{xy}", "xy"},
                     {"hydrostatic", "\u03c3_{hyd}", "hyd"}}),
       stress_densities},
      {{"cavities",
        "cavities",
        "Single pores and voids",
        {"Probability density of the volumes of single pores (not grain) and single voids (neither grain nor matrix), "
         "over that of a large grain of nominal radius (reference radius in the table), with counting errors.",
         "The table states which volumes at the edge and which specks of the grid are left out."}},
       cavities},
      {solver_head(), convergence}};
  return list;
}

const std::vector<Row<FieldData>>& voxel_figures() {
  static const std::vector<Row<FieldData>> list{
      {{"stress-strain", "stress-strain", "Stress and strain",
        "Mean stress of the loaded layer against strain, one point before each round of breaking."},
       stress_strain},
      {{"broken-bonds", "broken-bonds", "Broken bonds", "Number of broken bonds by type over the steps of the test."},
       broken_bonds},
      {{"energy-balance", "energy-balance", "Energy balance of the test",
        "The work of the clamp is stored in bonds (elastic) or released when they break. Line: work; areas: its "
        "parts."},
       energy_balance},
      {densities_of({{"zz", "\u03c3_{zz}"}, {"xz", "\u03c3_{xz}", "xz"}}), stress_densities},
      {solver_head(), convergence}};
  return list;
}

}  // namespace arenite::report::figures
