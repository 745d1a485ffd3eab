#include "workflow/apply_load.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <unordered_map>
#include <utility>

#include "core/error.hpp"
#include "core/problems.hpp"
#include "core/version.hpp"
#include "grains/texture/stress.hpp"
#include "grains/texture/texture.hpp"
#include "io/disk/store_file.hpp"
#include "io/image/phase_map.hpp"
#include "io/results/results.hpp"
#include "solid/elements/load.hpp"
#include "solid/grid/crop.hpp"
#include "solid/grid/map_numbers.hpp"
#include "solid/stress/grains.hpp"
#include "solid/stress/stress.hpp"
#include "thermal/imaging/label_grains.hpp"
#include "workflow/asked.hpp"
#include "workflow/field_numbers.hpp"
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

History convergence_of(const std::vector<double>& residuals) {
  std::vector<double> iteration;
  for (std::size_t k = 0; k < residuals.size(); ++k) iteration.push_back(static_cast<double>(k));
  return {{{"iteration", "1", std::move(iteration)}, {"residual", "1", residuals}}};
}

History curve_of(const std::vector<peridynamics::DamageState>& states) {
  History curve{{{"strain", "1", {}},
                 {"stress", "Pa", {}},
                 {"work", "J/m", {}},
                 {"elastic", "J/m", {}},
                 {"released", "J/m", {}},
                 {"broken", "1", {}}}};
  for (const auto& s : states) {
    const double row[] = {s.strain, s.stress, s.work, s.elastic, s.released, static_cast<double>(s.broken)};
    for (std::size_t c = 0; c < curve.columns.size(); ++c) curve.columns[c].values.push_back(row[c]);
  }
  return curve;
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
  using Ending = peridynamics::DamageResult::Ending;
  peridynamics::DamageOptions options{
      load, load, load.stiffness.resolved(), watch, load.toughness.resolved(), load.strength.resolved()};
  options.keep = checkpoint.keep;
  if (checkpoint.resume) options.resume = &*checkpoint.resume;
  auto tested = peridynamics::load_to_failure(result.map, options);
  if (tested.ending == Ending::stopped) return std::nullopt;
  result.converged =
      tested.ending == Ending::severed || tested.ending == Ending::dropped || tested.ending == Ending::strain_reached;
  result.outcome = tested.sentence;
  result.curve = curve_of(tested.curve);
  result.cracks = peridynamics::cracks_of(tested.broken, result.map.dx);
  add_failure(result.numbers, load, tested, result.map.dx);
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
        elements_{load.loading, load.lower, load.strain, load.tolerance, load.max_iterations, load.material(), watch} {
    bonds_.method = load.bond_method();
  }
  statics::LoadResult load(const PhaseMap& map) const {
    return by_elements_ ? elements::load(map, elements_) : peridynamics::load(map, bonds_);
  }
  statics::EffectiveModuli effective_moduli(const PhaseMap& map) const {
    return by_elements_ ? elements::effective_moduli(map, elements_) : peridynamics::effective_moduli(map, bonds_);
  }

 private:
  bool by_elements_;
  peridynamics::LoadOptions bonds_;
  elements::LoadOptions elements_;
};

}  // namespace

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
  const Loader loader(load, watch);
  auto loaded = loader.load(result.map);
  if (loaded.report.ending == statics::Ending::stopped) return std::nullopt;
  result.converged = loaded.report.ending == statics::Ending::solved;
  result.outcome = loaded.report.sentence;
  result.convergence = convergence_of(loaded.report.history);
  std::optional<statics::EffectiveModuli> moduli;
  if (load.moduli && result.converged) {
    moduli = loader.effective_moduli(result.map);
    for (const auto& report : moduli->reports) {
      if (report.ending == statics::Ending::stopped) return std::nullopt;
      result.converged = result.converged && report.ending == statics::Ending::solved;
    }
  }
  add_load(result.numbers, load, loaded.report, moduli);
  if (!load.by_elements()) note_bonds_across_voids(result.numbers, load, result.map);
  result.field = as_stored(std::move(loaded.field));
  measure_stress(load, result, measured, contact_stresses);
  return result;
}

namespace {

bool is_own_field(const recipe::MapSection& map) { return io::stored_kind(map.file) == "field"; }

io::PhaseMapOptions options_of(const recipe::MapSection& map) {
  io::PhaseMapOptions options;
  options.image = {map.slice, map.dataset};
  options.label_image = {map.label_slice, map.label_dataset};
  if (!map.phases.empty()) options.phases = io::parse_phase_table(map.phases);
  if (!map.crop.empty()) options.crop = io::parse_crop(map.crop);
  options.dx = map.dx.value_or(options.dx);
  if (map.has_label_file()) options.labels = map.labels;
  return options;
}

/// Where cutting at necks finds many more grains, those that touch were counted as one.
void tell_of_touching(const PhaseMap& map, double smoothing, const std::string& file,
                      const std::function<void(const std::string&)>& notice) {
  constexpr double many_more = 1.3;
  PhaseMap cut = map;
  imaging::label_grains(cut, {imaging::Labelling::watershed, smoothing});
  const std::size_t found = map.grain_class.size(), apart = cut.grain_class.size();
  if (static_cast<double>(apart) < many_more * static_cast<double>(found)) return;
  notice(
      fmt::format("{}: grains that touch count as one: {} grains, {} where they are cut at their necks by `--labels "
                  "watershed` (labels = \"watershed\" in [map] of a recipe)",
                  file, found, apart));
}

}  // namespace

PhaseMap read_map(const recipe::MapSection& map, const std::function<void(const std::string&)>& notice) {
  if (map.dimension == 3) refuse(map.file, "is a sample in space; recipes load maps of the plane, `arenite load` both");
  if (is_own_field(map)) return io::read_field(map.file).map;
  auto read = io::read_phase_map(map.file, options_of(map));
  for (const auto& note : read.notes) notice(fmt::format("{}: {}", map.file, note));
  if (read.labelled) return std::move(read.map);
  using imaging::Labelling;
  const auto way = map.labels == "watershed" ? Labelling::watershed : Labelling::components;
  if (map.labels == "none") io::label_alike(read.map);
  else imaging::label_grains(read.map, {way, map.smoothing});
  if (map.labels != "none" && way == Labelling::components) tell_of_touching(read.map, map.smoothing, map.file, notice);
  return std::move(read.map);
}

FieldResult read_sample(const recipe::MapSection& map, const std::function<void(const std::string&)>& notice) {
  FieldResult sample = sample_of_map(read_map(map, notice));
  if (map.dx || is_own_field(map)) return sample;
  Numbers& numbers = sample.numbers["map"];
  numbers.erase("dx_m");
  numbers["lengths"] = "in nodes, since dx was not given";
  return sample;
}

void require_length(const recipe::MapSection& map, const recipe::Load& load) {
  if (load.failure && !map.dx && !is_own_field(map))
    throw InputError(
        "a crack needs a length; give the size of a pixel, for example --dx \"25 um\" (dx in [map] of a recipe)");
}

FieldResult sample_of_map(PhaseMap map, const grid::CavityRules& rules) {
  check(map);
  std::size_t particle = 0;
  for (const Phase p : map.phase) particle += p == Phase::particle;
  // Without particles the unit of volume is a node.
  const double grains = static_cast<double>(map.grain_class.size());
  const double nodes_per_grain = grains > 0 && particle > 0 ? static_cast<double>(particle) / grains : 1;
  FieldResult sample;
  sample.name = "map";
  sample.numbers = grid::map_numbers(map, rules, map.dx * std::sqrt(nodes_per_grain / std::numbers::pi));
  sample.map = std::move(map);
  return sample;
}

MapOutcome load_map(const recipe::MapSection& map, const recipe::Load& load, const RunOptions& options) {
  require_length(map, load);
  const bool is_stored = !options.out.empty();
  const PlannedStage stage = planned_stage(1, load.name, load_key(load, map_key(map)), true);
  Progress progress{.stage = 1, .stages = 1, .name = load.name, .field = true};
  MapOutcome outcome;
  auto* measured = options.page_follows ? &outcome.measured.fields.emplace_back() : nullptr;
  const auto make = [&](const fs::path& checkpoint) {
    const FieldResult sample = read_sample(map, options.notice);
    auto result = apply_load(
        load, sample, watch_of(progress, options),
        load.failure && is_stored ? failure_checkpoint(checkpoint, stage.hash, options) : FailureCheckpoint{},
        measured);
    if (result)
      result->provenance = {version,
                            load.name,
                            stage.hash,
                            "",
                            0,
                            "",
                            {{"map", fs::path(map.file).filename().string()}, {"options", told_map_keys(map)}}};
    return result;
  };
  if (is_stored) {
    outcome.file = options.out / stage.file;
    outcome.field =
        carry_out<FieldResult>({stage, outcome.file, make, io::write_field, read_field}, options, progress.reused);
  } else {
    outcome.field = make({});
  }
  if (!outcome.field) return outcome;
  progress.share = 1;
  options.progress(progress);
  std::error_code error;
  if (is_stored) fs::remove(options.out / "run.checkpoint", error);
  return outcome;
}

}  // namespace arenite::workflow
