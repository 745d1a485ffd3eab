#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "core/hash.hpp"
#include "core/version.hpp"
#include "io/disk/file.hpp"
#include "io/results/results.hpp"
#include "workflow/runner.hpp"

namespace arenite::workflow {

namespace fs = std::filesystem;

namespace {

bool is_own_field(const MapSource& source) { return io::stored_kind(source.file) == "field"; }

PhaseMap read_map(const MapSource& source, const RunOptions& options) {
  if (is_own_field(source)) return io::read_field(source.file).map;
  auto read = io::read_phase_map(source.file, source.reading);
  for (const auto& note : read.notes) options.notice(fmt::format("{}: {}", source.file.string(), note));
  if (read.labelled) return std::move(read.map);
  if (source.labelling) imaging::label_grains(read.map, *source.labelling);
  else io::label_alike(read.map);
  return std::move(read.map);
}

FieldResult read_sample(const MapSource& source, const RunOptions& options) {
  FieldResult sample = sample_of_map(read_map(source, options));
  if (source.has_length || is_own_field(source)) return sample;
  Numbers& map = sample.numbers["map"];
  map.erase("dx_m");
  map["lengths"] = "in nodes, since --dx was not given";
  return sample;
}

/// Hash of all that the sample depends on.
std::string map_key(const MapSource& source) {
  HashBuilder hash;
  hash.add("map", content_hash(io::read_file(source.file))).add("options", source.asked);
  if (source.reading.labels) hash.add("labels", content_hash(io::read_file(*source.reading.labels)));
  return hash.hex();
}

}  // namespace

FieldResult sample_of_map(PhaseMap map, const grid::CavityRules& rules) {
  check(map);
  std::size_t particle = 0;
  for (const Phase p : map.phase) particle += p == Phase::particle;
  // Without particles the unit of volume is a node.
  const double grains = static_cast<double>(map.grain_class.size());
  const double nodes_per_grain = grains > 0 && particle > 0 ? static_cast<double>(particle) / grains : 1;
  FieldResult sample;
  sample.name = "map";
  sample.numbers = map_numbers(map, rules, map.dx * std::sqrt(nodes_per_grain / std::numbers::pi));
  sample.map = std::move(map);
  return sample;
}

MapOutcome load_map(const MapSource& source, const recipe::Load& load, const RunOptions& options) {
  const bool is_stored = !options.out.empty();
  const PlannedStage stage = planned_stage(1, load.name, load_key(load, map_key(source)), true);
  Progress progress{1, 1, load.name, 0, 0, 0, false, true};
  const auto make = [&](const fs::path& checkpoint) {
    const FieldResult sample = read_sample(source, options);
    auto result = apply_load(load, sample, watch_of(progress, options),
                             load.failure && is_stored ? failure_checkpoint(checkpoint, stage.hash, options) : FailureCheckpoint{});
    if (result) result->provenance = {version, load.name, stage.hash, "", 0, "", {{"map", source.file.filename().string()}, {"options", source.asked}}};
    return result;
  };
  MapOutcome outcome;
  if (is_stored) {
    rename_former(options.out, {stage});
    outcome.file = options.out / stage.file;
    outcome.field = carry_out<FieldResult>({stage, outcome.file, make, io::write_field, io::read_field}, options, progress.reused);
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
