#include <algorithm>
#include <cstdint>
#include <numeric>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/mapped.hpp"
#include "core/option.hpp"
#include "core/text.hpp"
#include "io/export/export.hpp"
#include "io/export/netcdf_file.hpp"
#include "io/results/groups.hpp"

// One netCDF-4 file, which is HDF5 whose dimensions are named: arrays over (time, grain) and (time, side), and the
// contacts of all states in one row, since their number changes (docs/hdf5.md).
namespace arenite::io {
namespace {

template <int D> using States = std::vector<ExportStateIn<D>>;

/// One number of each state.
template <int D, class Value> std::vector<double> by_time(const States<D>& snapshots, Value value) {
  return mapped(snapshots, [&](const auto& f) { return value(*f.snapshot); });
}

/// An array of each state, one after the other.
template <int D, class Array> auto joined(const States<D>& snapshots, Array array) {
  std::decay_t<decltype(array(snapshots.front()))> all;
  for (const auto& f : snapshots) {
    const auto& part = array(f);
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}
/// The grains or contacts of a state.
template <int D> const GrainsIn<D>& owner_in(const ExportStateIn<D>& f, const GrainsIn<D>*) {
  return f.snapshot->packing.grains;
}
template <int D> const ContactsIn<D>& owner_in(const ExportStateIn<D>& f, const ContactsIn<D>*) {
  return f.snapshot->packing.contacts;
}
/// A member or a column of the grains or contacts of each state.
template <int D, class T, class Owner>
std::vector<T> joined(const States<D>& snapshots, std::vector<T> Owner::*member) {
  return joined(
      snapshots, [member](const auto& f) -> auto& { return owner_in(f, static_cast<const Owner*>(nullptr)).*member; });
}
template <int D, class Owner, class V>
std::vector<double> joined(const States<D>& snapshots, const Column<Owner, V>& column) {
  return joined(snapshots, [&](const auto& f) { return column.of(owner_in(f, static_cast<const Owner*>(nullptr))); });
}

template <int D> void put_states(NetcdfFile& file, const States<D>& snapshots) {
  file.dimension("time", by_time(snapshots, [](const auto& f) { return f.time; }),
                 {"s", "time since the start of the run"});
  file.variable("stage", "time", mapped(snapshots, &ExportStateIn<D>::stage), {"", "stage of the loading"});
  file.variable("label", "time", mapped(snapshots, [](const auto& f) { return f.snapshot->label; }),
                {"", "state within its stage"});
  const auto put = [&](const std::string& name, const char* unit, const char* meaning, auto value) {
    file.variable(name, {"time"}, by_time(snapshots, value), {unit, meaning});
  };
  put("step", "1", "time steps since the start", [](const auto& f) { return static_cast<double>(f.step); });
  put("unbalanced_ratio", "1", "mean resultant force on a grain over the mean contact force",
      [](const auto& f) { return f.equilibrium.unbalanced_ratio; });
  put("kinetic_ratio", "1", "kinetic over elastic energy", [](const auto& f) { return f.equilibrium.kinetic_ratio; });
  for (const EnergyTerm& term : energy_terms)
    put(std::string("energy_") + term.name, "J", term.phrase, [&](const auto& f) { return f.energies.*term.value; });
}

/// "0 left, 1 right, .." of the sides of a dimension, or with walls as partners "-1 left, -2 right, ..".
template <int D> std::string numbered_sides(bool as_partners) {
  std::vector<std::string> words;
  for (int side = 0; side < sides_in<D>; ++side)
    words.push_back(std::to_string(as_partners ? wall_partner(side) : side) + " " +
                    any_side_names[static_cast<std::size_t>(side)]);
  return list_of(words);
}

/// Forces along walls: in the plane a number each, in space a vector without its part across the wall.
std::vector<std::pair<std::string, std::vector<double>>> shear_forces(const States<2>& snapshots) {
  std::vector<double> all;
  for (const auto& f : snapshots)
    for (const Wall& wall : f.snapshot->packing.domain.wall) all.push_back(wall.shear_force);
  return {{"wall_shear_force", all}};
}
std::vector<std::pair<std::string, std::vector<double>>> shear_forces(const States<3>& snapshots) {
  std::vector<std::pair<std::string, std::vector<double>>> all;
  for (int axis = 0; axis < 3; ++axis) {
    auto& [name, values] = all.emplace_back(std::string("wall_shear_force_") + "xyz"[axis], std::vector<double>());
    for (const auto& f : snapshots)
      for (const auto& wall : f.snapshot->packing.domain.wall) values.push_back(wall.shear_force[axis]);
  }
  return all;
}

template <int D> void put_walls(NetcdfFile& file, const States<D>& snapshots) {
  std::vector<std::int32_t> side(static_cast<std::size_t>(sides_in<D>));
  std::iota(side.begin(), side.end(), 0);
  file.dimension("side", side, {"1", numbered_sides<D>(false) + "; edges of the cell where periodic"});
  const auto put = [&](const char* name, const char* unit, double WallIn<D>::*member, const char* meaning) {
    std::vector<double> values;
    for (const auto& f : snapshots)
      for (const WallIn<D>& wall : f.snapshot->packing.domain.wall) values.push_back(wall.*member);
    file.variable(name, {"time", "side"}, values, {unit, meaning});
  };
  put("wall_position", "m", &WallIn<D>::position, "along the wall's normal axis");
  put("wall_velocity", "m/s", &WallIn<D>::velocity, "along the wall's normal axis");
  put("wall_force", "N", &WallIn<D>::force, "of the sample on the wall, compression positive");
  for (const auto& [name, values] : shear_forces(snapshots))
    file.variable(name, {"time", "side"}, values, {"N", "along the wall"});
  file.variable("tilt", {"time"}, by_time(snapshots, [](const auto& f) { return f.packing.domain.tilt; }),
                {"m", "shift of the top edge of a sheared cell"});
}

template <int D> void put_grains(NetcdfFile& file, const States<D>& snapshots) {
  const GrainsIn<D>& first = snapshots.front().snapshot->packing.grains;
  for (const auto& f : snapshots)
    if (f.snapshot->packing.grains.id != first.id)
      throw InputError(
          "its states do not have the same grains, so they do not fit in an array over (time, grain); export with " +
          option("last") + ", or as csv");
  file.dimension("grain", first.id, {"1", "id of the grain"});
  const std::vector<std::string> over{"time", "grain"};
  const bool same_radii = std::all_of(snapshots.begin(), snapshots.end(),
                                      [&](const auto& f) { return f.snapshot->packing.grains.radius == first.radius; });
  if (same_radii) file.variable("radius", {"grain"}, first.radius, {"m", ""});
  else file.variable("radius", over, joined(snapshots, &GrainsIn<D>::radius), {"m", ""});
  const std::string names = list_of(mapped(snapshots.front().snapshot->packing.materials, &Material::name));
  file.variable("material", {"grain"}, first.material, {"1", "place in the list of materials: " + names});
  file.variable("zone", over, joined(snapshots, &GrainsIn<D>::zone), {"1", "1 where grains may be glued"});
  for (const auto& column : state_columns(first))
    file.variable(column.name, over, joined(snapshots, column), {column.unit, ""});
  if (snapshots.size() > 1) {
    for (int axis = 0; axis < D; ++axis) {
      const auto moved = joined(snapshots, [&](const auto& f) {
        std::vector<double> along(first.size(), 0.0);
        for (std::size_t g = 0; g < f.displacement.size(); ++g) along[g] = f.displacement[g][axis];
        return along;
      });
      const std::string name(1, "xyz"[axis]);
      file.variable("u" + name, over, moved, {"m", "displacement along " + name + " since the first state"});
    }
  }
  for (std::size_t k = 0; k < snapshots.front().fields.size(); ++k) {
    const GrainField& field = snapshots.front().fields[k];
    if (std::any_of(snapshots.begin(), snapshots.end(),
                    [&](const auto& f) { return f.fields.size() <= k || f.fields[k].name != field.name; }))
      continue;
    const auto values = joined(
        snapshots, [k](const auto& f) -> auto& { return f.fields[k].values; });
    file.variable(field.name, over, values,
                  {field.unit, field.unit == "Pa" ? "stress of the grain, tension positive" : ""});
  }
}

template <int D> void put_contacts(NetcdfFile& file, const States<D>& snapshots) {
  std::vector<std::int32_t> state;
  for (std::size_t t = 0; t < snapshots.size(); ++t)
    state.resize(state.size() + snapshots[t].snapshot->packing.contacts.size(), static_cast<std::int32_t>(t));
  std::vector<std::int32_t> number(state.size());
  std::iota(number.begin(), number.end(), 0);
  const auto ids = [&](std::int64_t (*id_of)(const PackingIn<D>&, std::size_t)) {
    return joined(snapshots, [&](const auto& f) {
      return by_contact(f.snapshot->packing, [&](std::size_t c) { return id_of(f.snapshot->packing, c); });
    });
  };
  file.dimension("contact", number, {"1", "contacts of all states, one after the other"});
  file.variable("contact_state", {"contact"}, state,
                {"1", "index along time of the state that the contact belongs to"});
  file.variable("contact_i", {"contact"}, ids(id_of_i<D>), {"1", "id of the grain"});
  file.variable("contact_j", {"contact"}, ids(id_of_j<D>),
                {"1", "id of the other grain; walls are " + numbered_sides<D>(true)});
  for (const auto& column : columns_of(snapshots.front().snapshot->packing.contacts))
    file.variable(std::string("contact_") + column.name, {"contact"}, joined(snapshots, column), {column.unit, ""});
  file.variable("contact_glued", {"contact"}, joined(snapshots, &ContactsIn<D>::glued), {"1", "1 where adhesion acts"});
}

constexpr const char* signs_of(const Domain& /*domain*/) {
  return "contact_n points from j to i, t is n turned by +90 degrees, the force on i is fn n + ft t (fn > 0 is "
         "repulsive); stress is positive in tension";
}
constexpr const char* signs_of(const DomainIn<3>& /*domain*/) {
  return "contact_n points from j to i, the force on i is fn n + ft x n (fn > 0 is repulsive); stress is positive in "
         "tension";
}
void put_thickness(const NetcdfFile& file, const Domain& domain) { file.attribute("thickness_m", domain.thickness); }
void put_thickness(const NetcdfFile& /*file*/, const DomainIn<3>& /*domain*/) {}

template <int D> std::vector<NamedBytes> netcdf_loading(const States<D>& snapshots, const Provenance& provenance) {
  NetcdfFile file;
  const DomainIn<D>& domain = snapshots.front().snapshot->packing.domain;
  file.attribute("source", "Arenite " + provenance.version);
  file.attribute("input_hash", provenance.input_hash);
  file.attribute("recipe", provenance.recipe);
  file.attribute("signs", signs_of(domain));
  std::string periodic;
  for (int axis = 0; axis < D; ++axis)
    if (domain.periodic[axis]) periodic += "xyz"[axis];
  file.attribute("periodic", periodic);
  put_thickness(file, domain);
  put_states(file, snapshots);
  put_walls(file, snapshots);
  put_grains(file, snapshots);
  put_contacts(file, snapshots);
  return {{"loading.nc", file.bytes()}};
}

}  // namespace

const ExportFormat exports::netcdf{
    .name = "netcdf",
    .sentence = "xarray and netCDF tools: all states in one file, arrays over (time, grain)",
    .states = {{"grains",
                "place, radius, material with its name, zone, velocity, angle, omega, displacement, stresses and other "
                "numbers of grains, over (time, grain)"},
               {"contacts",
                "of all states in one row, with grains and walls: forces, normal, arms, overlap; contact_state says of "
                "which state"},
               {"walls, periodic sides, tilt, thickness, energies, equilibrium, stage, recipe",
                "as arrays over time and as attributes"},
               {"boundaries, bonds, shapes of grains", "left out"},
               {"states of different grains", "refused"},
               {"numbers not known", "NaN"}},
    .other_names = {"xarray", "nc"},
    .of_loading = netcdf_loading<2>,
    .of_sphere_loading = netcdf_loading<3>};

}  // namespace arenite::io
