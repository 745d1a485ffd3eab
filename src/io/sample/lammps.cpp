#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/mapped.hpp"
#include "core/option.hpp"
#include "core/text.hpp"
#include "io/sample/formats.hpp"
#include "io/sample/lammps_dump.hpp"
#include "io/sample/named_columns.hpp"
#include "io/sample/pair_columns.hpp"

namespace arenite::io {
namespace {

bool is_dump(std::string_view first_line) { return first_line.starts_with("ITEM:"); }

bool is_opaque(std::string_view name) { return name.starts_with("c_") || name.starts_with("f_"); }

constexpr char axis_letters[] = {'x', 'y', 'z'};

/// Names of the columns of a pair: its grains, and normal and tangential force along the axes of the sample.
std::vector<std::string> pair_columns(const std::vector<int>& axes) {
  std::vector<std::string> names{"patom1", "patom2"};
  for (const int axis : axes) names.push_back(std::string("f") + axis_letters[axis]);
  for (const int axis : axes) names.push_back("p" + std::to_string(axis + 1));
  return names;
}

/// What to write for a dump whose columns nobody can tell apart: an example that has as many.
std::string missing_columns(const std::vector<std::string_view>& names, const std::vector<int>& axes) {
  const auto pair = pair_columns(axes);
  const auto half = pair.begin() + 2 + std::ssize(axes);
  const std::string normal = list_of(std::vector(pair.begin() + 2, half), " "),
                    tangential = list_of(std::vector(half, pair.end()), " ");
  std::string found, example;
  std::size_t next = 0;
  for (const auto& name : names) {
    found.append(found.empty() ? "" : " ").append(name);
    const bool known = is_opaque(name) && next < pair.size();
    example.append(example.empty() ? "" : ",").append(known ? pair[next++] : "-");
  }
  return fmt::format(
      "it is not known which of the columns ({}) are the two grains and the force; name them in their order with {}, "
      "with \"-\" for those not needed, e.g. {} \"{}\" (patom1 patom2 of property/local, {} and the tangential {} of "
      "pair/local; {} alone are the whole force, as in LIGGGHTS's \"id force\": patom1,patom2,-,{})",
      found, option("columns"), option("columns"), next == pair.size() ? example : "-," + list_of(pair, ","), normal,
      tangential, normal, axes.size() > 2 ? "fx,fy,fz" : "fx,fy,-");
}

/// Names columns that LAMMPS named after computes by what they hold, and says so.
void name_opaque_columns(Table& entries, const RawGrains& grains, std::vector<std::string>& notes) {
  std::vector<std::size_t> at;
  for (std::size_t c = 0; c < entries.columns.size(); ++c)
    if (is_opaque(entries.columns[c].name)) at.push_back(c);
  const auto found = find_pair_columns(mapped(entries.rows, &Table::Row::cells), at, grains);
  if (found.empty()) return;
  const auto names = pair_columns(grains.axes());
  std::vector<std::string> taken;
  for (std::size_t k = 0; k < found.size(); ++k) {
    std::string& name = entries.columns[found[k]].name;
    taken.push_back(fmt::format("{} as {}", name, names[k]));
    name = names[k];
  }
  notes.push_back(fmt::format("Columns of pairs are taken by what they hold: {}; {} names them otherwise.",
                              list_of(taken), option("columns")));
}

/// The options with the units that the dump states.
SampleOptions with_units(SampleOptions options, const std::optional<StatedUnits>& units) {
  if (!units) return options;
  options.length_unit = units->length;
  options.force_unit = units->force;
  return options;
}

RawCell scaled_by(RawCell cell, double length) {
  cell.corner = length * cell.corner;
  for (Vec3& edge : cell.edge) edge = length * edge;
  return cell;
}

/// Coordinates of atoms: in the dump's unit, wrapped or not, or as fractions of the edges of the cell.
struct AtomColumns {
  std::array<std::optional<std::size_t>, 3> place;
  bool scaled = false;

  explicit AtomColumns(const Table& atoms) {
    for (const char* ending : {"", "u", "s", "su"}) {
      for (int axis = 0; axis < 3; ++axis) place[axis] = atoms.find({std::string(1, axis_letters[axis]) + ending});
      scaled = *ending == 's';
      if (place[0] && place[1]) return;
    }
  }
};

void place_in_cell(std::vector<RawGrain>& rows, const RawCell& cell) {
  for (RawGrain& g : rows)
    g.place = cell.corner + g.place.x * cell.edge[0] + g.place.y * cell.edge[1] + g.place.z * cell.edge[2];
}

RawGrains read_lammps_atoms(const Reading& reading) {
  RawGrains grains;
  Problems& problems = reading.problems;
  DumpSnapshot dump = read_dump(reading);
  DumpItem* item = dump.find("ATOMS");
  if (!item) {
    if (!problems.any()) problems.add("the last snapshot has no \"ITEM: ATOMS\"; write the grains with `dump custom`");
    return grains;
  }
  Table& atoms = item->table;
  check_count(dump, atoms, "NUMBER OF ATOMS", problems);
  name_columns(atoms, split_blanks(item->title.substr(5)));
  check_rows(atoms, problems);
  const AtomColumns columns(atoms);
  const std::pair<const char*, std::optional<std::size_t>> wanted[] = {{"id", atoms.find({"id"})},
                                                                       {"x", columns.place[0]},
                                                                       {"y", columns.place[1]},
                                                                       {"z", columns.place[2]},
                                                                       {"radius", atoms.find({"radius"})},
                                                                       {"diameter", atoms.find({"diameter"})},
                                                                       {"material", atoms.find({"type", "element"})},
                                                                       {"links", atoms.find({"links"})}};
  name_columns(atoms, std::vector<std::string_view>(atoms.columns.size()));
  for (const auto& [name, at] : wanted)
    if (at) atoms.columns[*at] = {name, columns.scaled && name[1] == '\0' ? "m" : "", {}};
  constexpr const char* needed = "dump id type x y z radius";
  if (!atoms.find({"id"})) problems.add(atoms.header_line, "there is no column \"id\"; {}", needed);
  if (columns.scaled && columns.place[0] && !dump.cell)
    problems.add(atoms.header_line, "coordinates are fractions of a box that the dump does not state; dump x y");
  if (problems.any()) atoms.rows.clear();
  const SampleOptions options = with_units(reading.options, dump.units);
  grains = grains_in(atoms, needed, options, problems);
  grains.units = dump.units;
  if (dump.cell) grains.stated = scaled_by(*dump.cell, options.length());
  if (columns.scaled && grains.stated) place_in_cell(grains.rows, *grains.stated);
  if (!options.length_unit) grains.notes.push_back(assumed_unit_of(options, dump.system, "length", "m", "length-unit"));
  return grains;
}

/// Says so where both dumps state a box and the boxes differ: those of the grains and of the contacts are of one
/// sample.
void compare_boxes(const RawGrains& grains, const RawCell& other, std::vector<std::string>& notes) {
  if (!grains.stated) return;
  const RawCell& cell = *grains.stated;
  double difference = norm(cell.corner - other.corner), size = 0;
  for (int axis = 0; axis < 3; ++axis) {
    difference += norm(cell.edge[axis] - other.edge[axis]);
    size += norm(cell.edge[axis]);
  }
  const auto words = [](const RawCell& of) {
    return fmt::format("{:g} x {:g} x {:g} m from ({:g}, {:g}, {:g})", of.edge[0].x, of.edge[1].y, of.edge[2].z,
                       of.corner.x, of.corner.y, of.corner.z);
  };
  if (difference > 1e-5 * size)
    notes.push_back(
        fmt::format("The contacts' dump states another box ({}) than the grains' ({}); the grains' was taken.",
                    words(other), words(cell)));
}

/// The units of the grains hold for contacts that state none; other ones are a problem.
std::optional<StatedUnits> common_units(const std::optional<StatedUnits>& of_grains,
                                        const std::optional<StatedUnits>& of_contacts, Problems& problems) {
  if (of_grains && of_contacts && of_grains->name != of_contacts->name)
    problems.add("the contacts are in units {}, the grains in units {}; write both in the same", of_contacts->name,
                 of_grains->name);
  return of_contacts ? of_contacts : of_grains;
}

/// A vector whose components are columns of these names; those that are not there are 0.
struct DumpedVector {
  std::array<std::optional<std::size_t>, 3> at;
  DumpedVector(const Table& table, std::array<const char*, 3> names) {
    for (std::size_t k = 0; k < 3; ++k) at[k] = table.find({names[k]});
  }
  bool has(const std::vector<int>& axes) const {
    return std::ranges::all_of(axes, [&](int axis) { return at[axis].has_value(); });
  }
  template <class Number> Vec3 of(const Table::Row& row, const Number& number) const {
    return by_axis<3>([&](int axis) { return at[axis] ? number(row, *at[axis]) : 0.0; });
  }
};

RawContacts read_lammps_pairs(const Reading& reading, const RawGrains& grains) {
  RawContacts contacts;
  Problems& problems = reading.problems;
  DumpSnapshot dump = read_dump(reading);
  DumpItem* item = dump.find("ENTRIES");
  if (!item) {
    if (!problems.any())
      problems.add("the last snapshot has no \"ITEM: ENTRIES\"; write the contacts with `dump local`");
    return contacts;
  }
  Table& entries = item->table;
  check_count(dump, entries, "NUMBER OF ENTRIES", problems);
  const SampleOptions options = with_units(reading.options, common_units(grains.units, dump.units, problems));
  const auto titles = split_blanks(item->title.substr(7));
  std::string given = options.contact_columns;
  std::replace(given.begin(), given.end(), ',', ' ');
  name_columns(entries, given.empty() ? titles : split_blanks(given));
  if (given.empty()) name_opaque_columns(entries, grains, contacts.notes);
  const auto i = entries.find({"patom1", "i"}), j = entries.find({"patom2", "j"}), overlap = entries.find({"overlap"});
  const DumpedVector normal(entries, {"fx", "fy", "fz"}), tangential(entries, {"p1", "p2", "p3"});
  const DumpedVector direction(entries, {"nx", "ny", "nz"}), point(entries, {"cx", "cy", "cz"});
  // Who names the columns may mean by fx, fy the whole force; LAMMPS's own are the normal force, and p1, p2 the
  // tangential.
  const auto axes = grains.axes();
  const bool whole = !given.empty() && !tangential.has(axes);
  const bool known = i && j && normal.has(axes) && (whole || tangential.has(axes));
  if (!known && !entries.rows.empty()) problems.add(entries.header_line, missing_columns(titles, axes));
  check_rows(entries, problems);
  if (problems.any() || !known) return contacts;
  const auto value_in = [&](double factor) {
    return [&, factor](const Table::Row& row, std::size_t c) {
      return number_or_problem(row.cells[c], entries.columns[c].name, factor, row.line, problems);
    };
  };
  const auto force = value_in(options.force()), length = value_in(options.length()), as_it_is = value_in(1);
  for (const Table::Row& row : entries.rows) {
    RawContact c;
    c.line = row.line;
    c.i = integer_or_problem(row.cells[*i], "patom1", row.line, problems);
    c.j = integer_or_problem(row.cells[*j], "patom2", row.line, problems);
    c.force_on_j = -(normal.of(row, force) + (whole ? Vec3{} : tangential.of(row, force)));
    if (direction.has(axes)) c.normal = -direction.of(row, as_it_is);
    if (point.has(axes)) c.point = point.of(row, length);
    if (overlap && to_number(row.cells[*overlap])) c.overlap = length(row, *overlap);
    contacts.rows.push_back(c);
  }
  if (dump.cell) compare_boxes(grains, scaled_by(*dump.cell, options.length()), contacts.notes);
  const auto has_walls = [](const auto& laid) {
    return laid.has_box && std::ranges::count(laid.cell.periodic, false) > 0;
  };
  if (grains.laid(has_walls))
    contacts.notes.push_back(
        "A dump of pairs has no contacts with walls: the stress of the sample and the balance of grains at its sides "
        "lack them.");
  if (!options.force_unit) contacts.notes.push_back(assumed_unit_of(options, dump.system, "force", "N", "force-unit"));
  return contacts;
}

}  // namespace

/// A snapshot of a LAMMPS `dump custom` with columns id, type, x, y and perhaps z (or xu, yu; xs, ys) and radius (or
/// diameter), with its box, periodic sides and tilt; and one of a `dump local` of `property/local patom1 patom2` and
/// `pair/local fx fy [fz] p1 p2 [p3]` of a granular pair style: (fx, fy) is the normal and (p1, p2) the tangential
/// force, both on atom 1. Its columns are known by these names, or by `contact_columns`, or where LAMMPS names them
/// c_ID[n], by what they hold.
const SampleFormat samples::lammps{
    .name = "lammps",
    .grains_are = "LAMMPS dump custom of id type x y [z] radius",
    .contacts_are = "LAMMPS dump local of property/local patom1 patom2 and pair/local fx fy [fz] p1 p2 [p3]",
    .states =
        {{"units (ITEM: UNITS)",
          "taken; those that only one of the two files states are those of both; `lj` has none. Other units given by "
          "options, or "
          "units that are not LAMMPS's, are refused. Without: m and N, told"},
         {"step, time",
          "grains and contacts are of the last step that both have; refused where they have none in common; told where "
          "one states a step and the other a time or nothing"},
         {"box, periodic sides, tilt, vectors (abc)",
          "taken; refused where its vectors leave the plane of the centres, of spheres where it is tilted in another "
          "way than "
          "along x with y, and where it is smaller between its walls than the centres span. Another box, or another "
          "place of it, in the contacts' dump is told"},
         {"z",
          "centres within 2 % of a radius are a plane, x-y, x-z or y-z (the last two are told); within a radius a "
          "layer, told; beyond: spheres"},
         {"columns",
          "known by name; those named after computes (c_1[2]) by what they hold, told, or refused; --columns names "
          "them"},
         {"nx, ny, nz and cx, cy, cz",
          "the contact's unit normal, towards patom1 as its forces act, and where it is; without: along the centres, "
          "where the grains overlap"},
         {"pairs without a force", "contacts where they overlap, else left out and told"},
         {"type, without it element", "the material"}},
    .is_grains = is_dump,
    .is_contacts = is_dump,
    .grains = read_lammps_atoms,
    .contacts = read_lammps_pairs,
    .grain_moments = dump_moments,
    .contact_moments = dump_moments,
    .units_named = dump_units};

}  // namespace arenite::io
