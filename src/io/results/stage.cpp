#include "io/disk/store_file.hpp"
#include "io/results/groups.hpp"
#include "io/results/results.hpp"

namespace arenite::io {
namespace {

struct Scalar {
  const char* name;
  double Equilibrium::*member;
  bool always;  ///< false: 0 in files that do not have it
};
constexpr Scalar equilibrium_scalars[] = {{"unbalanced_ratio", &Equilibrium::unbalanced_ratio, true},
                                          {"kinetic_ratio", &Equilibrium::kinetic_ratio, true},
                                          {"mobilisation", &Equilibrium::mobilisation, true},
                                          {"wall_speed [m/s]", &Equilibrium::wall_speed, true},
                                          {"falling", &Equilibrium::falling, false},
                                          {"loose_kinetic_ratio", &Equilibrium::loose_kinetic, false}};

template <class At, class F>
void transfer_energies(const At& at, F& frame) {
  const auto energies = at.group("energies");
  for (const EnergyTerm& term : energy_terms) energies((std::string(term.name) + " [J]").c_str(), frame.energies.*term.value);
  const auto equilibrium = at.group("equilibrium");
  for (const auto& s : equilibrium_scalars) {
    if constexpr (At::reads)
      if (!s.always && !equilibrium.at.has_attribute(s.name)) continue;
    equilibrium(s.name, frame.equilibrium.*s.member);
  }
}

template <class At, class F>
void transfer_moment(const At& at, F& frame) {
  at("time [s]", frame.time);
  at("step", frame.step);
  at("label", frame.label);
}

void write_frame(const PutGroup& at, const Frame& frame, const Packing& sample) {
  transfer_moment(at, frame);
  const Packing& packing = frame.packing;
  if (!same(packing.materials, sample.materials)) transfer_materials(at, packing.materials);
  transfer_domain(at, packing.domain);
  const auto grains = at.group("grains");
  put_names(grains.at, packing.grains, &sample.grains);
  transfer_columns(grains, packing.grains, grain_state_columns, packing.grains.size());
  transfer_contacts(at, packing.contacts, packing.grains.size());
  transfer_energies(at, frame);
}

void read_frame(const TakeGroup& at, Frame& frame, const Materials& materials, const Hdf5Reader& sample) {
  transfer_moment(at, frame);
  Packing& packing = frame.packing;
  if (at.at.has("materials")) transfer_materials(at, packing.materials);
  else packing.materials = materials;
  transfer_domain(at, packing.domain);
  const auto grains = at.group("grains");
  take_names(grains.at, sample, packing.grains);
  transfer_columns(grains, packing.grains, grain_state_columns, packing.grains.id.size());
  check_materials(at.at, packing);
  transfer_contacts(at, packing.contacts, packing.grains.size());
  transfer_energies(at, frame);
}

/// What stage files and checkpoints have in common.
void write_result(const PutGroup& at, const StageResult& result) {
  transfer_origin(at, result);
  const Packing sample = result.frames.empty() ? Packing{} : result.frames.front().packing;
  transfer_materials(at, sample.materials);
  put_names(at.group("grains").at, sample.grains, nullptr);
  at.each("frames", result.frames, 4, [&](const PutGroup& one, const Frame& frame) { write_frame(one, frame, sample); });
  transfer_history(at, "history", result.history);
  transfer_numbers(at, "texture", result.texture);
  at.array("continuation", result.continuation);
}

StageResult read_result(const TakeGroup& at) {
  StageResult result;
  transfer_origin(at, result);
  Materials materials;
  transfer_materials(at, materials);
  const auto sample = at.at.group("grains");
  at.each("frames", result.frames, 4, [&](const TakeGroup& one, Frame& frame) { read_frame(one, frame, materials, sample); });
  transfer_history(at, "history", result.history);
  transfer_numbers(at, "texture", result.texture);
  at.array("continuation", result.continuation);
  return result;
}

}  // namespace

void write_stage(const std::filesystem::path& path, const StageResult& result) {
  const Hdf5Writer file;
  write_result({file}, result);
  write_sealed(path, "result", file.bytes());
}

StageResult read_stage(const std::filesystem::path& path) { return read_result({Hdf5Reader(read_sealed(path, "result"), path.string())}); }

void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint) {
  const Hdf5Writer root(false);
  root.set("key", checkpoint.key);
  const auto blobs = root.create_group("blobs");
  for (const auto& [name, bytes] : checkpoint.blobs) blobs.write(name, bytes);
  const auto numbers = root.create_group("numbers");
  for (const auto& [name, value] : checkpoint.numbers) numbers.set(name, value);
  const auto integers = root.create_group("integers");
  for (const auto& [name, value] : checkpoint.integers) integers.set(name, value);
  write_result({root.create_group("partial")}, checkpoint.partial);
  write_sealed(path, "checkpoint", root.bytes());
}

std::optional<Checkpoint> read_checkpoint(const std::filesystem::path& path, const std::string& key) {
  if (!std::filesystem::exists(path)) return std::nullopt;
  const Hdf5Reader root(read_sealed(path, "checkpoint"), path.string());
  Checkpoint checkpoint;
  checkpoint.key = root.label("key");
  if (checkpoint.key != key) return std::nullopt;
  const auto blobs = root.group("blobs"), numbers = root.group("numbers"), integers = root.group("integers");
  for (const auto& name : blobs.names()) checkpoint.blobs[name] = blobs.array<std::uint8_t>(name);
  for (const auto& name : numbers.attribute_names()) checkpoint.numbers[name] = numbers.number(name);
  for (const auto& name : integers.attribute_names()) checkpoint.integers[name] = integers.integer(name);
  checkpoint.partial = read_result({root.group("partial")});
  return checkpoint;
}

}  // namespace arenite::io
