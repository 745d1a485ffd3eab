#include "io/sample/lammps_dump.hpp"
#include "io/sample/named_columns.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>

#include "core/mapped.hpp"
#include "core/option.hpp"
#include "core/text.hpp"

namespace arenite::io {
namespace {

constexpr std::string_view mark = "ITEM: ";

/// Unit systems of LAMMPS (its page of the command "units"): length and force in SI. Those of "lj" have no size.
constexpr StatedUnits unit_systems[] = {{"si", 1, 1},
                                        {"cgs", 1e-2, 1e-5},
                                        {"micro", 1e-6, 1e-9},
                                        {"nano", 1e-9, 1e-12},
                                        {"real", 1e-10, 6.947695e-11},                // kcal/mol over an angstrom
                                        {"metal", 1e-10, 1.602176634e-9},             // eV over an angstrom
                                        {"electron", 5.29177211e-11, 8.2387235e-8}};  // Hartree over a Bohr radius

/// Where a snapshot begins in the text, and when it was taken.
struct Place {
  std::size_t begin = 0;
  Moment at;
};

std::string_view line_at(std::string_view text, std::size_t begin) {
  const std::string_view rest = text.substr(std::min(begin, text.size()));
  return trimmed(rest.substr(0, std::min(rest.find('\n'), rest.size())));
}

/// Calls `see` with the title, the line below it and the place of every item.
template <class See> void each_item(std::string_view text, See see) {
  for (std::size_t at = text.starts_with(mark) ? 0 : text.npos; at != text.npos;) {
    const std::string_view title = line_at(text, at + mark.size());
    const std::size_t end = text.find('\n', at);
    see(title, line_at(text, end == text.npos ? text.size() : end + 1), at);
    at = text.find("\nITEM: ", at);
    if (at != text.npos) ++at;
  }
}

std::vector<Place> places_of(std::string_view text) {
  std::vector<Place> places;
  std::optional<std::size_t> begin;  // of what stands before a step
  std::optional<double> time;
  each_item(text, [&](std::string_view title, std::string_view value, std::size_t at) {
    const bool before = title.starts_with("UNITS") || title.starts_with("TIME");
    if (before && !begin) begin = at;
    if (title.starts_with("TIMESTEP")) {
      places.push_back({*begin, {to_integer(value), time}});
      begin.reset();
      time.reset();
    } else if (title.starts_with("TIME")) {
      time = to_number(value);
    }
  });
  return places;
}

/// Rows of numbers of a box, three at least where there are as many.
std::vector<std::vector<double>> numbers_of_box(const DumpItem& item, std::size_t columns, Problems& problems) {
  std::vector<std::vector<double>> rows;
  for (const auto& [line, cells] : item.table.rows) {
    if (cells.size() != columns)
      problems.add(line, "expected {} bounds of the box, found {}; the dump is damaged", columns, cells.size());
    const auto number = [&, at = line](std::string_view cell) {
      return number_or_problem(cell, "box bound", 1, at, problems);
    };
    rows.push_back(mapped(cells, number));
    rows.back().resize(columns, 0.0);
  }
  return rows;
}

/// "BOX BOUNDS pp pp pp" and two bounds a row; "BOX BOUNDS xy xz yz pp pp pp" and those of what encloses a tilted box,
/// with a tilt behind; "BOX BOUNDS abc origin pp pp pp" and a vector a row, with a coordinate of the corner behind.
std::optional<RawCell> cell_of(const DumpItem& item, Problems& problems) {
  auto flags = split_blanks(item.title.substr(std::string_view("BOX BOUNDS").size()));
  const bool general = !flags.empty() && flags.front() == "abc", tilted = !flags.empty() && flags.front() == "xy";
  flags.erase(flags.begin(), flags.begin() + std::min<std::ptrdiff_t>(std::ssize(flags), general ? 2 : tilted ? 3 : 0));
  const auto rows = numbers_of_box(item, general ? 4 : tilted ? 3 : 2, problems);
  if (rows.size() < 2) return std::nullopt;
  RawCell cell;
  for (std::size_t axis = 0; axis < 3; ++axis) cell.periodic[axis] = flags.size() > axis && flags[axis] == "pp";
  if (general) {
    for (int axis = 0; axis < std::min<int>(3, static_cast<int>(rows.size())); ++axis) {
      cell.edge[axis] = {rows[axis][0], rows[axis][1], rows[axis][2]};
      cell.corner[axis] = rows[axis][3];
    }
    return cell;
  }
  const auto tilt = [&](std::size_t row) { return tilted && rows.size() > row ? rows[row][2] : 0.0; };
  const double xy = tilt(0), xz = tilt(1), yz = tilt(2);
  const auto lay = [&](int axis, double low, double high) {
    cell.corner[axis] = low;
    cell.edge[axis][axis] = high - low;
  };
  lay(0, rows[0][0] - std::min({0.0, xy, xz, xy + xz}), rows[0][1] - std::max({0.0, xy, xz, xy + xz}));
  lay(1, rows[1][0] - std::min(0.0, yz), rows[1][1] - std::max(0.0, yz));
  if (rows.size() > 2) lay(2, rows[2][0], rows[2][1]);
  cell.edge[1].x = xy;
  cell.edge[2].x = xz;
  cell.edge[2].y = yz;
  return cell;
}

}  // namespace

std::optional<StatedUnits> unit_system(std::string_view name, const SampleOptions& options, Problems& problems) {
  if (name.empty() || name == "lj") return std::nullopt;
  const auto* known = std::ranges::find(unit_systems, name, &StatedUnits::name);
  if (known == std::end(unit_systems)) {
    problems.add("the dump states units \"{}\", which are not known; write it without ITEM: UNITS and give {} and {}",
                 name, option("length-unit"), option("force-unit"));
    return std::nullopt;
  }
  const auto differs = [](std::optional<double> given, double stated) {
    return given && std::abs(*given / stated - 1) > 1e-9;
  };
  if (differs(options.length_unit, known->length) || differs(options.force_unit, known->force))
    problems.add(
        "the dump states units {}, of {:g} m and {:g} N, and the units given are others; leave out {} and {}, or the "
        "dump's ITEM: UNITS",
        name, known->length, known->force, option("length-unit"), option("force-unit"));
  return *known;
}

std::string assumed_unit_of(const SampleOptions& options, std::string_view system, const char* what, const char* si,
                            const char* other) {
  if (system != "lj") return assumed_unit(options, what, si, other);
  return fmt::format("The file states reduced units (lj), which have no size: {} was taken for that of {}{}", si, what,
                     options.may_be_given ? fmt::format("; {} changes this.", option(other)) : ".");
}

std::string_view dump_units(std::string_view text) {
  std::string_view name;
  each_item(text, [&](std::string_view title, std::string_view value, std::size_t) {
    if (title.starts_with("UNITS") && name.empty()) name = value;
  });
  return name;
}

DumpItem* DumpSnapshot::find(std::string_view title) {
  const auto it = std::ranges::find_if(items, [&](const DumpItem& i) { return i.title.starts_with(title); });
  return it == items.end() ? nullptr : &*it;
}

std::vector<Moment> dump_moments(std::string_view text, const std::string&) {
  return mapped(places_of(text), &Place::at);
}

DumpSnapshot read_dump(const Reading& reading) {
  DumpSnapshot dump;
  std::string_view text = reading.text;
  Problems& problems = reading.problems;
  if (text.empty()) problems.add("the file is empty; give a dump with at least one snapshot");
  else if (!text.starts_with(mark))
    problems.add(1, "this is not a LAMMPS dump: the first line must be \"ITEM: TIMESTEP\"");
  if (problems.any()) return dump;
  dump.system = dump_units(text);
  dump.units = unit_system(dump.system, reading.options, problems);
  const auto places = places_of(text);
  const std::size_t next = reading.snapshot + 1;
  const std::size_t begin = reading.snapshot < places.size() ? places[reading.snapshot].begin : 0;
  const std::size_t end = next < places.size() ? places[next].begin : text.size();
  Lines lines(text.substr(begin, end - begin),
              1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(begin), '\n')));
  for (std::string_view line; lines.next(line);) {
    if (line.starts_with(mark)) dump.items.push_back({line.substr(mark.size()), {{}, lines.number(), {}, {}}});
    else if (auto cells = split_blanks(line); !cells.empty())
      dump.items.back().table.rows.push_back({lines.number(), std::move(cells)});
  }
  if (const DumpItem* box = dump.find("BOX BOUNDS")) dump.cell = cell_of(*box, problems);
  return dump;
}

void name_columns(Table& table, const std::vector<std::string_view>& names) {
  table.columns = mapped(names, [](std::string_view name) { return Table::Column{std::string(name), {}, {}}; });
}

void check_rows(const Table& table, Problems& problems) {
  for (const auto& [line, cells] : table.rows)
    if (cells.size() != table.columns.size())
      problems.add(line, "this row has {} values, but there are {} columns; the dump is cut off or damaged",
                   cells.size(), table.columns.size());
}

void check_count(DumpSnapshot& dump, const Table& table, std::string_view title, Problems& problems) {
  const DumpItem* count = dump.find(title);
  if (!count || count->table.rows.empty()) return;
  const auto expected = to_integer(count->table.rows.front().cells.front());
  if (expected && *expected != static_cast<std::int64_t>(table.rows.size()))
    problems.add(table.header_line, "the dump announces {} rows, but {} follow; {}, so write it again", *expected,
                 table.rows.size(), is_cut_off(*expected, table.rows.size()));
}

}  // namespace arenite::io
