#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/text.hpp"
#include "io/sample/formats.hpp"
#include "io/sample/named_columns.hpp"

namespace arenite::io {
namespace {

bool all_numbers(std::string_view line, std::size_t count) {
  const auto cells = split_blanks(line);
  return cells.size() == count &&
         std::ranges::all_of(cells, [](std::string_view cell) { return to_number(cell).has_value(); });
}

/// "# time ..", which begins a step, or a row of numbers.
bool is_fstat(std::string_view line) {
  const auto cells = split_blanks(line);
  return all_numbers(line, 16) || (cells.size() > 1 && cells[0] == "#" && to_number(cells[1]));
}

/// The line that begins a time step of a .data file, in the plane or in space.
struct DataHeader {
  std::int64_t grains = 0;
  Moment at;
  RawCell cell;
};

bool may_be_header(const std::vector<std::string_view>& cells) { return cells.size() == 6 || cells.size() == 8; }

DataHeader read_header(const std::vector<std::string_view>& cells, int line, double length, Problems& problems) {
  DataHeader header;
  header.grains = integer_or_problem(cells[0], "number of grains", line, problems);
  header.at.time = to_number(cells[1]);
  const auto axes = (static_cast<int>(cells.size()) - 2) / 2;
  const auto bound = [&](int c) {
    return number_or_problem(cells[static_cast<std::size_t>(2 + c)], "box bound", length, line, problems);
  };
  for (int axis = 0; axis < axes; ++axis) {
    header.cell.corner[axis] = bound(axis);
    header.cell.edge[axis][axis] = bound(axes + axis) - header.cell.corner[axis];
  }
  return header;
}

/// Times of all steps of a .data file, by the counts of grains in their headers.
std::vector<Moment> data_moments(std::string_view text, const std::string&) {
  std::vector<Moment> moments;
  std::int64_t rows = 0;
  Lines lines(text);
  for (std::string_view line; lines.next(line);) {
    if (trimmed(line).empty() || rows-- > 0) continue;
    const auto cells = split_blanks(line);
    const auto count = to_integer(cells.front());
    if (!may_be_header(cells) || !count) return moments;
    moments.push_back({std::nullopt, to_number(cells[1])});
    rows = *count;
  }
  return moments;
}

Table table_of_grains(bool in_space) {
  Table table;
  if (in_space)
    for (const char* name : {"x", "y", "z", "", "", "", "radius", "", "", "", "", "", "", "material"})
      table.columns.push_back({name, {}, {}});
  else
    for (const char* name : {"x", "y", "", "", "radius", "", "", "material"}) table.columns.push_back({name, {}, {}});
  return table;
}

RawGrains read_mercury_data(const Reading& reading) {
  RawGrains grains;
  Problems& problems = reading.problems;
  Table table;
  DataHeader header;
  Lines lines(reading.text);
  std::int64_t found = 0;
  std::size_t snapshot = 0;
  for (std::string_view line; lines.next(line);) {
    auto cells = split_blanks(line);
    if (cells.empty()) continue;
    const int at = lines.number();
    if (found == header.grains) {
      if (table.header_line > 0 && snapshot++ == reading.snapshot) break;
      const auto count = to_integer(cells.front());
      if (!may_be_header(cells) || !count || *count < 0) {
        problems.add(at, "expected \"N time xmin ymin xmax ymax\", or with z too, found {} values; write the file anew",
                     cells.size());
        return grains;
      }
      header = read_header(cells, at, reading.options.length(), problems);
      table = table_of_grains(cells.size() == 8);
      table.header_line = at;
      found = 0;
      continue;
    }
    ++found;
    if (snapshot < reading.snapshot) continue;
    if (cells.size() == table.columns.size()) table.rows.push_back({at, std::move(cells)});
    else
      problems.add(at, "expected {} values \"{}\", found {}", table.columns.size(),
                   table.columns.size() == 8 ? "x y vx vy radius angle omega info"
                                             : "x y z vx vy vz radius qx qy qz omegax omegay omegaz info",
                   cells.size());
  }
  if (table.header_line == 0) problems.add("the file is empty; give a .data file with at least one time step");
  if (found < header.grains)
    problems.add(table.header_line, "{} grains are announced, but {} follow; the file is cut off", header.grains,
                 found);
  grains.rows = grains_in(table, "", reading.options, problems).rows;
  grains.stated = header.cell;
  if (!reading.options.length_unit) grains.notes.push_back(assumed_unit(reading.options, "length", "m", "length-unit"));
  return grains;
}

/// Calls `see` with the cells of a row of a .fstat file and its line, and `start` with the time of each step: where
/// lines that begin with # announce it, or where the time of the rows changes.
template <class Start, class See> void each_force(std::string_view text, const Start& start, const See& see) {
  Lines lines(text);
  bool in_header = false;
  std::string_view time;  // of the row before
  for (std::string_view line; lines.next(line);) {
    const auto cells = split_blanks(line);
    if (cells.empty()) continue;
    const bool is_header = cells.front().starts_with('#');
    if (is_header && !in_header) start(cells.size() > 1 ? to_number(cells[1]) : std::nullopt);
    if (!is_header && !in_header && cells.front() != time) start(to_number(cells.front()));
    in_header = is_header;
    if (is_header) continue;
    time = cells.front();
    see(cells, lines.number());
  }
}

std::vector<Moment> fstat_moments(std::string_view text, const std::string&) {
  std::vector<Moment> moments;
  each_force(
      text,
      [&](std::optional<double> time) {
        moments.push_back({std::nullopt, time});
      },
      [](const auto&, int) {});
  return moments;
}

/// To the six digits of a file.
bool is_along_axis(Vec3 n) { return std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)}) > (1 - 1e-9) * norm(n); }

RawContacts read_mercury_fstat(const Reading& reading, const RawGrains& grains) {
  RawContacts contacts;
  contacts.lists_both_ways = true;
  Problems& problems = reading.problems;
  std::size_t steps = 0;
  const auto add = [&](const std::vector<std::string_view>& cells, int at) {
    if (steps != reading.snapshot + 1) return;
    if (cells.size() != 16)
      return problems.add(
          at, "expected 16 values \"time i j x y z overlap tangential_overlap fn ft nx ny nz tx ty tz\", found {}",
          cells.size());
    const auto value = [&](std::size_t c, double factor) {
      return number_or_problem(cells[c], "value " + std::to_string(c + 1), factor, at, problems);
    };
    const auto vector = [&](std::size_t c) { return Vec3{value(c, 1), value(c + 1, 1), value(c + 2, 1)}; };
    RawContact c;
    c.line = at;
    c.i = integer_or_problem(cells[1], "i", at, problems);
    c.j = integer_or_problem(cells[2], "j", at, problems);
    c.overlap = value(6, reading.options.length());
    // n and t belong to the force on grain i; for a wall MercuryDPM turns both round.
    const Vec3 n = vector(10);
    const Vec3 force_on_i = value(8, reading.options.force()) * n + value(9, reading.options.force()) * vector(13);
    if (c.j < 0) {
      grains.laid([&](const auto& laid) { c.wall = side_towards(laid.frame.of(n)); });
      c.is_towards = true;
      if (grains.in_space && !is_along_axis(n)) c.wall = -1, c.boundary = "wall";
      c.force_on_j = force_on_i;
      c.normal = n;
    } else {
      c.force_on_j = -force_on_i;
      c.normal = -n;
    }
    contacts.rows.push_back(c);
  };
  each_force(
      reading.text, [&](std::optional<double>) { ++steps; }, add);
  if (steps == 0) problems.add("the file is empty; give a .fstat file with at least one time step");
  if (!reading.options.force_unit) contacts.notes.push_back(assumed_unit(reading.options, "force", "N", "force-unit"));
  return contacts;
}

}  // namespace

/// A time step of a MercuryDPM .data file: a line "N time xmin ymin xmax ymax", then N lines "x y vx vy radius angle
/// omega info", or both with the third coordinate; info is the species. Grains are numbered from 0 in their order. And
/// that of a .fstat file: lines "time i j x y z overlap tangential_overlap fn ft nx ny nz tx ty tz", n pointing to
/// grain i; j < 0 is a wall. Contacts of two grains are listed once for each of them.
const SampleFormat samples::mercury{
    .name = "mercury",
    .grains_are = "MercuryDPM .data",
    .contacts_are = "MercuryDPM .fstat",
    .states = {{"units", "none are in the files: m and N, told, or those given by options"},
               {"time",
                "grains and contacts are of the last time that both have; refused where they have none in common"},
               {"box", "taken; whether its sides are periodic is not in the file, --periodic says it"},
               {"third coordinate",
                "read where the file has it: centres within 2 % of a radius are a plane, x-y, x-z or y-z (the last two "
                "are told); within a radius a layer, told; beyond: spheres"},
               {"columns", "by the number of values a line, as MercuryDPM writes them"},
               {"overlap", "contacts without a force that do not overlap are left out and told"},
               {"contact point", "in the middle of the overlap, where MercuryDPM has it"},
               {"walls",
                "by the side they lie towards; of spheres those that lie along no axis keep their normal, told"},
               {"info", "the species is the material"}},
    .is_grains = [](std::string_view line) { return all_numbers(line, 6) || all_numbers(line, 8); },
    .is_contacts = is_fstat,
    .grains = read_mercury_data,
    .contacts = read_mercury_fstat,
    .grain_moments = data_moments,
    .contact_moments = fstat_moments};

}  // namespace arenite::io
