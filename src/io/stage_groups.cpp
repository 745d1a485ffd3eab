#include "io/stage_groups.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "io/columns.hpp"

namespace arenite::io {
namespace {

template <class Owner>
struct Scalar {
  const char* name;
  double Owner::*member;
};

constexpr std::array<Scalar<Energies>, 9> energy_scalars{{{"kinetic [J]", &Energies::kinetic},
                                                          {"elastic [J]", &Energies::elastic},
                                                          {"adhesive [J]", &Energies::adhesive},
                                                          {"dissipated_normal [J]", &Energies::dissipated_normal},
                                                          {"dissipated_friction [J]", &Energies::dissipated_friction},
                                                          {"dissipated_drag [J]", &Energies::dissipated_drag},
                                                          {"dissipated_breakage [J]", &Energies::dissipated_breakage},
                                                          {"work_walls [J]", &Energies::work_walls},
                                                          {"work_gravity [J]", &Energies::work_gravity}}};

constexpr std::array<Scalar<Equilibrium>, 4> equilibrium_scalars{{{"unbalanced_ratio", &Equilibrium::unbalanced_ratio},
                                                                  {"kinetic_ratio", &Equilibrium::kinetic_ratio},
                                                                  {"mobilisation", &Equilibrium::mobilisation},
                                                                  {"wall_speed [m/s]", &Equilibrium::wall_speed}}};

constexpr std::array<Scalar<Wall>, 4> wall_scalars{{{"position [m]", &Wall::position},
                                                    {"velocity [m/s]", &Wall::velocity},
                                                    {"force [N]", &Wall::force},
                                                    {"shear_force [N]", &Wall::shear_force}}};

constexpr std::array<Scalar<Material>, 3> material_scalars{{{"density [kg/m^3]", &Material::density},
                                                            {"stiffness [N/m]", &Material::stiffness},
                                                            {"thermoelastic_factor [K/Pa]", &Material::thermoelastic_factor}}};

template <class Owner, std::size_t n>
void write_scalars(const Hdf5Writer& at, const std::array<Scalar<Owner>, n>& scalars, const Owner& from) {
  for (const auto& s : scalars) at.set(s.name, from.*s.member);
}

template <class Owner, std::size_t n>
void read_scalars(const Hdf5Reader& at, const std::array<Scalar<Owner>, n>& scalars, Owner& into) {
  for (const auto& s : scalars) into.*s.member = at.number(s.name);
}

void write_materials(const Hdf5Writer& at, const Materials& materials) {
  const auto group = at.create_group("materials");
  for (std::size_t m = 0; m < materials.size(); ++m) {
    const auto one = group.create_group(fmt::format("{:02}", m));
    one.set("name", materials[m].name);
    write_scalars(one, material_scalars, materials[m]);
  }
}

Materials read_materials(const Hdf5Reader& at) {
  Materials materials;
  for (const auto& name : at.names()) {
    const auto one = at.group(name);
    Material material;
    material.name = one.label("name");
    read_scalars(one, material_scalars, material);
    materials.push_back(material);
  }
  return materials;
}

bool same(const Materials& a, const Materials& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Material& p, const Material& q) {
    return p.name == q.name && std::all_of(material_scalars.begin(), material_scalars.end(),
                                           [&](const auto& s) { return p.*s.member == q.*s.member; });
  });
}

void write_domain(const Hdf5Writer& at, const Domain& domain) {
  const auto group = at.create_group("domain");
  group.set("periodic_x", std::int64_t{domain.periodic_x});
  group.set("periodic_y", std::int64_t{domain.periodic_y});
  group.set("tilt [m]", domain.tilt);
  group.set("thickness [m]", domain.thickness);
  for (std::size_t side = 0; side < domain.wall.size(); ++side) {
    const auto wall = group.create_group(side_names[side]);
    wall.set("present", std::int64_t{domain.wall[side].present});
    write_scalars(wall, wall_scalars, domain.wall[side]);
  }
}

Domain read_domain(const Hdf5Reader& group) {
  Domain domain;
  domain.periodic_x = group.integer("periodic_x") != 0;
  domain.periodic_y = group.integer("periodic_y") != 0;
  domain.tilt = group.number("tilt [m]");
  domain.thickness = group.number("thickness [m]");
  for (std::size_t side = 0; side < domain.wall.size(); ++side) {
    const auto wall = group.group(side_names[side]);
    domain.wall[side].present = wall.integer("present") != 0;
    read_scalars(wall, wall_scalars, domain.wall[side]);
  }
  return domain;
}

/// Arrays of a frame's grains; those that equal the sample's (of the first frame) are left to /grains.
void write_grains(const Hdf5Writer& at, const Grains& grains, const Grains* sample) {
  const auto group = at.create_group("grains");
  if (!sample || grains.id != sample->id) group.write("id", grains.id);
  if (!sample || grains.radius != sample->radius) group.write("radius", grains.radius, "m");
  if (!sample || grains.material != sample->material) group.write("material", grains.material);
  if (!sample || grains.zone != sample->zone) group.write("zone", grains.zone);
  if (!sample) return;
  for (const auto& column : grain_state_columns) group.write(column.name, grains.*column.member, column.unit);
}

Grains read_grains(const Hdf5Reader& group, const Hdf5Reader& sample) {
  const auto holder = [&](const char* name) -> const Hdf5Reader& { return group.has(name) ? group : sample; };
  Grains grains;
  grains.id = holder("id").int64s("id");
  grains.radius = holder("radius").doubles("radius");
  grains.material = holder("material").int32s("material");
  grains.zone = holder("zone").bytes("zone");
  for (const auto& column : grain_state_columns) {
    grains.*column.member = group.doubles(column.name);
    if ((grains.*column.member).size() != grains.id.size()) group.refuse("holds arrays of different lengths");
  }
  if (grains.radius.size() != grains.id.size() || grains.material.size() != grains.id.size() || grains.zone.size() != grains.id.size())
    group.refuse("holds arrays of different lengths");
  return grains;
}

void write_contacts(const Hdf5Writer& at, const Contacts& contacts) {
  const auto group = at.create_group("contacts");
  group.write("i", contacts.i);
  group.write("j", contacts.j);
  for (const auto& column : contact_columns) group.write(column.name, contacts.*column.member, column.unit);
  group.write("glued", contacts.glued);
}

Contacts read_contacts(const Hdf5Reader& group, const Grains& grains) {
  Contacts contacts;
  contacts.i = group.int32s("i");
  contacts.j = group.int32s("j");
  contacts.glued = group.bytes("glued");
  bool whole = contacts.j.size() == contacts.size() && contacts.glued.size() == contacts.size();
  for (const auto& column : contact_columns) {
    contacts.*column.member = group.doubles(column.name);
    whole = whole && (contacts.*column.member).size() == contacts.size();
  }
  if (!whole) group.refuse("holds arrays of different lengths");
  const auto n = static_cast<std::int64_t>(grains.size());
  for (std::size_t c = 0; c < contacts.size(); ++c)
    if (contacts.i[c] < 0 || contacts.i[c] >= n || contacts.j[c] >= n || contacts.j[c] < wall_partner(top))
      group.refuse("names a grain that does not exist");
  return contacts;
}

void write_frame(const Hdf5Writer& at, const Frame& frame, const Packing& sample) {
  at.set("time [s]", frame.time);
  at.set("step", frame.step);
  at.set("label", frame.label);
  if (!same(frame.packing.materials, sample.materials)) write_materials(at, frame.packing.materials);
  write_domain(at, frame.packing.domain);
  write_grains(at, frame.packing.grains, &sample.grains);
  write_contacts(at, frame.packing.contacts);
  write_scalars(at.create_group("energies"), energy_scalars, frame.energies);
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
  read_scalars(at.group("energies"), energy_scalars, frame.energies);
  read_scalars(at.group("equilibrium"), equilibrium_scalars, frame.equilibrium);
  return frame;
}

void write_provenance(const Hdf5Writer& at, const Provenance& provenance) {
  const auto group = at.create_group("provenance");
  group.set("version", provenance.version);
  group.set("stage", provenance.stage);
  group.set("input_hash", provenance.input_hash);
  group.set("seed", provenance.seed);
  group.set("kernel", provenance.kernel);
  group.write_text("recipe", provenance.recipe);
  const auto options = group.create_group("options");
  for (const auto& [key, value] : provenance.options) options.set(key, value);
}

Provenance read_provenance(const Hdf5Reader& group) {
  Provenance provenance;
  provenance.version = group.label("version");
  provenance.stage = group.label("stage");
  provenance.input_hash = group.label("input_hash");
  provenance.seed = group.natural("seed");
  provenance.kernel = group.label("kernel");
  provenance.recipe = group.text("recipe");
  const auto options = group.group("options");
  for (const auto& key : options.attribute_names()) provenance.options.emplace_back(key, options.label(key));
  return provenance;
}

}  // namespace

void write_result(const Hdf5Writer& at, const StageResult& result) {
  write_provenance(at, result.provenance);
  const auto outcome = at.create_group("outcome");
  outcome.set("name", result.name);
  outcome.set("converged", std::int64_t{result.converged});
  outcome.set("outcome", result.outcome);
  const Packing sample = result.frames.empty() ? Packing{} : result.frames.front().packing;
  write_materials(at, sample.materials);
  write_grains(at, sample.grains, nullptr);
  const auto frames = at.create_group("frames");
  for (std::size_t f = 0; f < result.frames.size(); ++f)
    write_frame(frames.create_group(fmt::format("{:04}", f)), result.frames[f], sample);
  const auto history = at.create_group("history");
  for (const auto& column : result.history.columns) history.write(column.name, column.values, column.unit);
  at.write_text("texture", result.texture_json);
  at.write("continuation", result.continuation);
}

StageResult read_result(const Hdf5Reader& at) {
  StageResult result;
  result.provenance = read_provenance(at.group("provenance"));
  const auto outcome = at.group("outcome");
  result.name = outcome.label("name");
  result.converged = outcome.integer("converged") != 0;
  result.outcome = outcome.label("outcome");
  const auto materials = read_materials(at.group("materials"));
  const auto sample = at.group("grains");
  const auto frames = at.group("frames");
  for (const auto& name : frames.names()) result.frames.push_back(read_frame(frames.group(name), materials, sample));
  const auto history = at.group("history");
  for (const auto& name : history.names()) result.history.columns.push_back({name, history.unit(name), history.doubles(name)});
  result.texture_json = at.text("texture");
  result.continuation = at.bytes("continuation");
  return result;
}

}  // namespace arenite::io
