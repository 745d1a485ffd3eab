#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <vector>

#include "io/export/export.hpp"
#include "io/results/groups.hpp"

namespace arenite::io {
namespace {

using Text = std::back_insert_iterator<std::string>;

/// Edges of the box as LAMMPS writes them; a tilted cell gives the bounds of its bounding box and xy.
std::string header(const ExportSnapshot& from, const char* what, std::size_t count) {
  const Domain& domain = from.snapshot->packing.domain;
  const double x0 = domain.wall[left].position, x1 = domain.wall[right].position;
  const double half = 0.5 * domain.thickness, tilt = domain.tilt;
  const char* x = domain.periodic[0] ? "pp" : "ff";
  const char* y = domain.periodic[1] ? "pp" : "ff";
  std::string text = from.number == 0 ? "ITEM: UNITS\nsi\n" : "";
  fmt::format_to(Text(text), "ITEM: TIME\n{}\nITEM: TIMESTEP\n{}\nITEM: NUMBER OF {}\n{}\n", from.snapshot->time,
                 from.snapshot->step, what, count);
  if (tilt == 0)
    fmt::format_to(Text(text), "ITEM: BOX BOUNDS {} {} pp\n{} {}\n{} {}\n{} {}\n", x, y, x0, x1,
                   domain.wall[bottom].position, domain.wall[top].position, -half, half);
  else
    fmt::format_to(Text(text), "ITEM: BOX BOUNDS xy xz yz {} {} pp\n{} {} {}\n{} {} 0\n{} {} 0\n", x, y,
                   x0 + std::min(tilt, 0.0), x1 + std::max(tilt, 0.0), tilt, domain.wall[bottom].position,
                   domain.wall[top].position, -half, half);
  return text;
}

std::string grain_dump(const ExportSnapshot& from) {
  const Grains& g = from.snapshot->packing.grains;
  std::string text = header(from, "ATOMS", g.size());
  text += "ITEM: ATOMS id type x y z radius vx vy vz omegaz angle zone";
  for (const auto& field : from.fields) text += " " + field.name;
  const auto links = links_of_grains(from.snapshot->packing);
  if (!links.empty()) text += " links";
  text += '\n';
  for (std::size_t i = 0; i < g.size(); ++i) {
    fmt::format_to(Text(text), "{} {} {} {} 0 {} {} {} 0 {} {} {}", g.id[i], g.material[i] + 1, g.position[i].x,
                   g.position[i].y, g.radius[i], g.velocity[i].x, g.velocity[i].y, g.omega[i], g.angle[i],
                   int{g.zone[i]});
    for (const auto& field : from.fields) fmt::format_to(Text(text), " {}", field.values[i]);
    if (!links.empty()) fmt::format_to(Text(text), " {}", links[i]);
    text += '\n';
  }
  return text;
}

/// Contacts between grains only: a row names two grains, which OVITO joins by a bond, and LAMMPS knows no walls here.
/// As in LAMMPS's pair/local of a granular style, the normal force (fx, fy) and the tangential one (p1, p2) act on the
/// first grain; so `arenite measure` reads it back.
std::string contact_dump(const ExportSnapshot& from) {
  const Packing& packing = from.snapshot->packing;
  const Contacts& c = packing.contacts;
  const double mean = mean_compressive_force(c);
  std::string rows;
  std::size_t count = 0;
  for (std::size_t k = 0; k < c.size(); ++k) {
    if (c.is_wall(k)) continue;
    const Vec2 n = c.normal[k], normal = c.fn[k] * n, tangential = c.ft[k] * perpendicular(n);
    fmt::format_to(Text(rows), "{} {} {} {} 0 {} {} 0 {} {} {} {}", id_of_i(packing, k), id_of_j(packing, k), normal.x,
                   normal.y, tangential.x, tangential.y, contact_type(packing, k), c.fn[k] > mean ? 1 : 0,
                   int{c.glued[k]}, c.arm_i[k] + c.arm_j[k]);
    for (const auto& column : contact_columns) fmt::format_to(Text(rows), " {}", column.at(c, k));
    if (const Vec2 point = contact_point(packing, k); !c.off_i.empty())
      fmt::format_to(Text(rows), " {} {} 0", point.x, point.y);
    rows += '\n';
    ++count;
  }
  std::string text = header(from, "ENTRIES", count);
  text += "ITEM: ENTRIES patom1 patom2 fx fy fz p1 p2 p3 type strong glued dist";
  for (const auto& column : contact_columns) text += std::string(" ") + column.name;
  if (!c.off_i.empty()) text += " cx cy cz";
  return text + '\n' + rows;
}

std::vector<NamedBytes> lammps_snapshot(const ExportSnapshot& snapshot) {
  return {{"grains.dump", grain_dump(snapshot)}, {"contacts.dump", contact_dump(snapshot)}};
}

}  // namespace

const ExportFormat exports::lammps{
    .name = "lammps",
    .sentence = "OVITO and LAMMPS tools: dump custom of grains, dump local of contacts",
    .states = {{"grains",
                "place, radius, velocity, angle, omega, zone, stresses and other numbers of grains; type is the "
                "material's number"},
               {"contacts",
                "of grains: forces as pair/local of a granular style has them, arms, overlap; of grains that are no "
                "disks the contact point cx cy cz"},
               {"cell, periodic sides, tilt, time, step, units (si)", "as LAMMPS writes them, z by the thickness"},
               {"names of materials, shapes of grains", "left out: a type is a number, a grain the disk of its area"},
               {"contacts with walls and boundaries", "left out: LAMMPS's pairs have none; `arenite measure` says so"},
               {"bonds, pulls across gaps",
                "left out: `links` counts those of each grain, and `arenite measure` says that their stress lacks"},
               {"numbers not known of some grain", "nan"}},
    .other_names = {"ovito", "dump"},
    .of_snapshot = lammps_snapshot};

}  // namespace arenite::io
