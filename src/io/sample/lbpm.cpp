#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/mapped.hpp"
#include "core/text.hpp"
#include "geometry/cell_grid.hpp"
#include "io/sample/formats.hpp"
#include "io/sample/named_columns.hpp"

namespace arenite::io {
namespace {

constexpr std::string_view lbpm_begins = "Number of Spheres:";

/// Cells behind the colon of a line, apart by blanks or commas.
std::vector<std::string_view> lbpm_values(std::string_view line) {
  std::vector<std::string_view> cells;
  for (const std::string_view part : split_cells(line.substr(line.find(':') + 1), ','))
    for (const std::string_view cell : split_blanks(part)) cells.push_back(cell);
  return cells;
}

/// Leaves out spheres outside the domain that are images of others inside: the program lists those that reach into it.
void drop_images(const RawCell& domain, RawGrains& grains) {
  const Vec3 size = by_axis<3>([&](int axis) { return domain.edge[axis][axis]; });
  const double slack = 1e-5 * std::min({size.x, size.y, size.z});  // six digits
  const auto inside = [&](Vec3 place) {
    for (int axis = 0; axis < 3; ++axis)
      if (!(place[axis] >= 0 && place[axis] < size[axis])) return false;
    return true;
  };
  const auto places = mapped(grains.rows, &RawGrain::place);
  const geometry::CellGrid<3> grid({{}, size}, std::max({size.x, size.y, size.z}) / 64, 64);
  const geometry::SortedCells cells(grid.size(), 0, places.size(), [&](std::size_t k) { return grid.cell(places[k]); });
  const auto is_image = [&](const RawGrain& grain) {
    if (inside(grain.place)) return false;
    const Vec3 home = by_axis<3>(
        [&](int axis) { return grain.place[axis] - size[axis] * std::floor(grain.place[axis] / size[axis]); });
    bool found = false;
    cells.for_near(grid, home, [&](std::int32_t other) {
      const auto k = static_cast<std::size_t>(other);
      found = found || (inside(places[k]) && norm(places[k] - home) <= slack);
    });
    return found;
  };
  if (const auto count = std::erase_if(grains.rows, is_image); count > 0)
    grains.notes.push_back(fmt::format("{} spheres are periodic images of others and are left out; {} remain.", count,
                                       grains.rows.size()));
}

RawGrains read_lbpm(const Reading& reading) {
  Problems& problems = reading.problems;
  Table table;
  for (const char* name : {"x", "y", "z", "radius"}) table.columns.push_back({name, {}, {}});
  std::optional<std::int64_t> announced;
  RawCell cell;
  cell.periodic = {true, true, true};
  Lines lines(reading.text);
  for (std::string_view line; lines.next(line);) {
    if (line.starts_with(lbpm_begins)) {
      const auto count = lbpm_values(line);
      if (!count.empty()) announced = to_integer(count.front());
      continue;
    }
    if (line.starts_with("Domain Length") && line.find(':') != line.npos) {
      const auto side = lbpm_values(line);
      if (side.size() != 3) problems.add(lines.number(), "a domain has three lengths");
      for (std::size_t axis = 0; axis < std::min<std::size_t>(side.size(), 3); ++axis)
        cell.edge[axis][static_cast<int>(axis)] =
            number_or_problem(side[axis], "Domain Length", reading.options.length(), lines.number(), problems);
      continue;
    }
    auto row = split_blanks(line);
    if (row.empty() || !to_number(row.front())) continue;
    if (row.size() == 4) table.rows.push_back({lines.number(), std::move(row)});
    else problems.add(lines.number(), "a sphere is its centre x, y, z and a radius, found {} values", row.size());
  }
  RawGrains grains = grains_in(table, "", reading.options, problems);
  if (announced && *announced != static_cast<std::int64_t>(grains.rows.size()))
    problems.add(1, "says {} spheres and holds {}; it is not whole", *announced, grains.rows.size());
  if (cell.edge[0].x > 0 && cell.edge[1].y > 0 && cell.edge[2].z > 0) {
    grains.stated = cell;
    drop_images(cell, grains);
  } else problems.add(1, "does not state its domain (\"Domain Length (x,y,z): 1, 1, 1\")");
  if (!reading.options.length_unit) grains.notes.push_back(assumed_unit(reading.options, "length", "m", "length-unit"));
  return grains;
}

}  // namespace

/// LBPM's pack.out: "Number of Spheres: N", "Domain Length (x,y,z): X, Y, Z" and other lines of words, then a sphere a
/// line, x y z radius, in a periodic box.
const SampleFormat samples::lbpm{
    .name = "lbpm",
    .grains_are = "LBPM's pack.out",
    .contacts_are = "a table, or where spheres overlap",
    .states = {{"units", "none are in the file: m, told, or that given by options"},
               {"step, time", "none are in the file"},
               {"box (Domain Length)", "taken as a periodic cell; a file without it is refused"},
               {"third coordinate", "read, as of tables"},
               {"columns", "x y z radius; lines of words are passed over"},
               {"number of spheres", "compared with those that follow"},
               {"spheres outside the box", "left out and told where they are images of others, else moved into it"},
               {"forces", "none are in the file"}},
    .is_grains = [](std::string_view line) { return line.starts_with(lbpm_begins); },
    .grains = read_lbpm};

}  // namespace arenite::io
