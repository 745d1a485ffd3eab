#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "io/export/export.hpp"
#include "io/results/groups.hpp"

namespace arenite::io {
namespace {

using Text = std::back_insert_iterator<std::string>;

/// The box along the third axis: of disks their length, of spheres their own.
std::array<double, 2> third_bounds(const Domain& domain) { return {-0.5 * domain.thickness, 0.5 * domain.thickness}; }
std::array<double, 2> third_bounds(const DomainIn<3>& domain) { return {domain.corner().z, domain.corner(1).z}; }
bool third_is_periodic(const Domain& /*domain*/) { return true; }
bool third_is_periodic(const DomainIn<3>& domain) { return domain.periodic[2]; }

/// Edges of the box as LAMMPS writes them; a tilted cell gives the bounds of its bounding box and xy.
template <int D> std::string header(const ExportStateIn<D>& from, const char* what, std::size_t count) {
  const DomainIn<D>& domain = from.snapshot->packing.domain;
  const double x0 = domain.wall[left].position, x1 = domain.wall[right].position, tilt = domain.tilt;
  const auto [z0, z1] = third_bounds(domain);
  const auto flag = [](bool periodic) { return periodic ? "pp" : "ff"; };
  const std::string flags =
      fmt::format("{} {} {}", flag(domain.periodic[0]), flag(domain.periodic[1]), flag(third_is_periodic(domain)));
  std::string text = from.number == 0 ? "ITEM: UNITS\nsi\n" : "";
  fmt::format_to(Text(text), "ITEM: TIME\n{}\nITEM: TIMESTEP\n{}\nITEM: NUMBER OF {}\n{}\n", from.snapshot->time,
                 from.snapshot->step, what, count);
  if (tilt == 0)
    fmt::format_to(Text(text), "ITEM: BOX BOUNDS {}\n{} {}\n{} {}\n{} {}\n", flags, x0, x1,
                   domain.wall[bottom].position, domain.wall[top].position, z0, z1);
  else
    fmt::format_to(Text(text), "ITEM: BOX BOUNDS xy xz yz {}\n{} {} {}\n{} {} 0\n{} {} 0\n", flags,
                   x0 + std::min(tilt, 0.0), x1 + std::max(tilt, 0.0), tilt, domain.wall[bottom].position,
                   domain.wall[top].position, z0, z1);
  return text;
}

/// Columns behind id and type, and a grain's row of them.
constexpr const char* motion_columns(const Grains& /*g*/) { return "x y z radius vx vy vz omegaz angle zone"; }
constexpr const char* motion_columns(const GrainsIn<3>& /*g*/) {
  return "x y z radius vx vy vz omegax omegay omegaz zone";
}
void put_motion(std::string& text, const Grains& g, std::size_t i) {
  fmt::format_to(Text(text), "{} {} 0 {} {} {} 0 {} {} {}", g.position[i].x, g.position[i].y, g.radius[i],
                 g.velocity[i].x, g.velocity[i].y, g.omega[i], g.angle[i], int{g.zone[i]});
}
void put_motion(std::string& text, const GrainsIn<3>& g, std::size_t i) {
  const Vec3 p = g.position[i], v = g.velocity[i], w = g.omega[i];
  fmt::format_to(Text(text), "{} {} {} {} {} {} {} {} {} {} {}", p.x, p.y, p.z, g.radius[i], v.x, v.y, v.z, w.x, w.y,
                 w.z, int{g.zone[i]});
}

/// LAMMPS numbers atoms from one: its 0 is an atom without a number, which it can keep (`add keep`) of no file.
constexpr auto atom_of(auto id) { return id + 1; }

std::vector<int> links_of(const Packing& packing) { return links_of_grains(packing); }
std::vector<int> links_of(const PackingIn<3>& /*packing*/) { return {}; }

template <int D> std::string grain_dump(const ExportStateIn<D>& from) {
  const GrainsIn<D>& g = from.snapshot->packing.grains;
  std::string text = header(from, "ATOMS", g.size()) + "ITEM: ATOMS id type " + motion_columns(g);
  for (const auto& field : from.fields) text += " " + field.name;
  const auto links = links_of(from.snapshot->packing);
  if (!links.empty()) text += " links";
  text += '\n';
  for (std::size_t i = 0; i < g.size(); ++i) {
    fmt::format_to(Text(text), "{} {} ", atom_of(g.id[i]), g.material[i] + 1);
    put_motion(text, g, i);
    for (const auto& field : from.fields) fmt::format_to(Text(text), " {}", field.values[i]);
    if (!links.empty()) fmt::format_to(Text(text), " {}", links[i]);
    text += '\n';
  }
  return text;
}

/// A vector by three components.
void put_vector(std::string& text, Vec2 v) { fmt::format_to(Text(text), " {} {} 0", v.x, v.y); }
void put_vector(std::string& text, Vec3 v) { fmt::format_to(Text(text), " {} {} {}", v.x, v.y, v.z); }

/// What a contact has between its kind and the distance of its centres.
constexpr const char* own_columns(const Contacts& /*c*/) { return " strong glued"; }
constexpr const char* own_columns(const ContactsIn<3>& /*c*/) { return ""; }
void put_own(std::string& text, const Contacts& c, std::size_t k, double mean) {
  fmt::format_to(Text(text), " {} {}", c.fn[k] > mean ? 1 : 0, int{c.glued[k]});
}
void put_own(std::string& /*text*/, const ContactsIn<3>& /*c*/, std::size_t /*k*/, double /*mean*/) {}

/// Contacts between grains only: a row names two grains, which OVITO joins by a bond, and LAMMPS knows no walls here.
/// As in LAMMPS's pair/local of a granular style, the normal force (fx, fy, fz) and the tangential one (p1, p2, p3) act
/// on the first grain; so `arenite measure` reads it back.
template <int D> std::string contact_dump(const ExportStateIn<D>& from) {
  const PackingIn<D>& packing = from.snapshot->packing;
  const ContactsIn<D>& c = packing.contacts;
  const double mean = mean_compressive_force(c);
  std::string rows;
  std::size_t count = 0;
  for (std::size_t k = 0; k < c.size(); ++k) {
    if (c.is_wall(k)) continue;
    const Vec<D> n = c.normal[k];
    fmt::format_to(Text(rows), "{} {}", atom_of(id_of_i(packing, k)), atom_of(id_of_j(packing, k)));
    put_vector(rows, c.fn[k] * n);
    put_vector(rows, cross(c.ft[k], n));
    fmt::format_to(Text(rows), " {}", contact_type(packing, k));
    put_own(rows, c, k, mean);
    fmt::format_to(Text(rows), " {}", c.arm_i[k] + c.arm_j[k]);
    for (const auto& column : columns_of(c)) fmt::format_to(Text(rows), " {}", column.at(c, k));
    if (!c.off_i.empty()) put_vector(rows, packing.grains.position[static_cast<std::size_t>(c.i[k])] + c.lever_i(k));
    rows += '\n';
    ++count;
  }
  std::string text =
      header(from, "ENTRIES", count) + "ITEM: ENTRIES patom1 patom2 fx fy fz p1 p2 p3 type" + own_columns(c) + " dist";
  for (const auto& column : columns_of(c)) text += std::string(" ") + column.name;
  if (!c.off_i.empty()) text += " cx cy cz";
  return text + '\n' + rows;
}

template <int D> std::vector<NamedBytes> lammps_state(const ExportStateIn<D>& state) {
  return {{"grains.dump", grain_dump(state)}, {"contacts.dump", contact_dump(state)}};
}

}  // namespace

const ExportFormat exports::lammps{
    .name = "lammps",
    .sentence = "LAMMPS: dump custom of grains, dump local of contacts (OVITO reads both; no test of ours runs it)",
    .states = {{"grains",
                "place, radius, velocity, angle, omega, zone, stresses and other numbers of grains; type is the "
                "material's number"},
               {"contacts",
                "of grains: forces as pair/local of a granular style has them, arms, overlap; of grains that are no "
                "disks the contact point cx cy cz"},
               {"cell, periodic sides, tilt, time, step, units (si)",
                "as LAMMPS writes them, z of disks by the thickness"},
               {"numbers of grains", "one more than ours: LAMMPS has no atom 0"},
               {"names of materials, shapes of grains", "left out: a type is a number, a grain the disk of its area"},
               {"contacts with walls and boundaries", "left out: LAMMPS's pairs have none; `arenite measure` says so"},
               {"bonds, pulls across gaps",
                "left out: `links` counts those of each grain, and `arenite measure` says that their stress lacks"},
               {"numbers not known of some grain", "nan"}},
    .other_names = {"ovito", "dump"},
    .of_snapshot = lammps_state<2>,
    .of_spheres = lammps_state<3>};

}  // namespace arenite::io
