#include "io/results/groups.hpp"

namespace arenite::io {
namespace {

template <class Owner>
struct Scalar {
  const char* name;
  double Owner::*member;
};
constexpr Scalar<Wall> wall_scalars[] = {{"position [m]", &Wall::position}, {"velocity [m/s]", &Wall::velocity},
                                         {"force [N]", &Wall::force}, {"shear_force [N]", &Wall::shear_force}};
constexpr Scalar<Material> material_scalars[] = {{"density [kg/m^3]", &Material::density}, {"stiffness [N/m]", &Material::stiffness},
                                                 {"thermoelastic_factor [K/Pa]", &Material::thermoelastic_factor}};

}  // namespace

template <class At, class P>
void transfer_provenance(const At& at, P& provenance) {
  at("version", provenance.version);
  at("stage", provenance.stage);
  at("input_hash", provenance.input_hash);
  at.seed("seed", provenance.seed);
  at("kernel", provenance.kernel);
  const auto options = [&] { return at.group("options").at; };
  if constexpr (At::reads) {
    provenance.recipe = at.at.text("recipe");
    const auto from = options();
    for (const auto& key : from.attribute_names()) provenance.options.emplace_back(key, from.label(key));
  } else {
    at.at.write_text("recipe", provenance.recipe);
    const auto to = options();
    for (const auto& [key, value] : provenance.options) to.set(key, value);
  }
}
template void transfer_provenance(const PutGroup&, const Provenance&);
template void transfer_provenance(const TakeGroup&, Provenance&);

template <class At, class M>
void transfer_materials(const At& at, M& materials) {
  at.each("materials", materials, 2, [](const At& one, auto& material) {
    one("name", material.name);
    for (const auto& s : material_scalars) one(s.name, material.*s.member);
  });
}
template void transfer_materials(const PutGroup&, const Materials&);
template void transfer_materials(const TakeGroup&, Materials&);

bool same(const Materials& a, const Materials& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Material& p, const Material& q) {
    const auto is_same = [&](const auto& s) { return p.*s.member == q.*s.member; };
    return p.name == q.name && std::all_of(std::begin(material_scalars), std::end(material_scalars), is_same);
  });
}

template <class At, class D>
void transfer_domain(const At& at, D& domain) {
  const auto group = at.group("domain");
  group("periodic_x", domain.periodic_x);
  group("periodic_y", domain.periodic_y);
  group("tilt [m]", domain.tilt);
  group("thickness [m]", domain.thickness);
  for (std::size_t side = 0; side < domain.wall.size(); ++side) {
    const auto wall = group.group(side_names[side]);
    wall("present", domain.wall[side].present);
    for (const auto& s : wall_scalars) wall(s.name, domain.wall[side].*s.member);
  }
}
template void transfer_domain(const PutGroup&, const Domain&);
template void transfer_domain(const TakeGroup&, Domain&);

void put_names(const Hdf5Writer& group, const Grains& grains, const Grains* sample) {
  if (!sample || grains.id != sample->id) group.write("id", grains.id);
  if (!sample || grains.radius != sample->radius) group.write("radius", grains.radius, "m");
  if (!sample || grains.material != sample->material) group.write("material", grains.material);
  if (!sample || grains.zone != sample->zone) group.write("zone", grains.zone);
}

void take_names(const Hdf5Reader& group, const Hdf5Reader& sample, Grains& grains) {
  const auto take = [&]<class T>(const char* name, std::vector<T>& values) { values = (group.has(name) ? group : sample).array<T>(name); };
  take("id", grains.id);
  take("radius", grains.radius);
  take("material", grains.material);
  take("zone", grains.zone);
  TakeGroup{group}.same_length({grains.id.size(), grains.radius.size(), grains.material.size(), grains.zone.size()});
}

template <class At, class C>
void transfer_contacts(const At& at, C& contacts, std::size_t grains) {
  const auto group = at.group("contacts");
  group.note("i and j", "places in the arrays of grains, from 0, not ids; j = -1, -2, -3, -4 is the left, right, bottom, top wall");
  group.note("signs", "n points from j to i, t is n turned by +90 degrees, the force on i is fn n + ft t; fn > 0 pushes");
  group.array("i", contacts.i);
  group.array("j", contacts.j);
  transfer_columns(group, contacts, contact_columns, contacts.size());
  group.array("glued", contacts.glued);
  if constexpr (At::reads) {
    group.same_length({contacts.size(), contacts.j.size(), contacts.glued.size()});
    const auto n = static_cast<std::int64_t>(grains);
    for (std::size_t c = 0; c < contacts.size(); ++c)
      if (contacts.i[c] < 0 || contacts.i[c] >= n || contacts.j[c] >= n || contacts.j[c] < wall_partner(top))
        group.at.refuse("names a grain that does not exist");
  }
}
template void transfer_contacts(const PutGroup&, const Contacts&, std::size_t);
template void transfer_contacts(const TakeGroup&, Contacts&, std::size_t);

void check_materials(const Hdf5Reader& at, const Packing& packing) {
  const auto kinds = static_cast<std::int64_t>(packing.materials.size());
  for (const auto m : packing.grains.material)
    if (m < 0 || m >= kinds) at.refuse("names a material that does not exist");
}

template <class At, class P>
void transfer_packing(const At& at, P& packing) {
  const auto group = at.group("packing");
  transfer_materials(group, packing.materials);
  transfer_domain(group, packing.domain);
  const auto grains = group.group("grains");
  if constexpr (At::reads) take_names(grains.at, grains.at, packing.grains);
  else put_names(grains.at, packing.grains, nullptr);
  transfer_columns(grains, packing.grains, grain_state_columns, packing.grains.id.size());
  if constexpr (At::reads) check_materials(group.at, packing);
  transfer_contacts(group, packing.contacts, packing.grains.size());
}
template void transfer_packing(const PutGroup&, const Packing&);
template void transfer_packing(const TakeGroup&, Packing&);

void transfer_history(const PutGroup& at, const char* name, const History& history) {
  const auto group = at.group(name);
  for (const auto& column : history.columns) group.at.write(column.name, column.values, column.unit);
}

void transfer_history(const TakeGroup& at, const char* name, History& history) {
  const auto group = at.group(name).at;
  for (const auto& own : group.names()) history.columns.push_back({own, group.unit(own), group.array<double>(own)});
}

}  // namespace arenite::io
