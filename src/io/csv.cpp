#include "io/csv.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/table.hpp"
#include "model/domain.hpp"

namespace arenite::io {
namespace {

/// One column of numbers: where it is and its factor to SI.
struct Field {
  std::optional<std::size_t> index;
  double factor = 1;
  explicit operator bool() const { return index.has_value(); }
};

Field find_field(const Table& table, std::initializer_list<std::string_view> names, Dimension dimension, double by_default,
                 Problems& problems) {
  Field field{table.find(names), by_default};
  if (!field || table.columns[*field.index].unit.empty()) return field;
  try {
    field.factor = unit_factor(table.columns[*field.index].unit, dimension);
  } catch (const InputError& error) {
    problems.add(table.header_line, fmt::format("column {}: {}", table.columns[*field.index].name, error.problems().front().message));
  }
  return field;
}

/// Columns of a picture's grains, which `arenite grains` writes in pixels where it is not told their width.
bool in_pixels(const Table& table) {
  const auto has_px = [](const auto& column) { return column.unit == "px"; };
  return std::any_of(table.columns.begin(), table.columns.end(), has_px);
}

/// A length; one in pixels has their width for a factor.
Field find_length(const Table& table, std::initializer_list<std::string_view> names, const UnitFactors& units, Problems& problems) {
  if (const Field field{table.find(names), units.pixel}; field && table.columns[*field.index].unit == "px") return field;
  return find_field(table, names, dimension::length, units.length, problems);
}

double number(const Table& table, const Table::Row& row, const Field& field, Problems& problems) {
  return number_or_problem(row.cells[*field.index], table.columns[*field.index].name, field.factor, row.line, problems);
}

/// Says so where SI was assumed, since a factor of 1000 is easily overlooked.
void note_assumed_unit(const Table& table, const Field& field, bool chosen, const char* what, const char* si, const char* option,
                       std::vector<std::string>& notes) {
  if (field && !chosen && table.columns[*field.index].unit.empty())
    notes.push_back(fmt::format("The file names no unit of {}, so {} was taken; {} or a header such as \"{} [...]\" says otherwise.",
                                what, si, option, table.columns[*field.index].name));
}

void require(const Table& table, bool found, const char* column, const char* kind, Problems& problems) {
  if (!found) problems.add(table.header_line, fmt::format("there is no column \"{}\"; {}", column, kind));
}

std::optional<int> wall_by_name(std::string_view cell) {
  for (int side = 0; side < 4; ++side)
    if (cell == side_names[static_cast<std::size_t>(side)]) return side;
  return std::nullopt;
}

}  // namespace

RawGrains read_grains_csv(std::string_view text, const std::string& columns, const UnitFactors& units, Problems& problems) {
  const Table table = read_table(text, columns, problems);
  RawGrains grains;
  if (table.columns.empty()) return grains;
  if (in_pixels(table) && units.pixel == 0) {
    problems.add(table.header_line, "lengths are in pixels (px), whose width on the sample is not known; give it to `arenite measure` by --pixel, "
                                    "for example --pixel \"1.6 mm\", or to `arenite grains`, which then writes the table in mm");
    return grains;
  }
  const auto id = table.find({"id", "grain"});
  const Field x = find_length(table, {"x"}, units, problems);
  const Field y = find_length(table, {"y"}, units, problems);
  const Field radius = find_length(table, {"radius", "r"}, units, problems);
  const Field diameter = find_length(table, {"diameter", "d"}, units, problems);
  const auto material = table.find({"material"}), zone = table.find({"zone"});
  constexpr const char* kind = "grains need id, x, y, radius and may have material, zone";
  require(table, x.index.has_value(), "x", kind, problems);
  require(table, y.index.has_value(), "y", kind, problems);
  require(table, radius || diameter, "radius", kind, problems);
  if (!x || !y || (!radius && !diameter)) return grains;
  note_assumed_unit(table, x, units.length_chosen, "length", "m", "--length-unit", grains.notes);
  for (const auto& row : table.rows) {
    RawGrain grain;
    grain.line = row.line;
    grain.id = id ? integer_or_problem(row.cells[*id], "id", row.line, problems) : static_cast<std::int64_t>(grains.rows.size());
    grain.centre = {number(table, row, x, problems), number(table, row, y, problems)};
    grain.radius = radius ? number(table, row, radius, problems) : 0.5 * number(table, row, diameter, problems);
    if (material) grain.material = row.cells[*material];
    if (zone) grain.zone = integer_or_problem(row.cells[*zone], "zone", row.line, problems);
    grains.rows.push_back(std::move(grain));
  }
  return grains;
}

RawContacts read_contacts_csv(std::string_view text, const std::string& columns, const UnitFactors& units, Problems& problems) {
  const Table table = read_table(text, columns, problems);
  RawContacts contacts;
  if (table.columns.empty()) return contacts;
  const auto i = table.find({"i", "id1"}), j = table.find({"j", "id2"});
  const Field fn = find_field(table, {"fn"}, dimension::force, units.force, problems);
  const Field ft = find_field(table, {"ft"}, dimension::force, units.force, problems);
  const Field fx = find_field(table, {"fx"}, dimension::force, units.force, problems);
  const Field fy = find_field(table, {"fy"}, dimension::force, units.force, problems);
  const Field nx = find_field(table, {"nx"}, dimension::none, 1, problems);
  const Field ny = find_field(table, {"ny"}, dimension::none, 1, problems);
  constexpr const char* kind = "contacts need i, j, fn, ft (or fx, fy for the force on j) and may have nx, ny";
  require(table, i.has_value(), "i", kind, problems);
  require(table, j.has_value(), "j", kind, problems);
  const bool vector = fx && fy && !fn;
  require(table, fn || vector, "fn", kind, problems);
  if (nx && !ny) problems.add(table.header_line, "there is a column nx but no ny; give both or neither");
  if (!i || !j || (!fn && !vector)) return contacts;
  note_assumed_unit(table, fn ? fn : fx, units.force_chosen, "force", "N", "--force-unit", contacts.notes);
  for (const auto& row : table.rows) {
    RawContact contact;
    contact.line = row.line;
    contact.i = integer_or_problem(row.cells[*i], "i", row.line, problems);
    if (const auto wall = wall_by_name(row.cells[*j]))
      contact.wall = *wall;
    else
      contact.j = integer_or_problem(row.cells[*j], "j", row.line, problems);
    if (vector) {
      contact.force_on_j = Vec2{number(table, row, fx, problems), number(table, row, fy, problems)};
    } else {
      contact.fn = number(table, row, fn, problems);
      if (ft) contact.ft = number(table, row, ft, problems);
    }
    if (nx && ny) contact.normal = Vec2{number(table, row, nx, problems), number(table, row, ny, problems)};
    contacts.rows.push_back(std::move(contact));
  }
  return contacts;
}

}  // namespace arenite::io
