#include <hdf5_hl.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "core/mapped.hpp"
#include "core/text.hpp"
#include "io/export/export.hpp"
#include "io/hdf5/handle.hpp"
#include "io/results/groups.hpp"

// One netCDF-4 file, which is HDF5 whose dimensions are named: arrays over (time, grain) and (time, side), and the
// contacts of all states in one row, since their number changes (docs/hdf5.md).
namespace arenite::io {
namespace {

class NetcdfFile {
 public:
  NetcdfFile() {
    const auto access = memory_properties(), creation = timeless(H5P_FILE_CREATE);
    done(H5Pset_link_creation_order(*creation, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED));
    file_ = made(H5Fcreate(unused_name().c_str(), H5F_ACC_TRUNC, *creation, *access), H5Fclose);
  }

  struct About {
    std::string units, long_name;
  };

  /// A dimension with its coordinate.
  template <class T> void dimension(const std::string& name, const std::vector<T>& values, const About& about) {
    const auto set = put(name, {name}, values, about);
    done(H5DSset_scale(*set, name.c_str()));
    scale_[name] = set;
  }

  /// An array over dimensions that are there.
  template <class T>
  void variable(const std::string& name, const std::vector<std::string>& dimensions, const std::vector<T>& values,
                const About& about) {
    const auto set = put(name, dimensions, values, about);
    for (std::size_t d = 0; d < dimensions.size(); ++d)
      done(H5DSattach_scale(*set, *scale_.at(dimensions[d]), static_cast<unsigned>(d)));
  }

  void variable(const std::string& name, const std::string& dimension, const std::vector<std::string>& values,
                const About& about) {
    auto texts = mapped(values, [](const auto& value) { return value.c_str(); });
    const auto type = text_type(std::nullopt), set = put(name, {dimension}, *type, texts.size(), false, texts.data());
    attribute(*set, "long_name", about.long_name);
    done(H5DSattach_scale(*set, *scale_.at(dimension), 0));
  }

  void attribute(const std::string& name, const std::string& text) const { attribute(*file_, name, text); }
  void attribute(const std::string& name, double value) const { write_number(*file_, name, value); }

  std::string bytes() const { return bytes_of_file(*file_); }

 private:
  static void attribute(hid_t owner, const std::string& name, const std::string& text) {
    const auto type = text_type(std::nullopt);
    const char* pointer = text.c_str();
    write_attribute(owner, name, *type, static_cast<const void*>(&pointer));
  }

  Hdf5Handle put(const std::string& name, const std::vector<std::string>& dimensions, hid_t type, std::size_t count,
                 bool compress, const void* values) {
    const auto size = mapped<hsize_t>(dimensions, [&](const auto& d) { return d == name ? count : size_.at(d); });
    if (dimensions.front() == name) size_[name] = count;
    const auto properties = timeless(H5P_DATASET_CREATE);
    done(H5Pset_attr_creation_order(*properties, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED));
    if (compress && count * 8 >= 4096) {
      std::vector<hsize_t> chunk = size;
      chunk.back() = std::min<hsize_t>(chunk.back(), 131'072);
      if (chunk.size() > 1) chunk.front() = std::clamp<hsize_t>(131'072 / chunk.back(), 1, chunk.front());
      pack(*properties, chunk, true, 2);
    }
    return write_set(*file_, name, size, type, *properties, values);
  }

  template <class T>
  Hdf5Handle put(const std::string& name, const std::vector<std::string>& dimensions, const std::vector<T>& values,
                 const About& about) {
    const auto set = put(name, dimensions, number_type<T>(), values.size(), true, values.data());
    if (!about.units.empty()) attribute(*set, "units", about.units);
    if (!about.long_name.empty()) attribute(*set, "long_name", about.long_name);
    return set;
  }

  Hdf5Handle file_;
  std::map<std::string, Hdf5Handle> scale_;
  std::map<std::string, hsize_t> size_;
};

using Snapshots = std::vector<ExportSnapshot>;

/// One number of each state.
template <class Value> std::vector<double> by_time(const Snapshots& snapshots, Value value) {
  return mapped(snapshots, [&](const auto& f) { return value(*f.snapshot); });
}

/// An array of each state, one after the other.
template <class Array> auto joined(const Snapshots& snapshots, Array array) {
  std::decay_t<decltype(array(snapshots.front()))> all;
  for (const auto& f : snapshots) {
    const auto& part = array(f);
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}
/// A member of the grains or contacts of each state.
template <class Owner> const Owner& part_of(const ExportSnapshot& f) {
  if constexpr (std::is_same_v<Owner, Grains>) return f.snapshot->packing.grains;
  else return f.snapshot->packing.contacts;
}
template <class T, class Owner> std::vector<T> joined(const Snapshots& snapshots, std::vector<T> Owner::*member) {
  return joined(
      snapshots, [member](const ExportSnapshot& f) -> auto& { return part_of<Owner>(f).*member; });
}
template <class Owner> std::vector<double> joined(const Snapshots& snapshots, const Column<Owner>& column) {
  return joined(snapshots, [&](const ExportSnapshot& f) { return column.of(part_of<Owner>(f)); });
}

void put_states(NetcdfFile& file, const Snapshots& snapshots) {
  file.dimension("time", by_time(snapshots, [](const Snapshot& f) { return f.time; }),
                 {"s", "time since the start of the run"});
  file.variable("stage", "time", mapped(snapshots, &ExportSnapshot::stage), {"", "stage of the loading"});
  file.variable("label", "time", mapped(snapshots, [](const auto& f) { return f.snapshot->label; }),
                {"", "state within its stage"});
  const auto put = [&](const std::string& name, const char* unit, const char* meaning, auto value) {
    file.variable(name, {"time"}, by_time(snapshots, value), {unit, meaning});
  };
  put("step", "1", "time steps since the start", [](const Snapshot& f) { return static_cast<double>(f.step); });
  put("unbalanced_ratio", "1", "mean resultant force on a grain over the mean contact force",
      [](const Snapshot& f) { return f.equilibrium.unbalanced_ratio; });
  put("kinetic_ratio", "1", "kinetic over elastic energy",
      [](const Snapshot& f) { return f.equilibrium.kinetic_ratio; });
  for (const EnergyTerm& term : energy_terms)
    put(std::string("energy_") + term.name, "J", term.phrase,
        [&](const Snapshot& f) { return f.energies.*term.value; });
}

void put_walls(NetcdfFile& file, const Snapshots& snapshots) {
  file.dimension("side", std::vector<std::int32_t>{left, right, bottom, top},
                 {"1", "0 left, 1 right, 2 bottom, 3 top; edges of the cell where periodic"});
  const auto put = [&](const char* name, const char* unit, double Wall::*member, const char* meaning) {
    std::vector<double> values;
    for (const auto& f : snapshots)
      for (const Wall& wall : f.snapshot->packing.domain.wall) values.push_back(wall.*member);
    file.variable(name, {"time", "side"}, values, {unit, meaning});
  };
  put("wall_position", "m", &Wall::position, "along the wall's normal axis");
  put("wall_velocity", "m/s", &Wall::velocity, "along the wall's normal axis");
  put("wall_force", "N", &Wall::force, "of the sample on the wall, compression positive");
  put("wall_shear_force", "N", &Wall::shear_force, "along the wall");
  file.variable("tilt", {"time"}, by_time(snapshots, [](const Snapshot& f) { return f.packing.domain.tilt; }),
                {"m", "shift of the top edge of a sheared cell"});
}

void put_grains(NetcdfFile& file, const Snapshots& snapshots) {
  const Grains& first = snapshots.front().snapshot->packing.grains;
  for (const auto& f : snapshots)
    if (f.snapshot->packing.grains.id != first.id)
      throw InputError(
          "its states do not have the same grains, so they do not fit in an array over (time, grain); export with "
          "--last, or as csv");
  file.dimension("grain", first.id, {"1", "id of the grain"});
  const std::vector<std::string> over{"time", "grain"};
  const bool same_radii = std::all_of(snapshots.begin(), snapshots.end(),
                                      [&](const auto& f) { return f.snapshot->packing.grains.radius == first.radius; });
  if (same_radii) file.variable("radius", {"grain"}, first.radius, {"m", ""});
  else file.variable("radius", over, joined(snapshots, &Grains::radius), {"m", ""});
  const std::string names = list_of(mapped(snapshots.front().snapshot->packing.materials, &Material::name));
  file.variable("material", {"grain"}, first.material, {"1", "place in the list of materials: " + names});
  file.variable("zone", over, joined(snapshots, &Grains::zone), {"1", "1 where grains may be glued"});
  for (const auto& column : grain_state_columns)
    file.variable(column.name, over, joined(snapshots, column), {column.unit, ""});
  if (snapshots.size() > 1) {
    const auto moved = [&](double Vec2::*axis) {
      return joined(snapshots, [&](const auto& f) {
        return f.displacement.empty() ? std::vector<double>(first.size(), 0.0) : mapped(f.displacement, axis);
      });
    };
    file.variable("ux", over, moved(&Vec2::x), {"m", "displacement along x since the first state"});
    file.variable("uy", over, moved(&Vec2::y), {"m", "displacement along y since the first state"});
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

void put_contacts(NetcdfFile& file, const Snapshots& snapshots) {
  std::vector<std::int32_t> state;
  for (std::size_t t = 0; t < snapshots.size(); ++t)
    state.resize(state.size() + snapshots[t].snapshot->packing.contacts.size(), static_cast<std::int32_t>(t));
  std::vector<std::int32_t> number(state.size());
  std::iota(number.begin(), number.end(), 0);
  const auto ids = [&](std::int64_t (*id_of)(const Packing&, std::size_t)) {
    return joined(snapshots, [&](const ExportSnapshot& f) {
      return by_contact(f.snapshot->packing, [&](std::size_t c) { return id_of(f.snapshot->packing, c); });
    });
  };
  file.dimension("contact", number, {"1", "contacts of all states, one after the other"});
  file.variable("contact_state", {"contact"}, state,
                {"1", "index along time of the state that the contact belongs to"});
  file.variable("contact_i", {"contact"}, ids(id_of_i), {"1", "id of the grain"});
  file.variable("contact_j", {"contact"}, ids(id_of_j),
                {"1", "id of the other grain; walls are -1 left, -2 right, -3 bottom, -4 top"});
  for (const auto& column : contact_columns)
    file.variable(std::string("contact_") + column.name, {"contact"}, joined(snapshots, column), {column.unit, ""});
  file.variable("contact_glued", {"contact"}, joined(snapshots, &Contacts::glued), {"1", "1 where adhesion acts"});
}

std::vector<NamedBytes> netcdf_loading(const Snapshots& snapshots, const Provenance& provenance) {
  NetcdfFile file;
  file.attribute("source", "Arenite " + provenance.version);
  file.attribute("input_hash", provenance.input_hash);
  file.attribute("recipe", provenance.recipe);
  file.attribute("signs",
                 "contact_n points from j to i, t is n turned by +90 degrees, the force on i is fn n + ft t (fn > 0 is "
                 "repulsive); stress is positive in tension");
  const auto& periodic = snapshots.front().snapshot->packing.domain.periodic;
  file.attribute("periodic", std::string(periodic[0] ? "x" : "") + (periodic[1] ? "y" : ""));
  file.attribute("thickness_m", snapshots.front().snapshot->packing.domain.thickness);
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
    .of_loading = netcdf_loading};

}  // namespace arenite::io
