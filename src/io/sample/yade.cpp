#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/mapped.hpp"
#include "core/text.hpp"
#include "geometry/cell_grid.hpp"
#include "io/sample/formats.hpp"

namespace arenite::io {
namespace {

/// Finds the grain whose centre, or a periodic image of it, is a point, to the six digits that YADE writes.
class Centres {
 public:
  explicit Centres(const RawGrains& grains)
      : grains_(grains),
        largest_(grains.rows.empty() ? 0 : std::ranges::max_element(grains.rows, {}, &RawGrain::radius)->radius),
        places_(mapped(grains.rows, [&](const RawGrain& g) { return grains.cell.wrapped(g.centre); })),
        grid_(places_, std::max(2 * largest_, 1e-9)) {}

  /// Index of the grain, or -1.
  std::int64_t find(Vec2 p) const {
    constexpr double slack = 1e-3;
    const double digits = 1e-5 * (std::abs(p.x) + std::abs(p.y));
    const Domain& cell = grains_.cell;
    const Vec2 size = cell.size(), base = cell.wrapped(p);
    std::int64_t found = -1;
    for (int ky = -cell.periodic[1]; ky <= int{cell.periodic[1]}; ++ky)
      for (int kx = -cell.periodic[0]; kx <= int{cell.periodic[0]}; ++kx)
        grid_.within(
            base + Vec2{kx * size.x + ky * cell.tilt, ky * size.y}, digits + slack * largest_,
            [&](std::int32_t g, double square) {
              if (found < 0 && std::sqrt(square) <= digits + slack * grains_.rows[static_cast<std::size_t>(g)].radius)
                found = g;
            });
    return found;
  }

 private:
  const RawGrains& grains_;
  double largest_;
  std::vector<Vec2> places_;
  geometry::PointGrid grid_;
};

/// Reads the words of a legacy VTK file one after the other, knowing their lines.
struct Words {
  Lines lines;
  std::vector<std::string_view> of_line = {};
  std::size_t at = 0;

  std::string_view next() {
    for (std::string_view line; at == of_line.size(); at = 0)
      if (lines.next(line)) of_line = split_blanks(line);
      else return {};
    return of_line[at++];
  }
  void skip_line() { at = of_line.size(); }
};

std::vector<Vec3> read_points(Words& words, std::size_t count, double factor, Problems& problems) {
  std::vector<Vec3> points(count);
  for (Vec3& p : points)
    for (int axis = 0; axis < 3; ++axis) {
      const auto word = words.next();
      if (word.empty()) {
        problems.add(words.lines.number(), "the file is cut off; write it again");
        return {};
      }
      p[axis] = number_or_problem(word, "value", factor, words.lines.number(), problems);
    }
  return points;
}

/// Whether what pushes with this normal force may be a wall of the box: walls lie along sides that are not periodic.
bool may_be_wall(Vec2 n, const RawGrains& grains) {
  constexpr double slack = 1e-3;  // six digits, and walls that settled
  const double x = std::abs(n.x), y = std::abs(n.y);
  return (y <= slack * x && !grains.cell.periodic[0]) || (x <= slack * y && !grains.cell.periodic[1]);
}

std::string not_joined(std::size_t count, std::size_t all, const RawGrains& grains) {
  const bool cell = grains.cell.is_cell();
  return fmt::format(
      "{} of {} interactions end at no grain's centre, and their forces are not those of a wall of the box; {}", count,
      all,
      cell ? "the cell does not join the grains across its periodic sides: correct --box (O.cell.hSize) and --periodic"
           : "if they cross a periodic side give the cell by --box and --periodic; spheres and interactions must be "
             "written at the same step");
}

RawGrains read_yade_spheres(const Reading& reading) {
  RawGrains grains;
  const SampleOptions& options = reading.options;
  Problems& problems = reading.problems;
  Lines lines(reading.text);
  std::size_t id_columns = 0, material = 0;
  for (std::string_view line; lines.next(line);) {
    const auto cells = split_blanks(line);
    if (cells.empty()) continue;
    if (cells.front() == "#format" && cells.size() > 1) {
      id_columns = cells[1].starts_with("id_") ? 1 : 0;
      if (cells[1].ends_with("_matId")) material = id_columns + 4;
      continue;
    }
    if (cells.front().starts_with('#')) continue;
    const int at = lines.number();
    if (cells.size() < id_columns + 4 + (material > 0 ? 1 : 0)) {
      problems.add(at, "expected at least {} values according to the #format line, found {}",
                   id_columns + 4 + (material > 0 ? 1 : 0), cells.size());
      continue;
    }
    RawGrain g;
    g.line = at;
    g.id =
        id_columns ? integer_or_problem(cells[0], "id", at, problems) : static_cast<std::int64_t>(grains.rows.size());
    for (int axis = 0; axis < 3; ++axis)
      g.place[axis] = number_or_problem(cells[id_columns + static_cast<std::size_t>(axis)], "coordinate",
                                        options.length(), at, problems);
    g.radius = number_or_problem(cells[id_columns + 3], "r", options.length(), at, problems);
    if (material > 0) g.material = cells[material];
    grains.rows.push_back(std::move(g));
  }
  if (grains.rows.empty() && !problems.any()) problems.add("the file has no spheres; write them with export.textExt");
  if (!options.length_unit) grains.notes.push_back(assumed_unit("length", "m", "--length-unit"));
  return grains;
}

RawContacts read_yade_interactions(const Reading& reading, const RawGrains& grains) {
  RawContacts contacts;
  const SampleOptions& options = reading.options;
  Problems& problems = reading.problems;
  Words words{Lines(reading.text)};
  std::vector<Vec3> ends, normal, shear;
  std::size_t count = 0;
  for (auto word = words.next(); !word.empty(); word = words.next()) {
    if (word == "POINTS") {
      count = static_cast<std::size_t>(std::max<std::int64_t>(
                  0, integer_or_problem(words.next(), "number of points", words.lines.number(), problems))) /
              2;
      if (count > reading.text.size()) break;  // more than the file can hold
      words.skip_line();
      ends = read_points(words, 2 * count, options.length(), problems);
    } else if (word == "VECTORS") {
      const auto name = words.next();
      words.skip_line();
      auto values = read_points(words, count, options.force(), problems);
      if (name == "normalForce" || name == "fn") normal = std::move(values);
      if (name == "shearForce" || name == "fs") shear = std::move(values);
    }
    if (problems.any()) return contacts;
  }
  if (ends.size() != 2 * count || normal.size() != count || shear.size() != count) {
    problems.add(
        "the vectors normalForce and shearForce are missing; write them with exportInteractions(what={'normalForce': "
        "'i.phys.normalForce', 'shearForce': 'i.phys.shearForce'})");
    return contacts;
  }
  const Plane& plane = grains.plane;
  const Centres centres(grains);
  std::size_t not_of_walls = 0, without_grain = 0;
  for (std::size_t c = 0; c < count; ++c) {
    const Vec2 first = plane.of(ends[2 * c]), second = plane.of(ends[2 * c + 1]);
    Vec3 n = normal[c], force = n + shear[c];
    std::int64_t i = centres.find(first), j = centres.find(second);
    if (i < 0 && j < 0) {
      ++without_grain;
      continue;
    }
    RawContact row;
    if (i < 0) {  // the wall comes first: look from the grain
      std::swap(i, j);
      n = -n;
      force = -force;
    }
    row.i = grains.rows[static_cast<std::size_t>(i)].id;
    row.force_on_j = force;
    if (j < 0) {
      not_of_walls += !may_be_wall(plane.of(n), grains);
      row.wall = side_towards(plane.of(n));
    } else {
      row.j = grains.rows[static_cast<std::size_t>(j)].id;
      const Vec3 branch = ends[2 * c + 1] - ends[2 * c];
      if (norm(second - first) > 0) row.normal = branch / norm(second - first);
    }
    contacts.rows.push_back(row);
  }
  if (not_of_walls > 0) problems.add(not_joined(not_of_walls, count, grains));
  if (!options.force_unit) contacts.notes.push_back(assumed_unit("force", "N", "--force-unit"));
  if (without_grain > 0)
    contacts.notes.push_back(
        fmt::format("{} of {} interactions belong to no grain in the list and are left out.", without_grain, count));
  return contacts;
}

}  // namespace

/// Spheres written by YADE's export.text or export.textExt: "#format x_y_z_r" (or x_y_z_r_matId, x_y_z_r_attrs,
/// id_x_y_z_r_matId), then one sphere a line. Without ids spheres are numbered from 0 in their order. Interactions
/// written by VTKExporter.exportInteractions with what = {'normalForce': 'i.phys.normalForce', 'shearForce':
/// 'i.phys.shearForce'}: both centres of every interaction and the force on the second body. The file has no ids, so
/// ends are matched with the centres of the grains; an end that is no grain's centre is a wall.
const SampleFormat samples::yade{
    .name = "yade",
    .grains_are = "YADE export.textExt",
    .contacts_are = "YADE VTKExporter.exportInteractions of normalForce and shearForce",
    .states = {{"units", "none are in the files: m and N, told, or those given by options"},
               {"step, time",
                "none are in the files; interactions that end at no grain's centre show another step and are refused"},
               {"cell",
                "none is in the files; --box and --periodic give it, and periodic sides without it are refused"},
               {"third coordinate",
                "centres within 2 % of a radius are a plane, x-y, x-z or y-z (the last two are told); within a radius "
                "a layer, told; beyond: refused"},
               {"columns", "by the #format line; vectors of interactions by their names"},
               {"interactions without a force", "contacts where they overlap, else left out and told"},
               {"matId", "the material"}},
    .is_grains = [](std::string_view line) { return line.starts_with("#format"); },
    .is_contacts = [](std::string_view line) { return line.starts_with("# vtk DataFile"); },
    .grains = read_yade_spheres,
    .contacts = read_yade_interactions};

}  // namespace arenite::io
