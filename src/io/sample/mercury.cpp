#include "io/sample/sample.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "io/table/table.hpp"

namespace arenite::io {
namespace {

bool all_numbers(std::string_view line, std::size_t count) {
  const auto cells = split_blanks(line);
  return cells.size() == count && std::ranges::all_of(cells, [](std::string_view cell) { return to_number(cell).has_value(); });
}

void read_header(const std::vector<std::string_view>& cells, int line, double length, RawGrains& grains, Problems& problems) {
  const auto bound = [&](std::size_t c) { return number_or_problem(cells[c], "box bound", length, line, problems); };
  const Vec2 low{bound(2), bound(3)}, high{bound(4), bound(5)};
  grains.lay_box(low, high);
  grains.has_box = high.x > low.x && high.y > low.y;
}

RawGrains read_mercury_data(std::string_view text, const SampleOptions& options, Problems& problems) {
  RawGrains grains;
  Table table;
  for (const char* name : {"x", "y", "", "", "radius", "", "", "material"}) table.columns.push_back({name, {}, {}});
  Lines lines(text);
  std::int64_t expected = 0, found = 0;
  for (std::string_view line; lines.next(line);) {
    auto cells = split_blanks(line);
    if (cells.empty()) continue;
    const int at = lines.number();
    if (found == expected) {
      const auto count = to_integer(cells.front());
      if (cells.size() != 6 || !count || *count < 0) {
        problems.add(at, "expected \"N time xmin ymin xmax ymax\" of a plane simulation, found {} values; write the file with system dimension 2",
                     cells.size());
        return grains;
      }
      expected = *count;
      found = 0;
      table.header_line = at;
      table.rows.clear();
      read_header(cells, at, options.length(), grains, problems);
      continue;
    }
    ++found;
    if (cells.size() == table.columns.size()) table.rows.push_back({at, std::move(cells)});
    else problems.add(at, "expected 8 values \"x y vx vy radius angle omega info\", found {}", cells.size());
  }
  if (table.header_line == 0) problems.add("the file is empty; give a .data file with at least one time step");
  if (found < expected) problems.add(table.header_line, "{} grains are announced, but {} follow; the file is cut off", expected, found);
  grains.rows = grains_in(table, "", options, problems).rows;
  return grains;
}

RawContacts read_mercury_fstat(std::string_view text, const RawGrains&, const SampleOptions& options, Problems& problems) {
  RawContacts contacts;
  contacts.lists_both_ways = true;
  Lines lines(text);
  bool in_header = false, any = false;
  for (std::string_view line; lines.next(line);) {
    const auto cells = split_blanks(line);
    if (cells.empty()) continue;
    any = true;
    if (cells.front().starts_with('#')) {
      if (!in_header) contacts.rows.clear();  // a new time step
      in_header = true;
      continue;
    }
    in_header = false;
    const int at = lines.number();
    if (cells.size() != 16) {
      problems.add(at, "expected 16 values \"time i j x y z overlap tangential_overlap fn ft nx ny nz tx ty tz\", found {}", cells.size());
      continue;
    }
    const auto value = [&](std::size_t c, double factor) { return number_or_problem(cells[c], "value " + std::to_string(c + 1), factor, at, problems); };
    RawContact c;
    c.line = at;
    c.i = integer_or_problem(cells[1], "i", at, problems);
    c.j = integer_or_problem(cells[2], "j", at, problems);
    const double fn = value(8, options.force()), ft = value(9, options.force());
    const Vec2 n{value(10, 1), value(11, 1)}, t{value(13, 1), value(14, 1)};
    // n and t belong to the force on grain i; for a wall MercuryDPM turns both round.
    const Vec2 force_on_i = fn * n + ft * t;
    if (c.j < 0) {
      c.wall = side_towards(n);
      c.force_on_j = force_on_i;
      c.normal = n;
    } else {
      c.force_on_j = -force_on_i;
      c.normal = -n;
    }
    contacts.rows.push_back(c);
  }
  if (!any) problems.add("the file is empty; give a .fstat file with at least one time step");
  return contacts;
}

}  // namespace

/// The last time step of a MercuryDPM .data file of a plane simulation: a line "N time xmin ymin xmax ymax", then N lines "x y vx vy radius angle
/// omega info"; info is the species. Grains are numbered from 0 in their order. And that of a .fstat file: lines "time i j x y z overlap
/// tangential_overlap fn ft nx ny nz tx ty tz", n pointing to grain i; j < 0 is a wall. Contacts of two grains are listed once for each of them.
const SampleFormat samples::mercury{.name = "mercury",
                                    .grains_are = "MercuryDPM .data of a plane system",
                                    .contacts_are = "MercuryDPM .fstat",
                                    .is_grains = [](std::string_view line) { return all_numbers(line, 6); },
                                    .is_contacts = [](std::string_view line) { return line.starts_with('#') || all_numbers(line, 16); },
                                    .grains = read_mercury_data,
                                    .contacts = read_mercury_fstat};

}  // namespace arenite::io
