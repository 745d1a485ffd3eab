#include "io/sample/sample.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/mapped.hpp"
#include "io/table/table.hpp"

namespace arenite::io {
namespace {

/// One "ITEM: name" and the lines below it.
struct Item {
  std::string_view title;
  int line = 0;
  std::vector<std::pair<int, std::string_view>> body;
};

/// Items of the last snapshot.
std::vector<Item> last_snapshot(std::string_view text, Problems& problems) {
  std::vector<Item> items;
  Lines lines(text);
  std::string_view line;
  while (lines.next(line)) {
    if (line.starts_with("ITEM: ")) {
      line.remove_prefix(6);
      if (line.starts_with("TIMESTEP")) items.clear();
      items.push_back({line, lines.number(), {}});
    } else if (items.empty()) {
      problems.add(lines.number(), "this is not a LAMMPS dump: the first line must be \"ITEM: TIMESTEP\"");
      return items;
    } else if (!split_blanks(line).empty()) {
      items.back().body.emplace_back(lines.number(), line);
    }
  }
  if (items.empty()) problems.add("the file is empty; give a dump with at least one snapshot");
  return items;
}

const Item* find_item(const std::vector<Item>& items, std::string_view title) {
  const auto it = std::find_if(items.begin(), items.end(), [&](const Item& i) { return i.title.starts_with(title); });
  return it == items.end() ? nullptr : &*it;
}

/// Rows of numbers under named columns.
struct Columns {
  std::vector<std::string> names;
  int line = 0;

  std::optional<std::size_t> find(std::string_view name) const {
    const auto it = std::find(names.begin(), names.end(), name);
    return it == names.end() ? std::nullopt : std::optional(static_cast<std::size_t>(it - names.begin()));
  }
  std::size_t require(std::initializer_list<std::string_view> choices, const char* fix, Problems& problems) const {
    for (const auto name : choices)
      if (const auto c = find(name)) return *c;
    problems.add(line, fmt::format("there is no column \"{}\"; {}", *choices.begin(), fix));
    return names.size();
  }
};

Columns columns_of(const Item& item, std::string_view title) {
  Columns columns;
  columns.line = item.line;
  for (const auto name : split_blanks(item.title.substr(title.size()))) columns.names.emplace_back(name);
  return columns;
}

/// Rows with as many cells as columns; the others are problems.
template <class Use> void for_each_row(const Item& item, std::size_t columns, Problems& problems, Use use) {
  for (const auto& [number, line] : item.body) {
    const auto cells = split_blanks(line);
    if (cells.size() != columns)
      problems.add(number, fmt::format("this row has {} values, but there are {} columns; the dump is cut off or damaged", cells.size(), columns));
    else use(number, cells);
  }
}

void check_count(const std::vector<Item>& items, const Item& rows, std::string_view title, Problems& problems) {
  const Item* count = find_item(items, title);
  if (!count || count->body.empty()) return;
  const auto expected = to_integer(split_blanks(count->body.front().second).front());
  if (expected && *expected != static_cast<std::int64_t>(rows.body.size()))
    problems.add(rows.line, fmt::format("the dump announces {} rows, but {} follow; it is cut off, so write it again", *expected, rows.body.size()));
}

void read_box(const std::vector<Item>& items, double length, RawGrains& grains, Problems& problems) {
  constexpr std::string_view title = "BOX BOUNDS";
  const Item* item = find_item(items, title);
  if (!item || item->body.size() < 2) return;
  const auto flags = split_blanks(item->title.substr(title.size()));
  const bool tilted = !flags.empty() && flags.front() == "xy";
  std::array<double, 3> x{}, y{};
  const auto read = [&](std::size_t row, std::array<double, 3>& to) {
    const auto cells = split_blanks(item->body[row].second);
    for (std::size_t c = 0; c < std::min<std::size_t>(3, cells.size()); ++c)
      to[c] = number_or_problem(cells[c], "box bound", length, item->body[row].first, problems);
  };
  read(0, x);
  read(1, y);
  const double xy = tilted ? x[2] : 0, xz = tilted ? y[2] : 0;  // bounds of a tilted box enclose its corners
  grains.box_low = {x[0] - std::min({0.0, xy, xz, xy + xz}), y[0]};
  grains.box_high = {x[1] - std::max({0.0, xy, xz, xy + xz}), y[1]};
  grains.tilt = xy;
  const std::size_t first = tilted ? 3 : 0;
  grains.periodic_x = flags.size() > first && flags[first] == "pp";
  grains.periodic_y = flags.size() > first + 1 && flags[first + 1] == "pp";
  grains.has_box = true;
}

bool is_opaque(const std::string& name) { return name.starts_with("c_") || name.starts_with("f_"); }

/// What to write for a dump whose columns nobody can tell apart: an example that has as many.
std::string missing_columns(const std::vector<std::string>& names) {
  static const std::vector<std::string> wanted{"patom1", "patom2", "fx", "fy", "p1", "p2"};
  std::string found, example;
  std::size_t next = 0;
  for (const auto& name : names) {
    found += (found.empty() ? "" : " ") + name;
    example += (example.empty() ? "" : ",") + (is_opaque(name) && next < wanted.size() ? wanted[next++] : std::string("-"));
  }
  return fmt::format(
      "which of the columns ({}) are the two grains and the force is not known; name them in their order by --columns, with \"-\" for "
      "those not needed, e.g. --columns \"{}\" (patom1 patom2 of property/local, fx fy and the tangential p1 p2 of pair/local)",
      found, next == wanted.size() ? example : "-,patom1,patom2,fx,fy,p1,p2");
}

/// Columns of a dump that LAMMPS named after computes: by what they hold, else index, two atoms, then forces in the documented order.
void name_columns(Columns& columns, const Item& entries, const RawGrains& grains) {
  std::vector<std::size_t> at;
  for (std::size_t c = 0; c < columns.names.size(); ++c)
    if (is_opaque(columns.names[c])) at.push_back(c);
  const auto rows = mapped(entries.body, [](const auto& numbered) { return split_blanks(numbered.second); });
  if (const auto found = find_pair_columns(rows, at, grains)) {
    for (const auto& [name, c] :
         {std::pair{"patom1", found->i}, {"patom2", found->j}, {"fx", found->fx}, {"fy", found->fy}, {"p1", found->p1}, {"p2", found->p2}})
      columns.names[c] = name;
    return;
  }
  static const std::vector<std::string> plane{"patom1", "patom2", "fx", "fy", "p1", "p2"};
  static const std::vector<std::string> space{"patom1", "patom2", "fx", "fy", "fz", "p1", "p2", "p3"};
  const auto& names = at.size() == space.size() ? space : plane;
  if (at.size() != names.size()) return;
  for (std::size_t k = 0; k < at.size(); ++k) columns.names[at[k]] = names[k];
}

}  // namespace

RawGrains read_lammps_atoms(std::string_view text, const ReadingHints& hints, Problems& problems) {
  RawGrains grains;
  const auto items = last_snapshot(text, problems);
  const Item* atoms = find_item(items, "ATOMS");
  if (!atoms) {
    if (!problems.any()) problems.add("the last snapshot has no \"ITEM: ATOMS\"; write the grains by `dump custom`");
    return grains;
  }
  check_count(items, *atoms, "NUMBER OF ATOMS", problems);
  read_box(items, hints.length, grains, problems);
  const Columns columns = columns_of(*atoms, "ATOMS");
  constexpr const char* fix = "dump id type x y radius";
  const std::size_t id = columns.require({"id"}, fix, problems), type = columns.find("type").value_or(columns.names.size());
  const std::size_t x = columns.require({"x", "xu", "xs"}, fix, problems), y = columns.require({"y", "yu", "ys"}, fix, problems);
  const std::size_t r = columns.require({"radius", "diameter"}, fix, problems);
  if (problems.any()) return grains;
  const bool scaled = columns.names[x] == "xs";
  const double half = columns.names[r] == "diameter" ? 0.5 : 1.0;
  for_each_row(*atoms, columns.names.size(), problems, [&](int line, const auto& cells) {
    RawGrain g;
    g.line = line;
    g.id = integer_or_problem(cells[id], "id", line, problems);
    g.centre = {number_or_problem(cells[x], columns.names[x], scaled ? 1 : hints.length, line, problems),
                number_or_problem(cells[y], columns.names[y], scaled ? 1 : hints.length, line, problems)};
    if (scaled) {
      const Vec2 size = grains.box_high - grains.box_low;
      g.centre = grains.box_low + Vec2{g.centre.x * size.x + g.centre.y * grains.tilt, g.centre.y * size.y};
    }
    g.radius = half * number_or_problem(cells[r], columns.names[r], hints.length, line, problems);
    if (type < columns.names.size()) g.material = cells[type];
    grains.rows.push_back(std::move(g));
  });
  return grains;
}

RawContacts read_lammps_pairs(std::string_view text, const RawGrains& grains, const ReadingHints& hints, Problems& problems) {
  RawContacts contacts;
  const auto items = last_snapshot(text, problems);
  const Item* entries = find_item(items, "ENTRIES");
  if (!entries) {
    if (!problems.any()) problems.add("the last snapshot has no \"ITEM: ENTRIES\"; write the contacts by `dump local`");
    return contacts;
  }
  check_count(items, *entries, "NUMBER OF ENTRIES", problems);
  Columns columns = columns_of(*entries, "ENTRIES");
  if (hints.columns.empty()) {
    name_columns(columns, *entries, grains);
  } else {
    columns.names.clear();
    std::string spaced = hints.columns;
    std::replace(spaced.begin(), spaced.end(), ',', ' ');
    for (const auto name : split_blanks(spaced)) columns.names.emplace_back(name);
  }
  const auto column = [&](const char* name, const char* other) { return columns.find(name) ? columns.find(name) : columns.find(other); };
  const auto i = column("patom1", "i"), j = column("patom2", "j"), fx = columns.find("fx"), fy = columns.find("fy");
  // Who names the columns may mean by fx, fy the whole force; LAMMPS's own are the normal force, and p1, p2 the tangential one.
  const auto px = columns.find("p1"), py = columns.find("p2");
  const bool whole = !hints.columns.empty() && !px && !py;
  if (!i || !j || !fx || !fy || (!whole && (!px || !py))) {
    problems.add(entries->line, missing_columns(columns_of(*entries, "ENTRIES").names));
    return contacts;
  }
  for_each_row(*entries, columns.names.size(), problems, [&](int line, const auto& cells) {
    const auto force = [&](std::size_t c) { return number_or_problem(cells[c], columns.names[c], hints.force, line, problems); };
    RawContact c;
    c.line = line;
    c.i = integer_or_problem(cells[*i], "patom1", line, problems);
    c.j = integer_or_problem(cells[*j], "patom2", line, problems);
    c.force_on_j = -Vec2{force(*fx) + (whole ? 0 : force(*px)), force(*fy) + (whole ? 0 : force(*py))};
    contacts.rows.push_back(c);
  });
  return contacts;
}

}  // namespace arenite::io
