#pragma once
#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/packing.hpp"
#include "model/result.hpp"
#include "recipe/recipe.hpp"
#include "solid/elements/stiffness_numbers.hpp"
#include "solid/peridynamics/damage.hpp"
#include "solid/peridynamics/failure_state.hpp"
#include "solid/stress/stress.hpp"
#include "workflow/run.hpp"

namespace arenite::workflow {

/// How a test to failure is kept on its way and where it goes on from; other loads take no notice.
template <int D> struct FailureCheckpointIn {
  peridynamics::KeepFailureIn<D> keep{};
  std::optional<peridynamics::FailureStateIn<D>> resume{};
};
using FailureCheckpoint = FailureCheckpointIn<2>;

/// The test to failure that a load asks for.
template <int D>
peridynamics::DamageOptionsIn<D> damage_options(const recipe::Load& load, const statics::Watch& watch,
                                                const FailureCheckpointIn<D>& checkpoint) {
  peridynamics::DamageOptionsIn<D> options{
      load, load, load.stiffness.resolved(), watch, load.toughness.resolved(), load.strength.resolved()};
  options.keep = checkpoint.keep;
  if (checkpoint.resume) options.resume = &*checkpoint.resume;
  return options;
}

/// What every result of a test to failure begins with: how it ended, and its curve.
void put_outcome(ResultHead& result, History& curve, const peridynamics::DamageOutcome& tested,
                 const char* energy_unit);

/// What of a load's progress is whose: one solve of the load itself, three of its moduli between clamps, and one for
/// each strain of its effective stiffness.
class SolveShares {
 public:
  SolveShares(const recipe::Load& load, std::size_t strains, const statics::Watch& watch)
      : watch_(watch),
        moduli_(1 + (load.moduli ? 3.0 : 0.0)),
        all_(moduli_ + (load.effective_stiffness && load.by_elements() ? static_cast<double>(strains) : 0.0)) {}
  statics::Watch of_load() const { return statics::of_part(watch_, 0.0, 1 / all_); }
  statics::Watch of_moduli() const { return statics::of_part(watch_, 1 / all_, moduli_ / all_); }
  statics::Watch of_stiffness() const { return statics::of_part(watch_, moduli_ / all_, 1.0); }

 private:
  const statics::Watch& watch_;
  double moduli_, all_;  ///< solves until moduli are known, and in all
};

/// Stress of every grain that a sample's map labels, from the contact forces of its packing, Pa, in the order of the
/// labels; empty without. `known` are those of all grains of the packing that was cemented, where a texture has them
/// (with bonds and cohesion, which the sample leaves out).
std::vector<Tensor2> contact_stresses(const FieldResult& sample, const Packing& cemented = {},
                                      const std::vector<Tensor2>& known = {});

/// Loads a cemented sample. An unfinished field has `converged` false and says why; nothing if the watch stopped it.
/// The numbers have the statistics of the load's own component of stress; those of all are in `measured`, if that is
/// given. Stresses of grains are compared with the sample's `contact_stresses`, which are measured here unless they are
/// given.
std::optional<FieldResult> apply_load(const recipe::Load& load, const FieldResult& sample,
                                      const peridynamics::Watch& watch, const FailureCheckpoint& checkpoint = {},
                                      std::optional<stress::Statistics>* measured = nullptr,
                                      const std::vector<Tensor2>* contact_stresses = nullptr);

/// Notes in a load's result by which strains a further number of it could not be found.
void note_unsolved(ResultHead& result, std::string_view number, const std::vector<std::string>& strains);

/// Of the uniform strains those without an answer: "xx", "yz".
template <int D> std::vector<std::string> unsolved_strains(const elements::EffectiveStiffness<D>& found) {
  std::vector<std::string> names;
  for (std::size_t k = 0; k < found.solves.size(); ++k) {
    const auto [a, b] = voigt_axes<D>[k];
    if (!found.solves[k].converged) names.push_back({"xyz"[a], "xyz"[b]});
  }
  return names;
}

/// Adds to a loaded sample's numbers its effective stiffness as a period (docs/elements.md), which needs no clamps and
/// is found whatever the load came to; false if it was stopped.
template <class Map, class Result>
bool add_effective_stiffness(const Map& map, const elements::SolveOptions& how, Result& result) {
  const auto effective = elements::effective_stiffness(map, how);
  if (std::ranges::any_of(effective.solves, &statics::StaticReport::stopped)) return false;
  note_unsolved(result, "effective stiffness", unsolved_strains(effective));
  result.numbers["effective_stiffness"] = elements::stiffness_numbers(effective);
  return true;
}

struct MapOutcome {
  std::optional<FieldResult> field;  ///< nothing if it was stopped
  std::filesystem::path file;        ///< empty where nothing is stored
  KnownStatistics measured;
};

/// Loads such a map as apply_load does a cemented sample. The field is one file in `options.out`, taken from there if
/// it was computed before; without that folder nothing is stored. Throws InputError for what cannot be read as a phase
/// map.
MapOutcome load_map(const recipe::MapSection& map, const recipe::Load& load, const RunOptions& options);

}  // namespace arenite::workflow
