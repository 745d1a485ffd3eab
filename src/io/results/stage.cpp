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

void transfer_energies(const ResultPart& at, Frame& frame) {
  const auto energies = at.group("energies");
  for (const EnergyTerm& term : energy_terms) energies(std::string(term.name) + " [J]", frame.energies.*term.value);
  const auto equilibrium = at.group("equilibrium");
  for (const auto& s : equilibrium_scalars)
    if (s.always || !at.reads() || equilibrium.take->has_attribute(s.name)) equilibrium(s.name, frame.equilibrium.*s.member);
}

void transfer_frame(const ResultPart& at, Frame& frame, const Packing& sample) {
  at("time [s]", frame.time);
  at("step", frame.step);
  at("label", frame.label);
  Packing& packing = frame.packing;
  if (at.reads() ? at.take->has("materials") : !same(packing.materials, sample.materials)) transfer_materials(at, packing.materials);
  else if (at.reads()) packing.materials = sample.materials;
  transfer_domain(at, packing.domain);
  transfer_grains(at, packing, &sample.grains);
  transfer_contacts(at, packing.contacts, packing.grains.size(), packing.domain.elements());
  transfer_bonds(at, packing.bonds, packing.grains.size());
  transfer_cohesive(at, packing.cohesive, packing.grains.size());
  transfer_energies(at, frame);
}

/// What stage files and checkpoints have in common.
void transfer_result(const ResultPart& at, StageResult& result) {
  transfer_origin(at, result);
  Packing sample = result.frames.empty() ? Packing{} : result.frames.front().packing;
  transfer_materials(at, sample.materials);
  transfer_names(at.group("grains"), sample.grains, nullptr);
  at.each("frames", result.frames, 4, [&](const ResultPart& one, Frame& frame) { transfer_frame(one, frame, sample); });
  transfer_history(at, "history", result.history);
  if (at.reads() ? at.take->has_group("cycles") : !result.cycles.columns.empty()) transfer_history(at, "cycles", result.cycles);
  transfer_numbers(at, "texture", result.texture);
  at.array("continuation", result.continuation);
}

}  // namespace

void write_stage(const std::filesystem::path& path, const StageResult& result) { write_result_file(path, "result", transfer_result, result); }

StageResult read_stage(const std::filesystem::path& path) { return read_result_file(path, "result", transfer_result); }

std::variant<StageResult, FieldResult, FilmResult> read_result(const std::filesystem::path& path) {
  const std::string kind = stored_kind(path);
  if (kind == "field") return read_field(path);
  if (kind == "film") return read_film_result(path);
  return read_stage(path);
}

void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint) {
  const Hdf5Writer root(false);
  root.set("key", checkpoint.key);
  const auto blobs = root.create_group("blobs");
  for (const auto& [name, bytes] : checkpoint.blobs) blobs.write(name, bytes);
  const auto numbers = root.create_group("numbers");
  for (const auto& [name, value] : checkpoint.numbers) numbers.set(name, value);
  const auto integers = root.create_group("integers");
  for (const auto& [name, value] : checkpoint.integers) integers.set(name, value);
  transfer_result(ResultPart(root.create_group("partial")), const_cast<StageResult&>(checkpoint.partial));  // which it only reads
  write_checksummed(path, "checkpoint", root.bytes());
}

std::optional<Checkpoint> read_checkpoint(const std::filesystem::path& path, const std::string& key) {
  if (!std::filesystem::exists(path)) return std::nullopt;
  const Hdf5Reader root(read_checksummed(path, "checkpoint"), path.string());
  Checkpoint checkpoint;
  checkpoint.key = root.label("key");
  if (checkpoint.key != key) return std::nullopt;
  const auto blobs = root.group("blobs"), numbers = root.group("numbers"), integers = root.group("integers");
  for (const auto& name : blobs.names()) checkpoint.blobs[name] = blobs.array<std::uint8_t>(name);
  for (const auto& name : numbers.attribute_names()) checkpoint.numbers[name] = numbers.number(name);
  for (const auto& name : integers.attribute_names()) checkpoint.integers[name] = integers.integer(name);
  transfer_result(ResultPart(root.group("partial")), checkpoint.partial);
  return checkpoint;
}

}  // namespace arenite::io
