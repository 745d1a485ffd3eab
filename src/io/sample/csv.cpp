#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/option.hpp"
#include "core/text.hpp"
#include "io/sample/column_units.hpp"
#include "io/sample/formats.hpp"
#include "io/sample/number_columns.hpp"
#include "io/sample/table_snapshots.hpp"

namespace arenite::io {
namespace {

/// Says so where SI was assumed, since a factor of 1000 is easily overlooked.
void note_assumed_unit(const SampleOptions& options, const Table& table, const char* column, bool chosen,
                       const char* what, const char* si, const char* other, std::vector<std::string>& notes) {
  if (const auto at = table.find({column}); at && !chosen && table.columns[*at].unit.empty())
    notes.push_back(assumed_unit(options, what, si, other, column));
}

void require(const Table& table, bool found, const char* column, const char* kind, Problems& problems) {
  if (!found) problems.add(table.header_line, "there is no column \"{}\"; {}", column, kind);
}

constexpr std::string_view grain_names[] = {"id", "grain"}, pair_names[] = {"i", "id1", "j", "id2"};

std::vector<Moment> grain_moments_csv(std::string_view text, const std::string& columns) {
  return moments_of_rows(text, columns, grain_names);
}
std::vector<Moment> contact_moments_csv(std::string_view text, const std::string& columns) {
  return moments_of_rows(text, columns, pair_names);
}

/// The rows of the snapshot that is read; nothing where they cannot be used.
std::optional<Table> rows_of(const Reading& reading, const std::string& columns,
                             std::span<const std::string_view> names, SnapshotsOfRows& snapshots) {
  Table table = read_table(reading.text, columns, reading.problems);
  if (table.columns.empty()) return std::nullopt;
  take_units_of_comments(reading.text, reading.options, table);
  snapshots = SnapshotsOfRows(table, names);
  snapshots.keep(reading.snapshot, table);
  if (!knows_pixels(table, reading.options, reading.problems)) return std::nullopt;
  return table;
}

/// Says so where the snapshot that is taken has fewer grains than another: the file may be cut off within it.
void note_fewer(const std::vector<std::size_t>& sizes, std::size_t taken, std::vector<std::string>& notes) {
  if (taken >= sizes.size() || sizes[taken] == std::ranges::max(sizes)) return;
  notes.push_back(
      fmt::format("The snapshot that was taken has {} grains, and another of the file {}: if none left the sample, the "
                  "file is cut off.",
                  sizes[taken], std::ranges::max(sizes)));
}

RawGrains read_grains_csv(const Reading& reading) {
  const SampleOptions& options = reading.options;
  Problems& problems = reading.problems;
  SnapshotsOfRows snapshots;
  const auto rows = rows_of(reading, options.grain_columns, grain_names, snapshots);
  if (!rows) return {};
  const Table& table = *rows;
  StatedColumns units(table);
  units.see_vector({"x", "y", "z"}, options.length_unit.has_value(), problems);
  if (const auto size = table.find({"radius", "r", "diameter", "d"}))
    units.see({table.columns[*size].name}, options.length_unit.has_value());
  RawGrains grains = grains_in(table, "grains need id, x, y, radius and may have z, material, zone", options, problems);
  units.tell(grains.notes);
  if (!units.are_mixed())
    note_assumed_unit(options, table, "x", options.length_unit.has_value(), "length", "m", "length-unit", grains.notes);
  note_fewer(snapshots.sizes(), reading.snapshot, grains.notes);
  return grains;
}

/// Whether a force by its components in the plane is as large as by its parts along and across the normal, to three
/// digits.
bool are_one_force(Vec3 force, const std::vector<int>& axes, double fn, double ft) {
  const double size = std::hypot(force[axes[0]], force[axes[1]]);
  return std::abs(size - std::hypot(fn, ft)) <= 1e-3 * size;
}

RawContacts read_contacts_csv(const Reading& reading, const RawGrains& grains) {
  const SampleOptions& options = reading.options;
  Problems& problems = reading.problems;
  SnapshotsOfRows snapshots;
  const auto rows = rows_of(reading, options.contact_columns, pair_names, snapshots);
  if (!rows) return {};
  const Table& table = *rows;
  RawContacts contacts;
  const auto i = table.find({"i", "id1"}), j = table.find({"j", "id2"});
  const auto force = [&](const char* name) {
    return find_number(table, {name}, dimension::force, options.force(), problems);
  };
  const auto part = [&](const char* name) { return find_number(table, {name}, dimension::none, 1, problems); };
  const auto length = [&](const char* name) { return find_length(table, {name}, options, problems); };
  const NumberColumn fn = force("fn"), ft = force("ft"), overlap = length("overlap");
  const std::vector<int> axes = grains.axes();
  const VectorColumns whole({force("fx"), force("fy"), force("fz")}, axes);
  const VectorColumns normal({part("nx"), part("ny"), part("nz")}, axes);
  const VectorColumns point({length("x"), length("y"), length("z")}, axes);
  const char* kind =
      grains.in_space ? "contacts of spheres need i, j and fx, fy, fz of the force on j (or fn without friction) and "
                        "may have nx, ny, nz, overlap and x, y, z of the contact point"
                      : "contacts need i, j, fn, ft (or fx, fy for the force on j) and may have nx, ny, overlap and "
                        "x, y of the contact point";
  const std::span sides(any_side_names.begin(), 2 * axes.size());
  require(table, i.has_value(), "i", kind, problems);
  require(table, j.has_value(), "j", kind, problems);
  const bool vector = whole.is_there && (!fn || grains.in_space);
  require(table, fn || vector, "fn", kind, problems);
  if (table.find({"nx"}) && !normal.is_there)
    problems.add(table.header_line, "there is a column nx but no {}; give all or none",
                 axes.size() > 2 ? "ny, nz" : "ny");
  if (!i || !j || (!fn && !vector)) return contacts;
  const bool force_given = options.force_unit.has_value(), length_given = options.length_unit.has_value();
  StatedColumns units(table);
  if (vector) units.see_vector({"fx", "fy", "fz"}, force_given, problems);
  else units.see({"fn", "ft"}, force_given);
  units.see_vector({"x", "y", "z"}, length_given, problems);
  units.see({"overlap"}, length_given);
  units.tell(contacts.notes);
  if (!units.are_mixed())
    note_assumed_unit(options, table, vector ? "fx" : "fn", force_given, "force", "N", "force-unit", contacts.notes);
  if (!vector && !ft && !grains.in_space)
    contacts.notes.push_back(
        "The contacts have no column ft, so they were taken as frictionless: tangential forces are not known.");
  for (const auto& row : table.rows) {
    RawContact contact;
    contact.line = row.line;
    contact.normal = normal(row);
    contact.point = point(row);
    if (overlap && !row.cells[overlap.at].empty()) contact.overlap = overlap(row);
    std::string_view grain = row.cells[*i], other = row.cells[*j];
    if (vector) contact.force_on_j = whole(row);
    if (std::ranges::count(sides, grain) > 0 &&
        to_number(other)) {  // seen from the wall: the same contact, as fn and ft are
      std::swap(grain, other);
      for (auto* of_j : {&contact.normal, &contact.force_on_j})
        if (*of_j) *of_j = -**of_j;
    }
    contact.i = integer_or_problem(grain, "i", row.line, problems);
    if (const auto wall = std::ranges::find(sides, other); wall != sides.end())
      contact.wall = static_cast<int>(wall - sides.begin());
    else if (contact.normal && is_plain_name(other) && !to_number(other)) contact.boundary = other;
    else contact.j = integer_or_problem(other, "j", row.line, problems);
    if (!vector) contact.fn = fn(row);
    if (!vector && ft && whole.is_there && !are_one_force(*whole(row), axes, contact.fn, ft(row)))
      problems.add(row.line, "fx, fy and fn, ft contradict each other; leave two of the columns out");
    if (!vector && ft) contact.ft = ft(row);
    if (grains.in_space && contact.ft != 0)
      return problems.add(row.line,
                          "ft says how large the tangential force is, but in space not where it points; give the force "
                          "on j as fx, fy, fz"),
             contacts;
    contacts.rows.push_back(std::move(contact));
  }
  return contacts;
}

}  // namespace

/// Grains from a table with columns id, x, y, radius (or diameter) and perhaps z, material and zone; units in the
/// header win over those of the options. Contacts from one with columns i, j and fn, ft (or fx, fy: the force on j) and
/// perhaps nx, ny, overlap and the contact point x, y; j may name a wall, left, right, bottom or top, or with nx, ny a
/// boundary. Of spheres vectors have three components, and back and front are walls, too.
const SampleFormat samples::csv{
    .name = "csv",
    .grains_are = "table id,x,y,radius[,z,material,zone]",
    .contacts_are =
        "table i,j,fn,ft[,nx,ny,overlap,x,y] or i,j,fx,fy (force on j is fn n + ft t, n from i to j); of "
        "spheres i,j,fx,fy,fz",
    .states =
        {{"units (header, a row below it, or a comment above, \"# units: mm, N\")",
          "taken, those of a comment where no option gives others; columns without any: m and N, told, or those given "
          "by "
          "options"},
         {"units of some columns only", "told; refused of components of one vector"},
         {"names of columns behind # or %", "the header, where the first row has as many numbers"},
         {"step, timestep, frame, time (columns)",
          "rows of the last moment that grains and contacts have in common; refused where they have none, told where "
          "one file states a step and the other a time or nothing"},
         {"cell", "no column holds it; --box and --periodic give it"},
         {"z",
          "centres within 2 % of a radius are a plane, x-y, x-z or y-z (the last two are told); within a radius a "
          "layer, told; beyond: spheres"},
         {"names of columns", "those listed above; other columns are passed over"},
         {"contacts with walls",
          "refused where the box is periodic there, or the grain more than two radii from the wall; told where it is "
          "not near it"},
         {"nx, ny",
          "refused where most are turned from the line through the centres by more than 20 degrees, a few told"},
         {"walls in column i", "taken as in column j, with the normal and the force turned round"},
         {"fx, fy beside fn, ft", "fn, ft are taken; refused where the two contradict each other"},
         {"contacts without ft", "frictionless, told"},
         {"snapshots with fewer grains than others", "told"},
         {"materials of some grains only", "told"},
         {"rows without a force",
          "contacts where they overlap (column overlap, or the centres), else left out and told"},
         {"contact point (x, y of a contact)", "the lever arms end there; without it in the middle of the overlap"},
         {"sep=; of spreadsheets", "the separator"},
         {"decimal commas",
          "read where cells are in quotes or separated by other signs; refused where they may set thousands apart"},
         {"exponents with D", "read as E"},
         {"encoding", "UTF-8, UTF-16 with its mark, else Latin-1"}},
    .is_grains = [](std::string_view) { return true; },
    .is_contacts = [](std::string_view) { return true; },
    .grains = read_grains_csv,
    .contacts = read_contacts_csv,
    .grain_moments = grain_moments_csv,
    .contact_moments = contact_moments_csv};

std::string assumed_unit(const SampleOptions& options, const char* what, const char* si, const char* other,
                         const char* column) {
  std::vector<std::string> mends;
  if (options.may_be_given) mends.push_back(option(other));
  if (*column) mends.push_back(fmt::format("a header such as \"{} [...]\"", column));
  const std::string mend = mends.empty() ? "" : "; " + list_of(mends, " or ") + " changes this";
  return fmt::format("The file states no unit of {}, so {} was assumed{}.", what, si, mend);
}

RawGrains grains_in(const Table& table, const char* needed, const SampleOptions& options, Problems& problems) {
  RawGrains grains;
  const auto id = table.find({"id", "grain"}), material = table.find({"material"}), zone = table.find({"zone"});
  const NumberColumn x = find_length(table, {"x"}, options, problems), y = find_length(table, {"y"}, options, problems);
  const NumberColumn z = find_length(table, {"z"}, options, problems);
  const NumberColumn radius = find_length(table, {"radius", "r"}, options, problems),
                     diameter = find_length(table, {"diameter", "d"}, options, problems);
  require(table, bool(x), "x", needed, problems);
  require(table, bool(y), "y", needed, problems);
  if (options.dimension == 3) require(table, bool(z), "z", needed, problems);
  require(table, radius || diameter, "radius", needed, problems);
  if (!x || !y || (!radius && !diameter)) return grains;
  if (const auto links = table.find({"links"}); links && std::ranges::any_of(table.rows, [&](const Table::Row& row) {
                                                  return to_number(row.cells[*links]).value_or(0) > 0;
                                                }))
    grains.notes.push_back(
        "The grains are joined by bonds or pulls across gaps (column links), whose forces are in no table: stress and "
        "balance lack them.");
  for (const auto& row : table.rows) {
    RawGrain grain;
    grain.line = row.line;
    grain.id = id ? integer_or_problem(row.cells[*id], "id", row.line, problems)
                  : static_cast<std::int64_t>(grains.rows.size());
    grain.place = {x(row), y(row), z ? z(row) : 0};
    grain.radius = radius ? radius(row) : 0.5 * diameter(row);
    if (radius && diameter && !is_radius_of(grain.radius, diameter(row)))
      problems.add(row.line, "radius and diameter contradict each other; leave one of the columns out");
    if (material) grain.material = row.cells[*material];
    if (zone) grain.zone = integer_or_problem(row.cells[*zone], "zone", row.line, problems);
    grains.rows.push_back(std::move(grain));
  }
  return grains;
}

}  // namespace arenite::io
