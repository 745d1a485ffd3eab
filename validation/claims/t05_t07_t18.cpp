#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/ranks.hpp"
#include "validation/claims/chapter3.hpp"
#include "validation/claims/claims.hpp"
#include "validation/claims/thesis_choices.hpp"
#include "validation/final_texture.hpp"
#include "validation/pooled.hpp"
#include "validation/trends.hpp"
#include "validation/wall_layers.hpp"

namespace arenite::validation {
namespace {

/// The value that 5 % of a material's grains are pressed harder than, Pa.
double top_5_percent(const FinalState& state, const std::string& material) {
  std::vector<double> pressure;
  const Grains& grains = state.packing.grains;
  for (std::size_t k = 0; k < grains.size(); ++k)
    if (state.texture.per_grain.considered[k] &&
        state.packing.materials[static_cast<std::size_t>(grains.material[k])].name == material)
      pressure.push_back(-state.texture.per_grain.sigma_hyd[k]);
  if (pressure.size() < 20) return statistics::unknown;
  return of_rank_in_place(pressure, pressure.size() - 1 - pressure.size() / 20);
}

double ratio_of_means(const Run& run) {
  return run("force.by_type.POM-POM.mean_N") / run("force.by_type.HDPE-HDPE.mean_N") - 1;
}

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
  const std::size_t n = rev.share.size();
  std::size_t first = n, last = n;
  for (std::size_t k = 0; k < n; ++k) {
    if (first == n && rev.share[k] >= 0.2) first = k;
    if (rev.share[k] <= 0.9) last = k;
  }
  return last == n ? std::pair{n, n} : std::pair{first, last};
}

/// Of each window between 20 and 90 % of the area its solid fraction over the mean of all of them, minus 1, over
/// samples. `curves`: of every sample its means over places, window by window.
Family departures(const std::vector<std::vector<double>>& curves) {
  Family family;
  if (curves.empty()) return family;
  for (std::size_t window = 0; window < curves.front().size(); ++window) {
    std::vector<double> own;
    for (const auto& curve : curves) own.push_back(curve[window] / statistics::mean_of(curve).value - 1);
    family.push_back({fmt::format("window {}", window + 1), statistics::mean_of(own)});
  }
  return family;
}

Value mean_value(const std::vector<double>& values) { return values.empty() ? Value() : statistics::mean_of(values); }

/// Solid fraction at 90 % of the area over that at 20 %, minus 1.
double change_over_plateau(const Run& run) {
  const FinalState state = final_state(run, true);
  const auto [first, last] = plateau_of(state.texture.rev);
  return first < last ? state.texture.rev.mean[last] / state.texture.rev.mean[first] - 1 : statistics::unknown;
}

/// Settled: no further from each other than this part.
constexpr double plateau = 0.01;

}  // namespace

/// Fraction of grains above the mean; what table 3.2 has measured of it in the laboratory stands beside, and
/// contradicts its sentence.
Judgement judge_t5(const Results& results) {
  Judgement judgement;
  Family all, single, measured;
  for (const auto& [sample, percent] : {std::pair{sample_2, std::array{47.4, 50.2, 50.9}},
                                        {sample_8, std::array{46.3, 47.2, 45.1}},
                                        {sample_12, std::array{45.6, 50.9, 44.3}}}) {
    const auto runs = runs_of(results, sample);
    const std::vector<Draw> draws{{"thesis-ch3", where(sample)}};
    all.push_back({sample.name, mean_over_seeds(runs, "sigma_norm.P0"), draws});
    measured.push_back({fmt::format("{} all", sample.name), {percent[0] / 100, 0}});
    for (const auto& [k, material] : {std::pair{1u, "POM"}, {2u, "HDPE"}}) {
      single.push_back({fmt::format("{} {}", sample.name, material),
                        mean_over_seeds(runs, fmt::format("sigma_norm.by_material.{}.P0", material)), draws});
      measured.push_back({single.back().name, {percent[k] / 100, 0}});
    }
  }
  judgement.checks = {
      every("fraction above the mean, all grains", "< 0.5", all, {.high = 0.5}),
      every("fraction above the mean, each material", "<= 0.52 (table 3.2: 0.443 to 0.509)", single, {.high = 0.52}),
      as(Kind::source,
         every("fraction above the mean as printed in table 3.2", "fewer than half", measured, {.high = 0.5}))};
  for (const Member& m : all)
    if (std::isfinite(m.value.value))
      judgement.ours += fmt::format("{}{} {}", judgement.ours.empty() ? "" : ", ", m.name, text_of(m.value));
  judgement.decides =
      "Table 3.2 itself prints 50.2 and 50.9 % for POM and HDPE of #2 and 50.9 % for POM of #12, whereas the text says "
      "fewer than half.";
  if (const auto filled = results.runs("thesis-ch3-random"); !filled.empty())
    judgement.findings.push_back(
        fmt::format("For HDPE of #2 the fraction is {} from the lattice and {} from random fillings.",
                    text_of(single[1].value), text_of(mean_over_seeds(filled, "sigma_norm.by_material.HDPE.P0"))));
  add_choices(judgement, results, "Fraction of #8's grains above the mean", sample_8, "sigma_norm.P0",
              wanted_below(0.5));
  add_choices(judgement, results, "Fraction of #2's HDPE grains above their mean", sample_2,
              "sigma_norm.by_material.HDPE.P0", wanted_below(0.52));
  return judgement;
}

/// Stress of small HDPE grains against large POM ones, and mean forces, in #12.
Judgement judge_t7(const Results& results) {
  Judgement judgement;
  const auto runs = runs_of(results, sample_12);
  const Value force = mean_over_seeds(runs, ratio_of_means), most = lead(runs, maximum("HDPE"), maximum("POM"));
  std::vector<double> leads;
  for (const Run& run : runs) {
    const FinalState state = final_state(run);
    leads.push_back(top_5_percent(state, "HDPE") / top_5_percent(state, "POM") - 1);
  }
  judgement.checks = {positive("largest grain stress of HDPE over POM, minus 1", "> 0", most),
                      positive("95 % quantile of grain stress, HDPE over POM, minus 1", "> 0", mean_value(leads)),
                      positive("mean force of POM-POM over HDPE-HDPE, minus 1", "> 0", force)};
  for (Check& check : judgement.checks) check.draws = {{"thesis-ch3", where(sample_12)}};
  if (!runs.empty())
    judgement.ours = fmt::format("relative excess of the largest stress in HDPE {}, of the mean force in POM-POM {}",
                                 text_of(most), text_of(force));
  add_choices(judgement, results, "Mean force of #12's POM-POM over HDPE-HDPE, minus 1", sample_12, ratio_of_means,
              wanted_positive());
  add_choices(
      judgement, results, "Largest grain stress of #12's HDPE over POM, minus 1", sample_12,
      [](const Run& run) { return maximum("HDPE").of(run) / maximum("POM").of(run) - 1; }, wanted_positive());
  return judgement;
}

/// Windows of growing size in #11, means over their places; errors from the scatter of samples, since the windows of
/// one overlap.
Judgement judge_t18(const Results& results) {
  Judgement judgement;
  std::vector<double> changes, fractions, within, at_walls, by_wide_layers, by_thin_layers, inner_changes;
  std::vector<std::vector<double>> curves;
  for (const Run& run : runs_of(results, sample_11)) {
    const FinalState state = final_state(run, true);
    const auto& rev = state.texture.rev;
    const auto [first, last] = plateau_of(rev);
    if (first >= last) continue;
    changes.push_back(rev.mean[last] / rev.mean[first] - 1);
    fractions.push_back(rev.mean[last]);
    curves.emplace_back(rev.mean.begin() + static_cast<std::ptrdiff_t>(first),
                        rev.mean.begin() + static_cast<std::ptrdiff_t>(last) + 1);
    const WallLayers wide = wall_layers(state, 2.5), thin = wall_layers(state, 0.5);
    within.push_back(wide.within);
    at_walls.push_back(wide.at_walls);
    by_wide_layers.push_back(wide.of_windows(rev.share[last]) / wide.of_windows(rev.share[first]) - 1);
    by_thin_layers.push_back(thin.of_windows(rev.share[last]) / thin.of_windows(rev.share[first]) - 1);
    const texture::Rev inner = rev_within(state);
    inner_changes.push_back(inner.mean[last] / inner.mean[first] - 1);
  }
  judgement.checks = {equivalent("solid fraction at 90 % of the area over that at 20 %, minus 1, #11", "constant",
                                 mean_value(changes), plateau),
                      every("solid fraction of windows between 20 and 90 % over their mean, minus 1, #11", "constant",
                            departures(curves), {-plateau, plateau})};
  for (Check& check : judgement.checks) check.draws = {{"thesis-ch3", where(sample_11)}};
  for (const auto& [what, values] :
       {std::pair{"solid fraction in a strip of 2.5 mean diameters along the walls, #11", &at_walls},
        {"solid fraction inside this strip, #11", &within},
        {"change from 20 to 90 % if the whole deficit is in the outermost half diameter, #11", &by_thin_layers},
        {"change from 20 to 90 % if the deficit is uniform over the strip, #11", &by_wide_layers},
        {"change from 20 to 90 % for windows that avoid the strip, #11", &inner_changes}})
    judgement.checks.push_back(reported(what, mean_value(*values)));
  if (!changes.empty()) {
    judgement.ours = fmt::format("relative change {} of a solid fraction of {}", text_of(mean_value(changes)),
                                 text_of(mean_value(fractions)));
    judgement.decides = fmt::format(
        "The margin is 1 %. The remaining change is due to the looser layers along the walls, which all large windows "
        "contain; for windows that avoid them it is {}.",
        text_of(mean_value(inner_changes)));
  }
  add_choices(judgement, results, "Solid fraction of #11 at 90 % of the area over that at 20 %, minus 1", sample_11,
              change_over_plateau, wanted_equivalent(plateau));
  return judgement;
}

}  // namespace arenite::validation
