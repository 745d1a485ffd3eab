#include "io/sample/sample.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "core/mapped.hpp"
#include "io/table/table.hpp"

namespace arenite::io {
namespace {

/// One "ITEM: name" and the lines below it.
struct Item {
  std::string_view title;
  Table table;
};

/// Items of the last snapshot.
std::vector<Item> last_snapshot(std::string_view text, Problems& problems) {
  std::vector<Item> items;
  if (text.empty()) problems.add("the file is empty; give a dump with at least one snapshot");
  else if (!text.starts_with("ITEM: ")) problems.add(1, "this is not a LAMMPS dump: the first line must be \"ITEM: TIMESTEP\"");
  if (problems.any()) return items;
  const std::size_t before = text.rfind("\nITEM: TIMESTEP"), start = before == text.npos ? 0 : before + 1;
  Lines lines(text.substr(start), 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(start), '\n')));
  for (std::string_view line; lines.next(line);) {
    if (line.starts_with("ITEM: ")) items.push_back({line.substr(6), {{}, lines.number(), {}}});
    else if (auto cells = split_blanks(line); !cells.empty()) items.back().table.rows.push_back({lines.number(), std::move(cells)});
  }
  return items;
}

Item* find_item(std::vector<Item>& items, std::string_view title) {
  const auto it = std::find_if(items.begin(), items.end(), [&](const Item& i) { return i.title.starts_with(title); });
  return it == items.end() ? nullptr : &*it;
}

void name_columns(Table& table, const std::vector<std::string_view>& names) {
  table.columns = mapped(names, [](std::string_view name) { return Table::Column{std::string(name), {}, {}}; });
}

/// Rows that have not as many cells as there are columns are problems.
void check_rows(const Table& table, Problems& problems) {
  for (const auto& [line, cells] : table.rows)
    if (cells.size() != table.columns.size())
      problems.add(line, "this row has {} values, but there are {} columns; the dump is cut off or damaged", cells.size(), table.columns.size());
}

void check_count(std::vector<Item>& items, const Table& table, std::string_view title, Problems& problems) {
  const Item* count = find_item(items, title);
  if (!count || count->table.rows.empty()) return;
  const auto expected = to_integer(count->table.rows.front().cells.front());
  if (expected && *expected != static_cast<std::int64_t>(table.rows.size()))
    problems.add(table.header_line, "the dump announces {} rows, but {} follow; it is cut off, so write it again", *expected, table.rows.size());
}

void read_box(std::vector<Item>& items, double length, RawGrains& grains, Problems& problems) {
  constexpr std::string_view title = "BOX BOUNDS";
  const Item* item = find_item(items, title);
  if (!item || item->table.rows.size() < 2) return;
  const auto flags = split_blanks(item->title.substr(title.size()));
  const bool tilted = !flags.empty() && flags.front() == "xy";
  std::array<double, 3> x{}, y{};
  const auto read = [&](std::size_t row, std::array<double, 3>& to) {
    const auto& [line, cells] = item->table.rows[row];
    for (std::size_t c = 0; c < std::min<std::size_t>(3, cells.size()); ++c) to[c] = number_or_problem(cells[c], "box bound", length, line, problems);
  };
  read(0, x);
  read(1, y);
  const double xy = tilted ? x[2] : 0, xz = tilted ? y[2] : 0;  // bounds of a tilted box enclose its corners
  grains.lay_box({x[0] - std::min({0.0, xy, xz, xy + xz}), y[0]}, {x[1] - std::max({0.0, xy, xz, xy + xz}), y[1]});
  grains.cell.tilt = xy;
  for (std::size_t axis = 0, flag = tilted ? 3 : 0; axis < 2; ++axis, ++flag) grains.cell.periodic[axis] = flags.size() > flag && flags[flag] == "pp";
}

bool is_opaque(std::string_view name) { return name.starts_with("c_") || name.starts_with("f_"); }

constexpr const char* pair_columns[] = {"patom1", "patom2", "fx", "fy", "p1", "p2"};
constexpr const char* pair_columns_in_space[] = {"patom1", "patom2", "fx", "fy", "fz", "p1", "p2", "p3"};

/// What to write for a dump whose columns nobody can tell apart: an example that has as many.
std::string missing_columns(const std::vector<std::string_view>& names) {
  std::string found, example;
  std::size_t next = 0;
  for (const auto& name : names) {
    found.append(found.empty() ? "" : " ").append(name);
    example.append(example.empty() ? "" : ",").append(is_opaque(name) && next < std::size(pair_columns) ? pair_columns[next++] : "-");
  }
  return fmt::format(
      "it is not known which of the columns ({}) are the two grains and the force; name them in their order with --columns, with \"-\" for "
      "those not needed, e.g. --columns \"{}\" (patom1 patom2 of property/local, fx fy and the tangential p1 p2 of pair/local)",
      found, next == std::size(pair_columns) ? example : "-,patom1,patom2,fx,fy,p1,p2");
}

/// Names columns that LAMMPS named after computes: by what they hold, else index, two atoms, then forces in the documented order.
void name_opaque_columns(Table& entries, const RawGrains& grains) {
  std::vector<std::size_t> at;
  for (std::size_t c = 0; c < entries.columns.size(); ++c)
    if (is_opaque(entries.columns[c].name)) at.push_back(c);
  if (auto found = find_pair_columns(mapped(entries.rows, &Table::Row::cells), at, grains); !found.empty()) at = std::move(found);
  const bool in_space = at.size() == std::size(pair_columns_in_space);
  if (!in_space && at.size() != std::size(pair_columns)) return;
  for (std::size_t k = 0; k < at.size(); ++k) entries.columns[at[k]].name = in_space ? pair_columns_in_space[k] : pair_columns[k];
}

bool is_dump(std::string_view first_line) { return first_line.starts_with("ITEM:"); }

RawGrains read_lammps_atoms(std::string_view text, const SampleOptions& options, Problems& problems) {
  RawGrains grains;
  auto items = last_snapshot(text, problems);
  Item* item = find_item(items, "ATOMS");
  if (!item) {
    if (!problems.any()) problems.add("the last snapshot has no \"ITEM: ATOMS\"; write the grains with `dump custom`");
    return grains;
  }
  Table& atoms = item->table;
  check_count(items, atoms, "NUMBER OF ATOMS", problems);
  read_box(items, options.length(), grains, problems);
  name_columns(atoms, split_blanks(item->title.substr(5)));
  check_rows(atoms, problems);
  const auto is_there = [&](const char* name) { return atoms.find({name}).has_value(); };
  const bool scaled = !is_there("x") && !is_there("xu") && is_there("xs");
  const std::pair<const char*, std::optional<std::size_t>> wanted[] = {
      {"id", atoms.find({"id"})},         {"x", atoms.find({"x", "xu", "xs"})},   {"y", atoms.find({"y", "yu", "ys"})},
      {"radius", atoms.find({"radius"})}, {"diameter", atoms.find({"diameter"})}, {"material", atoms.find({"type"})}};
  name_columns(atoms, std::vector<std::string_view>(atoms.columns.size()));
  for (const auto& [name, at] : wanted)
    if (at) atoms.columns[*at] = {name, scaled && *name != 'r' && *name != 'd' ? "m" : "", {}};
  constexpr const char* needed = "dump id type x y radius";
  if (!is_there("id")) problems.add(atoms.header_line, "there is no column \"id\"; {}", needed);
  if (problems.any()) atoms.rows.clear();
  RawGrains read = grains_in(atoms, needed, options, problems);
  if (scaled)
    for (RawGrain& g : read.rows)
      g.centre = grains.cell.corner() + Vec2{g.centre.x * grains.cell.size().x + g.centre.y * grains.cell.tilt, g.centre.y * grains.cell.size().y};
  grains.rows = std::move(read.rows);
  return grains;
}

RawContacts read_lammps_pairs(std::string_view text, const RawGrains& grains, const SampleOptions& options, Problems& problems) {
  RawContacts contacts;
  auto items = last_snapshot(text, problems);
  Item* item = find_item(items, "ENTRIES");
  if (!item) {
    if (!problems.any()) problems.add("the last snapshot has no \"ITEM: ENTRIES\"; write the contacts with `dump local`");
    return contacts;
  }
  Table& entries = item->table;
  check_count(items, entries, "NUMBER OF ENTRIES", problems);
  const auto titles = split_blanks(item->title.substr(7));
  std::string given = options.contact_columns;
  std::replace(given.begin(), given.end(), ',', ' ');
  name_columns(entries, given.empty() ? titles : split_blanks(given));
  if (given.empty()) name_opaque_columns(entries, grains);
  const auto i = entries.find({"patom1", "i"}), j = entries.find({"patom2", "j"}), fx = entries.find({"fx"}), fy = entries.find({"fy"});
  // Who names the columns may mean by fx, fy the whole force; LAMMPS's own are the normal force, and p1, p2 the tangential one.
  const auto px = entries.find({"p1"}), py = entries.find({"p2"});
  const bool whole = !given.empty() && !px && !py;
  if (!i || !j || !fx || !fy || (!whole && (!px || !py))) {
    problems.add(entries.header_line, missing_columns(titles));
    return contacts;
  }
  check_rows(entries, problems);
  if (problems.any()) return contacts;
  for (const auto& [line, cells] : entries.rows) {
    const auto force = [&, at = line, &row = cells](std::size_t c) {
      return number_or_problem(row[c], entries.columns[c].name, options.force(), at, problems);
    };
    RawContact c;
    c.line = line;
    c.i = integer_or_problem(cells[*i], "patom1", line, problems);
    c.j = integer_or_problem(cells[*j], "patom2", line, problems);
    c.force_on_j = -Vec2{force(*fx) + (whole ? 0 : force(*px)), force(*fy) + (whole ? 0 : force(*py))};
    contacts.rows.push_back(c);
  }
  return contacts;
}

}  // namespace

/// The last snapshot of a LAMMPS `dump custom` with columns id, type, x, y (or xu, yu; xs, ys) and radius (or diameter), with its box, periodic sides
/// and tilt; and that of a `dump local` of `property/local patom1 patom2` and `pair/local fx fy [fz] p1 p2 [p3]` of a granular pair style: (fx, fy) is
/// the normal and (p1, p2) the tangential force, both on atom 1. Its columns are known by these names, or by `contact_columns`, or where LAMMPS names
/// them c_ID[n], by what they hold or by this order.
const SampleFormat samples::lammps{.name = "lammps",
                                   .grains_are = "LAMMPS dump custom of id type x y radius",
                                   .contacts_are = "LAMMPS dump local of property/local patom1 patom2 and pair/local fx fy p1 p2",
                                   .is_grains = is_dump,
                                   .is_contacts = is_dump,
                                   .grains = read_lammps_atoms,
                                   .contacts = read_lammps_pairs};

}  // namespace arenite::io
