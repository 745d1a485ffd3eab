#pragma once
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/mapped.hpp"
#include "io/disk/store_file.hpp"
#include "io/hdf5/group.hpp"
#include "model/result.hpp"

namespace arenite::io {

/// Refuses a file of version 0.1, which kept its numbers as a text, and what a film gave as its "swing".
void refuse_version_01(const Hdf5Group& file, const std::filesystem::path& path);

/// The result of a whole file of that kind, by the function that transfers it.
template <class Result>
void write_result_file(const std::filesystem::path& path, std::string_view kind,
                       void (*transfer)(const Hdf5Group&, Result&), const Result& result, bool compress = true) {
  const Hdf5Group file(compress);
  transfer(file, const_cast<Result&>(result));  // which does not change what it writes
  write_checksummed(path, kind, file.bytes());
}
template <class Result>
Result read_result_file(const std::filesystem::path& path, std::string_view kind,
                        void (*transfer)(const Hdf5Group&, Result&)) {
  const Hdf5Group file(read_checksummed(path, kind), path.string());
  refuse_version_01(file, path);
  Result result;
  transfer(file, result);
  return result;
}

/// A column of real numbers: name, SI unit ("1" if it has none) and where it lives, as numbers or as one coordinate of
/// vectors. Every format takes its columns here.
template <class Owner, class V = Vec2> struct Column {
  const char* name;
  const char* unit;
  std::vector<double> Owner::*numbers = nullptr;
  std::vector<V> Owner::*vectors = nullptr;
  double V::*axis = nullptr;

  constexpr Column(const char* n, const char* u, std::vector<double> Owner::*of) : name(n), unit(u), numbers(of) {}
  constexpr Column(const char* n, const char* u, std::vector<V> Owner::*of, double V::*along)
      : name(n),
        unit(u),
        vectors(of),
        axis(along) {}

  double at(const Owner& owner, std::size_t row) const {
    return numbers ? (owner.*numbers)[row] : (owner.*vectors)[row].*axis;
  }
  std::vector<double> of(const Owner& owner) const { return numbers ? owner.*numbers : mapped(owner.*vectors, axis); }
  void set(Owner& owner, std::vector<double> values) const {
    if (numbers) {
      owner.*numbers = std::move(values);
      return;
    }
    auto& to = owner.*vectors;
    to.resize(values.size());
    for (std::size_t k = 0; k < to.size(); ++k) to[k].*axis = values[k];
  }
};

/// What changes from snapshot to snapshot; radius, id, material and zone do not.
inline constexpr Column<Grains> grain_state_columns[] = {
    {"x", "m", &Grains::position, &Vec2::x},    {"y", "m", &Grains::position, &Vec2::y},
    {"angle", "rad", &Grains::angle},           {"vx", "m/s", &Grains::velocity, &Vec2::x},
    {"vy", "m/s", &Grains::velocity, &Vec2::y}, {"omega", "rad/s", &Grains::omega}};

inline constexpr Column<Contacts> contact_columns[] = {{"nx", "1", &Contacts::normal, &Vec2::x},
                                                       {"ny", "1", &Contacts::normal, &Vec2::y},
                                                       {"fn", "N", &Contacts::fn},
                                                       {"ft", "N", &Contacts::ft},
                                                       {"arm_i", "m", &Contacts::arm_i},
                                                       {"arm_j", "m", &Contacts::arm_j},
                                                       {"overlap", "m", &Contacts::overlap},
                                                       {"sliding_velocity", "m/s", &Contacts::sliding_velocity}};

/// The same of spheres and their contacts.
inline constexpr Column<GrainsIn<3>, Vec3> sphere_state_columns[] = {
    {"x", "m", &GrainsIn<3>::position, &Vec3::x},        {"y", "m", &GrainsIn<3>::position, &Vec3::y},
    {"z", "m", &GrainsIn<3>::position, &Vec3::z},        {"angle_x", "rad", &GrainsIn<3>::angle, &Vec3::x},
    {"angle_y", "rad", &GrainsIn<3>::angle, &Vec3::y},   {"angle_z", "rad", &GrainsIn<3>::angle, &Vec3::z},
    {"vx", "m/s", &GrainsIn<3>::velocity, &Vec3::x},     {"vy", "m/s", &GrainsIn<3>::velocity, &Vec3::y},
    {"vz", "m/s", &GrainsIn<3>::velocity, &Vec3::z},     {"omega_x", "rad/s", &GrainsIn<3>::omega, &Vec3::x},
    {"omega_y", "rad/s", &GrainsIn<3>::omega, &Vec3::y}, {"omega_z", "rad/s", &GrainsIn<3>::omega, &Vec3::z}};
inline constexpr Column<ContactsIn<3>, Vec3> sphere_contact_columns[] = {
    {"nx", "1", &ContactsIn<3>::normal, &Vec3::x},
    {"ny", "1", &ContactsIn<3>::normal, &Vec3::y},
    {"nz", "1", &ContactsIn<3>::normal, &Vec3::z},
    {"fn", "N", &ContactsIn<3>::fn},
    {"ft_x", "N", &ContactsIn<3>::ft, &Vec3::x},
    {"ft_y", "N", &ContactsIn<3>::ft, &Vec3::y},
    {"ft_z", "N", &ContactsIn<3>::ft, &Vec3::z},
    {"arm_i", "m", &ContactsIn<3>::arm_i},
    {"arm_j", "m", &ContactsIn<3>::arm_j},
    {"overlap", "m", &ContactsIn<3>::overlap},
    {"sliding_velocity_x", "m/s", &ContactsIn<3>::sliding_velocity, &Vec3::x},
    {"sliding_velocity_y", "m/s", &ContactsIn<3>::sliding_velocity, &Vec3::y},
    {"sliding_velocity_z", "m/s", &ContactsIn<3>::sliding_velocity, &Vec3::z}};

/// The columns of grains and contacts of either kind.
constexpr std::span<const Column<Grains>> state_columns(const Grains&) { return grain_state_columns; }
constexpr std::span<const Column<GrainsIn<3>, Vec3>> state_columns(const GrainsIn<3>&) { return sphere_state_columns; }
constexpr std::span<const Column<Contacts>> columns_of(const Contacts&) { return contact_columns; }
constexpr std::span<const Column<ContactsIn<3>, Vec3>> columns_of(const ContactsIn<3>&) {
  return sphere_contact_columns;
}

/// Of contacts of grains that are no disks; files of disks have none.
inline constexpr Column<Contacts> lever_columns[] = {{"off_i_x", "m", &Contacts::off_i, &Vec2::x},
                                                     {"off_i_y", "m", &Contacts::off_i, &Vec2::y},
                                                     {"off_j_x", "m", &Contacts::off_j, &Vec2::x},
                                                     {"off_j_y", "m", &Contacts::off_j, &Vec2::y}};

/// Displacements and stresses of a field's nodes.
inline constexpr Column<StressField> field_columns[] = {{"ux", "m", &StressField::ux},
                                                        {"uy", "m", &StressField::uy},
                                                        {"sigma_xx", "Pa", &StressField::xx},
                                                        {"sigma_yy", "Pa", &StressField::yy},
                                                        {"sigma_xy", "Pa", &StressField::xy}};

/// Displacements and stresses of a sample in space.
struct VoxelColumn {
  const char *name, *unit;
  std::vector<float> VoxelStress::*values;
};
inline constexpr VoxelColumn voxel_columns[] = {
    {"ux", "m", &VoxelStress::ux},        {"uy", "m", &VoxelStress::uy},        {"uz", "m", &VoxelStress::uz},
    {"sigma_xx", "Pa", &VoxelStress::xx}, {"sigma_yy", "Pa", &VoxelStress::yy}, {"sigma_zz", "Pa", &VoxelStress::zz},
    {"sigma_yz", "Pa", &VoxelStress::yz}, {"sigma_xz", "Pa", &VoxelStress::xz}, {"sigma_xy", "Pa", &VoxelStress::xy}};

/// All columns of an owner, of which each has `size` values, or none where it may lack them.
template <class Owner, class Columns>
void transfer_columns(const Hdf5Group& at, Owner& owner, const Columns& columns, std::size_t size,
                      bool may_lack = false) {
  for (const auto& c : columns) {
    std::vector<double> values = c.of(owner);
    at.array(c.name, values, c.unit);
    if (!values.empty() || !may_lack) at.same_length({values.size(), size});
    if (at.reads()) c.set(owner, std::move(values));
  }
}

/// Points as the arrays x and y, m.
void transfer_points(const Hdf5Group& at, std::vector<Vec2>& points);
void transfer_points(const Hdf5Group& at, std::vector<Vec3>& points);

/// What made a result, its name and how it ended, as the groups "provenance" and "outcome"; the file itself says in its
/// attributes what it is.
void transfer_provenance(const Hdf5Group& at, Provenance& provenance);
template <class Result> void transfer_origin(const Hdf5Group& at, Result& result) {
  at.note("source", "Arenite " + result.provenance.version);
  at.note("stage", result.name);
  at.note(
      "layout",
      "docs/hdf5.md of Arenite describes the layout; `arenite export --to netcdf` writes arrays over (time, grain)");
  transfer_provenance(at.group("provenance"), result.provenance);
  const auto outcome = at.group("outcome");
  outcome("name", result.name);
  outcome("converged", result.converged);
  outcome("outcome", result.outcome);
}

void transfer_materials(const Hdf5Group& at, Materials& materials);
template <int D> void transfer_domain(const Hdf5Group& at, DomainIn<D>& domain);

/// Grains. What does not change while they move is not written where the sample (or null) has the same, and then read
/// from there. Grains of materials that do not exist are refused.
template <int D> void transfer_grains(const Hdf5Group& at, PackingIn<D>& packing, const GrainsIn<D>* sample);
template <int D> void transfer_names(const Hdf5Group& grains_at, GrainsIn<D>& grains, const GrainsIn<D>* sample);

/// Contacts; those of grains, or of elements of boundaries, that do not exist are refused.
template <int D> void transfer_contacts(const Hdf5Group& at, PackingIn<D>& packing);

/// Refuses items that join grains which do not exist.
template <class Items>
void check_ends(const Hdf5Group& at, const Items& items, std::size_t grains, const char* refusal) {
  if (!at.reads()) return;
  for (const auto& item : items)
    for (const std::int32_t g : {item.i, item.j})
      if (g < 0 || static_cast<std::size_t>(g) >= grains) at.refuse(refusal);
}

/// A whole packing of the plane as the group "packing".
void transfer_packing(const Hdf5Group& at, Packing& packing);

/// The phases of a map in its group; those that do not exist are refused.
void transfer_phases(const Hdf5Group& map_at, std::vector<Phase>& phases, Shape shape);
/// Refuses a map that was read and is not sound.
template <class Map> void refuse_unsound(const Hdf5Group& map_at, const Map& map) {
  if (!map_at.reads()) return;
  try {
    check(map);
  } catch (const InputError& error) { map_at.refuse(error.what()); }
}

void transfer_history(const Hdf5Group& at, const char* name, History& history);

/// A tree of numbers as a table in a group: a row a node, parents before what they hold, with `name` (path with dots),
/// `depth`, `kind` (Numbers::Kind), `value` (NaN where it is no number) and `text`.
void transfer_numbers(const Hdf5Group& at, const std::string& name, Numbers& numbers);

}  // namespace arenite::io
