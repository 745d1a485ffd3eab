#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "ledger/claims/chapter3.hpp"
#include "ledger/claims/claims.hpp"
#include "ledger/claims/thesis_choices.hpp"
#include "ledger/final_texture.hpp"
#include "ledger/pooled.hpp"
#include "ledger/wall_layers.hpp"

namespace arenite::ledger {
namespace {

/// The value that 5 % of a material's grains are pressed harder than, Pa.
double top_5_percent(const FinalState& state, const std::string& material) {
  std::vector<double> pressure;
  const Grains& grains = state.packing.grains;
  for (std::size_t k = 0; k < grains.size(); ++k)
    if (state.texture.per_grain.considered[k] && state.packing.materials[static_cast<std::size_t>(grains.material[k])].name == material)
      pressure.push_back(-state.texture.per_grain.sigma_hyd[k]);
  if (pressure.size() < 20) return statistics::unknown;
  std::sort(pressure.begin(), pressure.end());
  return pressure[pressure.size() - 1 - pressure.size() / 20];
}

double ratio_of_means(const Run& run) { return run("force.by_type.POM-POM.mean_N") / run("force.by_type.HDPE-HDPE.mean_N") - 1; }

Number maximum(const std::string& material) {
  const std::string name = "sigma_norm.by_material." + material;
  return [name](const Run& run) { return std::abs(run(name + ".maximum") * run(name + ".mean_Pa")); };
}

/// Numbers a against b in every run: mean of a/b - 1.
Value lead(const std::vector<Run>& runs, const Number& a, const Number& b) {
  return mean_over_seeds(runs, [&](const Run& run) { return a.of(run) / b.of(run) - 1; });
}

/// The least window of at least 20 % of the area and the greatest of at most 90 %; equal if there are none.
std::pair<std::size_t, std::size_t> plateau_of(const texture::Rev& rev) {
  const std::size_t n = rev.area_share.size();
  std::size_t first = n, last = n;
  for (std::size_t k = 0; k < n; ++k) {
    if (first == n && rev.area_share[k] >= 0.2) first = k;
    if (rev.area_share[k] <= 0.9) last = k;
  }
  return last == n ? std::pair{n, n} : std::pair{first, last};
}

/// Of windows between 20 and 90 % of the area, those whose solid fraction departs most from the mean of all, in its standard errors
/// over samples. `curves`: of every sample its means over places, window by window.
struct Departure {
  std::size_t window = 0;
  Value value;
};
Departure greatest_departure(const std::vector<std::vector<double>>& curves) {
  Departure greatest;
  if (curves.size() < 2) return greatest;
  for (std::size_t window = 0; window < curves.front().size(); ++window) {
    std::vector<double> departures;
    for (const auto& curve : curves) departures.push_back(curve[window] - statistics::mean_of(curve).value);
    const Value here(statistics::mean_of(departures));
    if (!(std::abs(here.value) / here.error <= std::abs(greatest.value.value) / greatest.value.error)) greatest = {window, here};
  }
  return greatest;
}

}  // namespace

/// Share of grains above the mean; what table 3.2 has measured of it in the laboratory stands beside.
Judgement judge_t5(const Results& results) {
  Judgement judgement;
  for (const auto& [sample, measured] : {std::pair{sample_2, std::array{47.4, 50.2, 50.9}}, {sample_8, std::array{46.3, 47.2, 45.1}}, {sample_12, std::array{45.6, 50.9, 44.3}}})
    for (const auto& [material, percent] : {std::pair{"", measured[0]}, {"POM", measured[1]}, {"HDPE", measured[2]}}) {
      const bool all = *material == 0;
      const std::string source = fmt::format("< 0.5, measured {:.3f}", percent / 100);
      const std::string number = all ? "sigma_norm.P0" : fmt::format("sigma_norm.by_material.{}.P0", material);
      const Value share = mean(results, "thesis-ch3", number, where(sample));
      const std::string what = fmt::format("share above the mean, {} {}", sample.name, all ? "all" : material);
      judgement.stated.checks.push_back(below(what, source, share, 0.5));
      Check sharpened = all ? below(what, source, share, 0.5) : between(what, source, share, 0, 0.52);
      if (runs_of(results, sample).size() < 5) sharpened.holds = Holds::unknown;
      judgement.sharpened.checks.push_back(sharpened);
    }
  add_choices(judgement, results, "Share of #8's grains above the mean", sample_8, "sigma_norm.P0", wanted_below(0.5));
  add_choices(judgement, results, "Share of #2's HDPE grains above their mean", sample_2, "sigma_norm.by_material.HDPE.P0", wanted_below(0.52));
  add_choices(judgement, results, "beta of #2's HDPE grains", sample_2, "sigma_norm.by_material.HDPE.beta");
  return judgement;
}

/// Stress of small HDPE grains against large POM ones, and mean forces, in #12.
Judgement judge_t7(const Results& results) {
  Judgement judgement;
  const auto runs = runs_of(results, sample_12);
  const Check force = positive("mean force of POM-POM over HDPE-HDPE, less 1", "> 0", mean_over_seeds(runs, ratio_of_means));
  const Check most = positive("largest grain stress of HDPE over POM, less 1", "> 0", lead(runs, maximum("HDPE"), maximum("POM")));
  std::vector<double> leads;
  for (const Run& run : runs) {
    const FinalState state = final_state(run);
    leads.push_back(top_5_percent(state, "HDPE") / top_5_percent(state, "POM") - 1);
  }
  judgement.stated.checks = {most, force};
  judgement.sharpened.checks = {most, positive("stress that 5 % of grains exceed, HDPE over POM, less 1", "> 0", leads.empty() ? Value() : Value(statistics::mean_of(leads))), force};
  add_choices(judgement, results, "Mean force of #12's POM-POM over HDPE-HDPE, less 1", sample_12, ratio_of_means, wanted_positive());
  add_choices(judgement, results, "Largest grain stress of #12's HDPE over POM, less 1", sample_12, [](const Run& run) { return maximum("HDPE").of(run) / maximum("POM").of(run) - 1; }, wanted_positive());
  return judgement;
}

/// Windows of growing size in #11: in each sample by its own windows' error, and over samples.
Judgement judge_t18(const Results& results) {
  Judgement judgement;
  std::vector<double> changes, in_errors, within, at_walls, by_wide_layers, by_thin_layers, inner_changes;
  double fraction = 0;
  std::vector<std::vector<double>> curves;
  for (const Run& run : runs_of(results, sample_11)) {
    const FinalState state = final_state(run, true);
    const auto& rev = state.texture.rev;
    const auto [first, last] = plateau_of(rev);
    if (first >= last) continue;
    changes.push_back(rev.mean[last] - rev.mean[first]);
    in_errors.push_back(std::abs(changes.back()) / std::hypot(rev.error[first], rev.error[last]));
    fraction += rev.mean[last];
    curves.emplace_back(rev.mean.begin() + static_cast<std::ptrdiff_t>(first), rev.mean.begin() + static_cast<std::ptrdiff_t>(last) + 1);
    const WallLayers wide = wall_layers(state, 2.5), thin = wall_layers(state, 0.5);
    within.push_back(wide.within);
    at_walls.push_back(wide.at_walls);
    by_wide_layers.push_back(wide.of_windows(rev.area_share[last]) - wide.of_windows(rev.area_share[first]));
    by_thin_layers.push_back(thin.of_windows(rev.area_share[last]) - thin.of_windows(rev.area_share[first]));
    const texture::Rev inner = rev_within(state);
    inner_changes.push_back(inner.mean[last] - inner.mean[first]);
  }
  const auto mean_value = [](const std::vector<double>& values) { return values.empty() ? Value() : Value(statistics::mean_of(values)); };
  judgement.stated.checks = {below("change of the solid fraction between 20 and 90 % of the area over its error in one sample, #11", "a plateau", mean_value(in_errors), beyond)};
  judgement.sharpened.checks = {none("solid fraction at 90 % of the area less that at 20 %, over samples, #11", "a plateau", mean_value(changes)),
                                none("greatest departure of a window between 20 and 90 % from the mean of all of these, over samples, #11", "a plateau", greatest_departure(curves).value)};
  if (!changes.empty())
    judgement.findings.push_back(fmt::format("Solid fraction of #11 in windows of 90 % of the area: {:.4f}; in windows of 20 % it is {:.4f} more: large windows all hold the looser "
                                             "layers along the walls.", fraction / static_cast<double>(changes.size()), -mean_value(changes).value));
  if (!changes.empty())
    judgement.findings.push_back(fmt::format("In a strip of 2.5 mean diameters along the walls of #11 the solid fraction is {}, within it {}. That alone gives a change between 20 and 90 % "
                                             "of the area of {} if all that is missing lies in the outermost half diameter, of {} if it is even over the strip; it is {}. Windows that stay "
                                             "out of the strip change by {}.",
                                             text_of(mean_value(at_walls)), text_of(mean_value(within)), text_of(mean_value(by_thin_layers)), text_of(mean_value(by_wide_layers)), text_of(mean_value(changes)),
                                             text_of(mean_value(inner_changes))));
  add_choices(judgement, results, "Solid fraction of #11 at 90 % of the area less that at 20 %", sample_11, [](const Run& run) {
    const FinalState state = final_state(run, true);
    const auto [first, last] = plateau_of(state.texture.rev);
    return first < last ? state.texture.rev.mean[last] - state.texture.rev.mean[first] : statistics::unknown;
  }, wanted_none());
  return judgement;
}

}  // namespace arenite::ledger
