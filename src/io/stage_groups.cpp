#include "io/numbers_table.hpp"
#include "io/stage_groups.hpp"

#include <fmt/format.h>

#include <array>

#include "io/packing_groups.hpp"
#include "io/result_groups.hpp"
#include "io/scalars.hpp"

namespace arenite::io {
namespace {

constexpr std::array<Scalar<Equilibrium>, 6> equilibrium_scalars{{{"unbalanced_ratio", &Equilibrium::unbalanced_ratio},
                                                                  {"kinetic_ratio", &Equilibrium::kinetic_ratio},
                                                                  {"mobilisation", &Equilibrium::mobilisation},
                                                                  {"wall_speed [m/s]", &Equilibrium::wall_speed},
                                                                  {"falling", &Equilibrium::falling, 0.0},
                                                                  {"loose_kinetic_ratio", &Equilibrium::loose_kinetic, 0.0}}};

std::string dataset(const EnergyTerm& term) { return std::string(term.name) + " [J]"; }

void write_energies(const Hdf5Writer& at, const Energies& energies) {
  for (const EnergyTerm& term : energy_terms) at.set(dataset(term), energies.*term.value);
}

void read_energies(const Hdf5Reader& at, Energies& energies) {
  for (const EnergyTerm& term : energy_terms) energies.*term.value = at.number(dataset(term));
}

void write_frame(const Hdf5Writer& at, const Frame& frame, const Packing& sample) {
  at.set("time [s]", frame.time);
  at.set("step", frame.step);
  at.set("label", frame.label);
  if (!same(frame.packing.materials, sample.materials)) write_materials(at, frame.packing.materials);
  write_domain(at, frame.packing.domain);
  write_grains(at, frame.packing.grains, &sample.grains);
  write_contacts(at, frame.packing.contacts);
  write_energies(at.create_group("energies"), frame.energies);
  write_scalars(at.create_group("equilibrium"), equilibrium_scalars, frame.equilibrium);
}

Frame read_frame(const Hdf5Reader& at, const Materials& materials, const Hdf5Reader& sample) {
  Frame frame;
  frame.time = at.number("time [s]");
  frame.step = at.integer("step");
  frame.label = at.label("label");
  frame.packing.materials = at.has("materials") ? read_materials(at.group("materials")) : materials;
  frame.packing.domain = read_domain(at.group("domain"));
  frame.packing.grains = read_grains(at.group("grains"), sample);
  const auto kinds = static_cast<std::int64_t>(frame.packing.materials.size());
  for (const auto m : frame.packing.grains.material)
    if (m < 0 || m >= kinds) at.refuse("names a material that does not exist");
  frame.packing.contacts = read_contacts(at.group("contacts"), frame.packing.grains);
  read_energies(at.group("energies"), frame.energies);
  read_scalars(at.group("equilibrium"), equilibrium_scalars, frame.equilibrium);
  return frame;
}

}  // namespace

void write_result(const Hdf5Writer& at, const StageResult& result) {
  write_origin(at, result);
  const Packing sample = result.frames.empty() ? Packing{} : result.frames.front().packing;
  write_materials(at, sample.materials);
  write_grains(at, sample.grains, nullptr);
  const auto frames = at.create_group("frames");
  for (std::size_t f = 0; f < result.frames.size(); ++f)
    write_frame(frames.create_group(fmt::format("{:04}", f)), result.frames[f], sample);
  write_history(at, "history", result.history);
  write_numbers(at, "texture", result.texture);
  at.write("continuation", result.continuation);
}

StageResult read_result(const Hdf5Reader& at) {
  StageResult result;
  read_origin(at, result);
  const auto materials = read_materials(at.group("materials"));
  const auto sample = at.group("grains");
  const auto frames = at.group("frames");
  for (const auto& name : frames.names()) result.frames.push_back(read_frame(frames.group(name), materials, sample));
  result.history = read_history(at.group("history"));
  result.texture = read_numbers(at, "texture");
  result.continuation = at.bytes("continuation");
  return result;
}

}  // namespace arenite::io
