#include "io/packing_groups.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/columns.hpp"
#include "io/scalars.hpp"

namespace arenite::io {
namespace {

constexpr std::array<Scalar<Wall>, 4> wall_scalars{{{"position [m]", &Wall::position},
                                                    {"velocity [m/s]", &Wall::velocity},
                                                    {"force [N]", &Wall::force},
                                                    {"shear_force [N]", &Wall::shear_force}}};

constexpr std::array<Scalar<Material>, 3> material_scalars{{{"density [kg/m^3]", &Material::density},
                                                            {"stiffness [N/m]", &Material::stiffness},
                                                            {"thermoelastic_factor [K/Pa]", &Material::thermoelastic_factor}}};

/// What does not change while grains move, unless the sample says the same.
void write_names(const Hdf5Writer& group, const Grains& grains, const Grains* sample) {
  if (!sample || grains.id != sample->id) group.write("id", grains.id);
  if (!sample || grains.radius != sample->radius) group.write("radius", grains.radius, "m");
  if (!sample || grains.material != sample->material) group.write("material", grains.material);
  if (!sample || grains.zone != sample->zone) group.write("zone", grains.zone);
}

void write_state(const Hdf5Writer& group, const Grains& grains) {
  for (const auto& column : grain_state_columns) group.write(column.name, grains.*column.member, column.unit);
}

}  // namespace

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

void write_grains(const Hdf5Writer& at, const Grains& grains, const Grains* sample) {
  const auto group = at.create_group("grains");
  write_names(group, grains, sample);
  if (sample) write_state(group, grains);
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
  group.set("i and j", "places in the arrays of grains, from 0, not ids; j = -1, -2, -3, -4 is the left, right, bottom, top wall");
  group.set("signs", "n points from j to i, t is n turned by +90 degrees, the force on i is fn n + ft t; fn > 0 pushes");
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

void write_packing(const Hdf5Writer& at, const Packing& packing) {
  const auto group = at.create_group("packing");
  write_materials(group, packing.materials);
  write_domain(group, packing.domain);
  const auto grains = group.create_group("grains");
  write_names(grains, packing.grains, nullptr);
  write_state(grains, packing.grains);
  write_contacts(group, packing.contacts);
}

Packing read_packing(const Hdf5Reader& group) {
  Packing packing;
  packing.materials = read_materials(group.group("materials"));
  packing.domain = read_domain(group.group("domain"));
  const Hdf5Reader grains = group.group("grains");
  packing.grains = read_grains(grains, grains);
  const auto kinds = static_cast<std::int64_t>(packing.materials.size());
  for (const auto m : packing.grains.material)
    if (m < 0 || m >= kinds) group.refuse("names a material that does not exist");
  packing.contacts = read_contacts(group.group("contacts"), packing.grains);
  return packing;
}

}  // namespace arenite::io
