#include <fmt/core.h>

#include <algorithm>
#include <map>

#include "core/mapped.hpp"
#include "io/disk/file.hpp"
#include "io/sample/sample.hpp"
#include "io/table/table.hpp"

namespace arenite::io {
namespace {

/// A column of numbers, which need not be there: its value in a row in SI.
struct Field {
  const Table::Column* column = nullptr;
  std::size_t at = 0;
  double factor = 1;
  Problems* problems = nullptr;
  explicit operator bool() const { return column != nullptr; }
  double operator()(const Table::Row& row) const { return number_or_problem(row.cells[at], column->name, factor, row.line, *problems); }
};

Field find_field(const Table& table, std::initializer_list<std::string_view> names, Dimension dimension, double by_default, Problems& problems) {
  const auto at = table.find(names);
  if (!at) return {};
  const auto& column = table.columns[*at];
  return {&column, *at, factor_or_problem(column.unit, column.name, dimension, by_default, table.header_line, problems), &problems};
}

bool is_in_pixels(const Table::Column& column) { return column.unit == "px"; }

/// A length; one in pixels, as `arenite grains` writes it where their width is not given, has their width for a factor.
Field find_length(const Table& table, std::initializer_list<std::string_view> names, const SampleOptions& options, Problems& problems) {
  if (const auto at = table.find(names); at && is_in_pixels(table.columns[*at])) return {&table.columns[*at], *at, options.pixel, &problems};
  return find_field(table, names, dimension::length, options.length(), problems);
}

/// Says so where SI was assumed, since a factor of 1000 is easily overlooked.
void note_assumed_unit(const Table& table, const char* column, bool chosen, const char* what, const char* si, const char* option,
                       std::vector<std::string>& notes) {
  if (const auto at = table.find({column}); at && !chosen && table.columns[*at].unit.empty())
    notes.push_back(
        fmt::format("The file states no unit of {}, so {} was assumed; {} or a header such as \"{} [...]\" changes this.", what, si, option, column));
}

void require(const Table& table, bool found, const char* column, const char* kind, Problems& problems) {
  if (!found) problems.add(table.header_line, "there is no column \"{}\"; {}", column, kind);
}

std::int32_t material_of(const RawGrain& row, const Materials& materials, Problems& problems) {
  if (row.material.empty() && materials.size() == 1) return 0;
  const auto it = std::find_if(materials.begin(), materials.end(), [&](const Material& m) { return m.name == row.material; });
  if (it != materials.end()) return static_cast<std::int32_t>(it - materials.begin());
  const std::string near = nearest(row.material, mapped(materials, &Material::name));
  if (row.material.empty()) problems.add(row.line, "this grain has no material; add a column \"material\"");
  else
    problems.add(row.line, "the recipe has no material \"{}\"{}", row.material,
                 near.empty() ? "; add it under [materials]" : fmt::format("; did you mean \"{}\"?", near));
  return 0;
}

bool lies_inside(Vec2 p, const Domain& domain) {
  return p.x >= domain.wall[left].position && p.x <= domain.wall[right].position && p.y >= domain.wall[bottom].position && p.y <= domain.wall[top].position;
}

RawGrains read_grains_csv(std::string_view text, const SampleOptions& options, Problems& problems) {
  const Table table = read_table(text, options.grain_columns, problems);
  RawGrains grains;
  if (table.columns.empty()) return grains;
  if (std::ranges::any_of(table.columns, is_in_pixels) && options.pixel == 0) {
    problems.add(table.header_line,
                 "lengths are in pixels (px), whose width on the sample is not known; give it to `arenite measure` by --pixel, "
                 "for example --pixel \"1.6 mm\", or to `arenite grains`, which then writes the table in mm");
    return grains;
  }
  grains = grains_in(table, "grains need id, x, y, radius and may have material, zone", options, problems);
  note_assumed_unit(table, "x", options.length_unit.has_value(), "length", "m", "--length-unit", grains.notes);
  return grains;
}

RawContacts read_contacts_csv(std::string_view text, const RawGrains&, const SampleOptions& options, Problems& problems) {
  const Table table = read_table(text, options.contact_columns, problems);
  RawContacts contacts;
  if (table.columns.empty()) return contacts;
  const auto i = table.find({"i", "id1"}), j = table.find({"j", "id2"});
  const Field fn = find_field(table, {"fn"}, dimension::force, options.force(), problems);
  const Field ft = find_field(table, {"ft"}, dimension::force, options.force(), problems);
  const Field fx = find_field(table, {"fx"}, dimension::force, options.force(), problems);
  const Field fy = find_field(table, {"fy"}, dimension::force, options.force(), problems);
  const Field nx = find_field(table, {"nx"}, dimension::none, 1, problems);
  const Field ny = find_field(table, {"ny"}, dimension::none, 1, problems);
  constexpr const char* kind = "contacts need i, j, fn, ft (or fx, fy for the force on j) and may have nx, ny";
  require(table, i.has_value(), "i", kind, problems);
  require(table, j.has_value(), "j", kind, problems);
  const bool vector = fx && fy && !fn;
  require(table, fn || vector, "fn", kind, problems);
  if (nx && !ny) problems.add(table.header_line, "there is a column nx but no ny; give both or neither");
  if (!i || !j || (!fn && !vector)) return contacts;
  note_assumed_unit(table, fn ? "fn" : "fx", options.force_unit.has_value(), "force", "N", "--force-unit", contacts.notes);
  for (const auto& row : table.rows) {
    RawContact contact;
    contact.line = row.line;
    contact.i = integer_or_problem(row.cells[*i], "i", row.line, problems);
    if (const auto* wall = std::ranges::find(side_names, row.cells[*j]); wall != std::end(side_names))
      contact.wall = static_cast<int>(wall - std::begin(side_names));
    else contact.j = integer_or_problem(row.cells[*j], "j", row.line, problems);
    if (vector) {
      contact.force_on_j = Vec2{fx(row), fy(row)};
    } else {
      contact.fn = fn(row);
      if (ft) contact.ft = ft(row);
    }
    if (nx && ny) contact.normal = Vec2{nx(row), ny(row)};
    contacts.rows.push_back(std::move(contact));
  }
  return contacts;
}

}  // namespace

/// Grains from a table with columns id, x, y, radius (or diameter) and perhaps material and zone; units in the header win over those of the options.
/// Contacts from one with columns i, j and fn, ft (or fx, fy: the force on j) and perhaps nx, ny; j may name a wall: left, right, bottom, top.
const SampleFormat samples::csv{.name = "csv",
                                .grains_are = "table id,x,y,radius[,material,zone]",
                                .contacts_are = "table i,j,fn,ft[,nx,ny] or i,j,fx,fy (force on j is fn n + ft t, n from i to j)",
                                .is_grains = [](std::string_view) { return true; },
                                .is_contacts = [](std::string_view) { return true; },
                                .grains = read_grains_csv,
                                .contacts = read_contacts_csv};

RawGrains grains_in(const Table& table, const char* needed, const SampleOptions& options, Problems& problems) {
  RawGrains grains;
  const auto id = table.find({"id", "grain"}), material = table.find({"material"}), zone = table.find({"zone"});
  const Field x = find_length(table, {"x"}, options, problems), y = find_length(table, {"y"}, options, problems);
  const Field radius = find_length(table, {"radius", "r"}, options, problems), diameter = find_length(table, {"diameter", "d"}, options, problems);
  require(table, bool(x), "x", needed, problems);
  require(table, bool(y), "y", needed, problems);
  require(table, radius || diameter, "radius", needed, problems);
  if (!x || !y || (!radius && !diameter)) return grains;
  for (const auto& row : table.rows) {
    RawGrain grain;
    grain.line = row.line;
    grain.id = id ? integer_or_problem(row.cells[*id], "id", row.line, problems) : static_cast<std::int64_t>(grains.rows.size());
    grain.centre = {x(row), y(row)};
    grain.radius = radius ? radius(row) : 0.5 * diameter(row);
    if (material) grain.material = row.cells[*material];
    if (zone) grain.zone = integer_or_problem(row.cells[*zone], "zone", row.line, problems);
    grains.rows.push_back(std::move(grain));
  }
  return grains;
}

Grains read_placed_grains(const std::filesystem::path& path, const Materials& materials, const Domain& domain) {
  Problems problems(path.string());
  const std::string text = read_file(path);
  const RawGrains raw = read_grains_csv(text, {}, problems);
  Grains grains;
  grains.resize(raw.rows.size());
  std::map<std::int64_t, int> line_of;
  for (std::size_t i = 0; i < raw.rows.size(); ++i) {
    const RawGrain& row = raw.rows[i];
    if (const auto [seen, is_new] = line_of.emplace(row.id, row.line); !is_new)
      problems.add(row.line, "grain {} is already in line {}; give every grain its own id", row.id, seen->second);
    const Vec2 centre = row.centre + domain.corner();
    if (!lies_inside(centre, domain))
      problems.add(row.line,
                   "the centre of grain {} at ({:g}, {:g}) m lies outside the container of {:g} x {:g} m; correct it, "
                   "the unit of the column or [container]",
                   row.id, row.centre.x, row.centre.y, domain.width(), domain.height());
    grains.id[i] = row.id;
    grains.position[i] = centre;
    grains.radius[i] = row.radius;
    grains.material[i] = material_of(row, materials, problems);
  }
  problems.raise();
  return grains;
}

}  // namespace arenite::io
