#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>

#include "io/results/groups.hpp"
#include "io/results/joints.hpp"
#include "io/results/results.hpp"

namespace arenite::io {
namespace {

/// What files of each dimension say that they are.
template <int D> constexpr const char* kind_of = D == 2 ? "result" : "spheres";

template <int D> void transfer_energies(const Hdf5Group& at, SnapshotIn<D>& snapshot) {
  const auto energies = at.group("energies");
  for (const EnergyTerm& term : energy_terms) energies(std::string(term.name) + " [J]", snapshot.energies.*term.value);
  const std::string exchanged = std::string(exchange_term.name) + " [J]";
  if (at.reads() ? energies.has_attribute(exchanged) : snapshot.energies.exchanged != 0)
    energies(exchanged, snapshot.energies.exchanged);
  const auto equilibrium = at.group("equilibrium");
  equilibrium("unbalanced_ratio", snapshot.equilibrium.unbalanced_ratio);
  equilibrium("kinetic_ratio", snapshot.equilibrium.kinetic_ratio);
  equilibrium("mobilisation", snapshot.equilibrium.mobilisation);
  equilibrium("wall_speed [m/s]", snapshot.equilibrium.wall_speed);
  equilibrium("falling", snapshot.equilibrium.falling);
  equilibrium("loose_kinetic_ratio", snapshot.equilibrium.loose_kinetic);
}

template <int D> void transfer_snapshot(const Hdf5Group& at, SnapshotIn<D>& snapshot, const PackingIn<D>& sample) {
  at("time [s]", snapshot.time);
  at("step", snapshot.step);
  at("label", snapshot.label);
  PackingIn<D>& packing = snapshot.packing;
  if (at.reads() ? at.has("materials") : packing.materials != sample.materials)
    transfer_materials(at, packing.materials);
  else if (at.reads()) packing.materials = sample.materials;
  transfer_domain<D>(at, packing.domain);
  transfer_grains(at, packing, &sample.grains);
  transfer_contacts(at, packing);
  transfer_joints(at, packing);
  transfer_energies(at, snapshot);
}

/// Files of former versions have no such group.
void transfer_asked(const Hdf5Group& file, Asked& asked, int every_side) {
  if (file.lacks("asked", !asked.known)) return;
  const auto at = file.group("asked");
  asked.known = true;
  at("friction", asked.friction);
  at("pull", asked.pull);
  at("gravity_x [m/s^2]", asked.gravity.x);
  at("gravity_y [m/s^2]", asked.gravity.y);
  for (int side = 0; side < every_side; ++side)
    at(std::string(any_side_names[side]) + "_slide [m/s]", asked.slide[static_cast<std::size_t>(side)]);
  at("load_axis [rad]", asked.load_axis);
  at("cycled", asked.cycled);
  if (every_side == sides_in<3> && (!at.reads() || at.has_attribute("closes"))) at("closes", asked.closes);
  if (every_side == sides_in<3> && (at.reads() ? at.has_attribute("width [m]") : asked.box[0] > 0))
    for (std::size_t axis = 0; axis < 3; ++axis)
      at(std::array{"width [m]", "height [m]", "depth [m]"}[axis], asked.box[axis]);
  const bool has_direction = asked.load_direction != std::array<double, 3>{};
  if (every_side == sides_in<3> && (at.reads() ? at.has_attribute("load_direction_x") : has_direction))
    for (std::size_t axis = 0; axis < 3; ++axis)
      at(std::string("load_direction_") + "xyz"[axis], asked.load_direction[axis]);
  at("in_motion", asked.in_motion);
  at("in_equilibrium", asked.in_equilibrium);
  if (!at.lacks("measure", !asked.measure)) {
    const auto group = at.group("measure");
    if (at.reads()) asked.measure.emplace();
    group("border", asked.measure->border);
    group("seed", asked.measure->seed);
  }
  at.array("diameter", asked.diameter, "m");
  at.array("passing", asked.passing);
  at.same_length({asked.diameter.size(), asked.passing.size()});
}

/// What stage files and checkpoints have in common.
template <int D> void transfer_result(const Hdf5Group& at, StageResultIn<D>& result) {
  transfer_origin(at, result);
  transfer_asked(at, result.asked, sides_in<D>);
  if (at.reads() ? at.has_attribute("began [s]") : result.began.has_value()) {
    double began = result.began.value_or(0);
    at("began [s]", began);
    result.began = began;
  }
  PackingIn<D> sample = result.snapshots.empty() ? PackingIn<D>{} : result.snapshots.front().packing;
  transfer_materials(at, sample.materials);
  transfer_names<D>(at.group("grains"), sample.grains, nullptr);
  at.each("frames", result.snapshots, 4,
          [&](const Hdf5Group& one, SnapshotIn<D>& snapshot) { transfer_snapshot(one, snapshot, sample); });
  transfer_history(at, "history", result.history);
  if (!at.lacks("cycles", result.cycles.columns.empty())) transfer_history(at, "cycles", result.cycles);
  transfer_numbers(at, "texture", result.texture);
  at.array("continuation", result.continuation);
}

template <int D> void transfer_checkpoint(const Hdf5Group& at, CheckpointIn<D>& checkpoint) {
  at("key", checkpoint.key);
  const auto blobs = at.group("blobs");
  if (at.reads())
    for (const auto& name : blobs.names()) checkpoint.blobs[name];
  for (auto& [name, bytes] : checkpoint.blobs) blobs.array(name, bytes);
  at.attributes("numbers", checkpoint.numbers);
  at.attributes("integers", checkpoint.integers);
  transfer_result(at.group("partial"), checkpoint.partial);
}

}  // namespace

template <int D> void write_stage(const std::filesystem::path& path, const StageResultIn<D>& result) {
  write_result_file(path, kind_of<D>, transfer_result<D>, result);
}

template <int D> StageResultIn<D> read_stage(const std::filesystem::path& path) {
  return read_result_file(path, kind_of<D>, transfer_result<D>);
}

AnyResult read_result(const std::filesystem::path& path) {
  const std::string kind = stored_kind(path);
  if (kind == "voxels") return read_voxels(path);
  if (kind == "field") return read_field(path);
  if (kind == "film") return read_film_result(path);
  if (kind == kind_of<3>) return read_stage<3>(path);
  return read_stage<2>(path);
}

template <int D> void write_checkpoint(const std::filesystem::path& path, const CheckpointIn<D>& checkpoint) {
  write_result_file(path, "checkpoint", transfer_checkpoint<D>, checkpoint, false);
}

template <int D>
std::optional<CheckpointIn<D>> read_checkpoint(const std::filesystem::path& path, const std::string& key) {
  if (!std::filesystem::exists(path)) return std::nullopt;
  const Hdf5Group root(read_checksummed(path, "checkpoint"), path.string());
  CheckpointIn<D> checkpoint;
  root("key", checkpoint.key);
  if (checkpoint.key != key) return std::nullopt;
  transfer_checkpoint(root, checkpoint);
  return checkpoint;
}

#define ARENITE_OF(D)                                                                   \
  template void write_stage(const std::filesystem::path&, const StageResultIn<D>&);     \
  template StageResultIn<D> read_stage(const std::filesystem::path&);                   \
  template void write_checkpoint(const std::filesystem::path&, const CheckpointIn<D>&); \
  template std::optional<CheckpointIn<D>> read_checkpoint(const std::filesystem::path&, const std::string&);
ARENITE_OF(2)
ARENITE_OF(3)
#undef ARENITE_OF

}  // namespace arenite::io
