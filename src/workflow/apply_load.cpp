#include "workflow/apply_load.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/problems.hpp"
#include "core/text.hpp"
#include "core/version.hpp"
#include "grains/texture/stress.hpp"
#include "grains/texture/texture.hpp"
#include "io/results/results.hpp"
#include "solid/elements/load.hpp"
#include "solid/grid/crop.hpp"
#include "solid/peridynamics/cracks.hpp"
#include "solid/stress/grains.hpp"
#include "solid/stress/selection.hpp"
#include "solid/stress/stress.hpp"
#include "workflow/field_numbers.hpp"
#include "workflow/read_map.hpp"
#include "workflow/runner.hpp"

namespace arenite::workflow {

namespace fs = std::filesystem;

namespace {

/// The sample with its axis of loading upright.
FieldResult upright(const FieldResult& sample, recipe::Load::Axis axis) {
  FieldResult result = sample;
  if (axis == recipe::Load::Axis::y) return result;
  result.map = transposed(sample.map);
  result.packing = grid::transposed(sample.packing);
  return result;
}

/// As a file holds it, in single precision, so that statistics are the same before and after.
StressField as_stored(StressField field) {
  for (auto* values : {&field.ux, &field.uy, &field.xx, &field.yy, &field.xy})
    for (double& value : *values) value = static_cast<double>(static_cast<float>(value));
  return field;
}

void measure_stress(const recipe::Load& load, FieldResult& result, std::optional<stress::Statistics>* measured,
                    const std::vector<Tensor2>* known) {
  if (result.field.size() == 0) return;
  stress::StressOptions options = load.statistics;
  if (load.loading == peridynamics::Loading::shear) options.components = {stress::Component::xy};
  const auto own = options.components;
  if (measured) options.components.assign(std::begin(stress::all_components), std::end(stress::all_components));
  try {
    auto statistics = stress::measure(result.map, result.field, options);
    result.numbers["stress"] = stress::numbers(statistics, false, own);
    std::vector<Tensor2> contacts = known ? *known : contact_stresses(result);
    if (known && load.axis == recipe::Load::Axis::x)
      for (Tensor2& t : contacts) t = {t.yy, t.yx, t.xy, t.xx};
    if (contacts.size() == result.map.grain_class.size() && load.loading != peridynamics::Loading::shear)
      if (Numbers agreement = stress::compare(result.map, statistics.grains, contacts); !agreement.empty())
        result.numbers["grain_stress_against_contacts"] = std::move(agreement);
    if (measured) *measured = std::move(statistics);
  } catch (const InputError& error) {
    result.numbers["notes"].push_back(fmt::format("no statistics of stress: {}", error.what()));
  }
}

std::optional<FieldResult> load_until_failure(const recipe::Load& load, FieldResult result,
                                              const peridynamics::Watch& watch, const FailureCheckpoint& checkpoint) {
  auto tested = peridynamics::load_to_failure(result.map, damage_options<2>(load, watch, checkpoint));
  if (tested.ending == peridynamics::DamageOutcome::Ending::stopped) return std::nullopt;
  put_outcome(result, result.curve, tested, "J/m");
  result.cracks = peridynamics::cracks_of(tested.broken, result.map.dx);
  add_failure<2>(result.numbers, as_asked(load), load, tested, result.map.dx);
  note_bonds_across_voids(result.numbers, load, result.map);
  result.field = as_stored(std::move(tested.at_strength));
  return result;
}

/// Bonds or elements.
class Loader {
 public:
  Loader(const recipe::Load& load, const statics::Watch& watch)
      : by_elements_(load.by_elements()),
        bonds_{load, load, load.stiffness.resolved(), watch},
        elements_{{.tolerance = load.tolerance,
                   .max_iterations = load.max_iterations,
                   .material = load.material(),
                   .watch = watch},
                  load.loading,
                  load.lower,
                  load.strain} {
    bonds_.method = load.bond_method();
  }
  statics::LoadResult load(const PhaseMap& map) const {
    return by_elements_ ? elements::load(map, elements_) : peridynamics::load(map, bonds_);
  }
  statics::EffectiveModuli effective_moduli(const PhaseMap& map) const {
    return by_elements_ ? elements::effective_moduli(map, elements_) : peridynamics::effective_moduli(map, bonds_);
  }
  const elements::SolveOptions& of_elements() const { return elements_; }

 private:
  bool by_elements_;
  peridynamics::LoadOptions bonds_;
  elements::LoadOptions elements_;
};

/// The apparent moduli of the sample, whichever way it is loaded; nothing if they were stopped.
std::optional<statics::EffectiveModuli> find_moduli(const Loader& loader, const PhaseMap& map, FieldResult& result) {
  statics::EffectiveModuli moduli = loader.effective_moduli(map);
  static constexpr const char* strains[] = {"tension along x", "tension along y", "shear"};
  std::vector<std::string> unsolved;
  for (std::size_t k = 0; k < moduli.reports.size(); ++k) {
    const statics::LoadReport& report = moduli.reports[k];
    if (report.ending == statics::Ending::stopped) return {};
    if (report.ending != statics::Ending::solved)
      unsolved.push_back(fmt::format("{} ({})", strains[k], report.sentence));
  }
  note_unsolved(result, "apparent moduli", unsolved);
  return moduli;
}

}  // namespace

void put_outcome(ResultHead& result, History& curve, const peridynamics::DamageOutcome& tested,
                 const char* energy_unit) {
  using Ending = peridynamics::DamageOutcome::Ending;
  result.converged =
      tested.ending == Ending::severed || tested.ending == Ending::dropped || tested.ending == Ending::strain_reached;
  result.outcome = tested.sentence;
  curve = {{{"strain", "1", {}},
            {"stress", "Pa", {}},
            {"work", energy_unit, {}},
            {"elastic", energy_unit, {}},
            {"released", energy_unit, {}},
            {"broken", "1", {}}}};
  for (const peridynamics::DamageState& s : tested.curve) {
    const double row[] = {s.strain, s.stress, s.work, s.elastic, s.released, static_cast<double>(s.broken)};
    for (std::size_t c = 0; c < curve.columns.size(); ++c) curve.columns[c].values.push_back(row[c]);
  }
}

void note_unsolved(ResultHead& result, std::string_view number, const std::vector<std::string>& strains) {
  if (strains.empty()) return;
  result.converged = false;
  result.outcome += fmt::format("; {}: not found under {}", number, list_of(strains, " and "));
}

std::vector<Tensor2> contact_stresses(const FieldResult& sample, const Packing& cemented,
                                      const std::vector<Tensor2>& known) {
  const Packing& packing = sample.packing;
  if (packing.contacts.size() == 0 || !(packing.domain.thickness > 0)) return {};
  std::vector<Tensor2> sigma;
  if (known.empty() || !cemented.bonds.empty() || !cemented.cohesive.empty()) {
    sigma = texture::grain_stresses(packing);
  } else {
    std::unordered_map<std::int64_t, std::size_t> place;
    for (std::size_t g = 0; g < known.size(); ++g) place.emplace(cemented.grains.id[g], g);
    for (const std::int64_t id : packing.grains.id) sigma.push_back(known[place.at(id)]);
  }
  sigma.resize(std::min(sigma.size(), sample.map.grain_class.size()));
  return sigma;
}

std::optional<FieldResult> apply_load(const recipe::Load& load, const FieldResult& sample,
                                      const peridynamics::Watch& watch, const FailureCheckpoint& checkpoint,
                                      std::optional<stress::Statistics>* measured,
                                      const std::vector<Tensor2>* contact_stresses) {
  FieldResult result = upright(sample, load.axis);
  // A map that is too narrow for bonds is refused for that.
  if (result.map.height > 2 * peridynamics::horizon) stress::check_clamp_rows(result.map, load.statistics.clamp_rows);
  result.name = load.name;
  if (load.failure) {
    auto tested = load_until_failure(load, std::move(result), watch, checkpoint);
    if (tested) measure_stress(load, *tested, measured, contact_stresses);
    return tested;
  }
  const SolveShares shares(load, voigt_count<2>, watch);
  auto loaded = Loader(load, shares.of_load()).load(result.map);
  if (loaded.report.ending == statics::Ending::stopped) return std::nullopt;
  result.converged = loaded.report.ending == statics::Ending::solved;
  result.outcome = loaded.report.sentence;
  result.convergence = convergence_of(loaded.report.history);
  std::optional<statics::EffectiveModuli> moduli;
  if (load.moduli) {
    moduli = find_moduli(Loader(load, shares.of_moduli()), sample.map, result);
    if (!moduli) return std::nullopt;
  }
  add_load(result.numbers, load, loaded.report, moduli);
  if (load.effective_stiffness && load.by_elements() &&
      !add_effective_stiffness(sample.map, Loader(load, shares.of_stiffness()).of_elements(), result))
    return std::nullopt;
  if (load.axis == recipe::Load::Axis::x)
    result.numbers["notes"].push_back(
        "Loaded along x: map, stresses and displacements are those of the sample with x and y exchanged, whose upright "
        "axis is that of the load; moduli and effective stiffness are of the sample as it was given.");
  if (!load.by_elements()) note_bonds_across_voids(result.numbers, load, result.map);
  result.field = as_stored(std::move(loaded.field));
  measure_stress(load, result, measured, contact_stresses);
  return result;
}

MapOutcome load_map(const recipe::MapSection& map, const recipe::Load& load, const RunOptions& options) {
  require_length(map, load);
  const bool is_stored = !options.out.empty();
  MapOutcome outcome;
  auto* measured = options.page_follows ? &outcome.measured.fields.emplace_back() : nullptr;
  const auto make = [&](const statics::Watch& watch, const std::string& hash, const fs::path& checkpoint) {
    return apply_load(load, read_sample(map, options.notice), watch,
                      kept_failure<2>(load, is_stored ? checkpoint : fs::path(), hash, options), measured);
  };
  auto loaded = load_by_itself<FieldResult>(map, load, options, make, io::write_field, io::read_field);
  outcome.field = std::move(loaded.result);
  outcome.file = std::move(loaded.file);
  std::error_code error;
  if (outcome.field && is_stored) fs::remove(options.out / "run.checkpoint", error);
  return outcome;
}

}  // namespace arenite::workflow
