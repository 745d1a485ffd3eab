#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/mapped.hpp"
#include "core/option.hpp"
#include "core/text.hpp"
#include "geometry/cell_grid.hpp"
#include "geometry/close_pairs.hpp"
#include "io/sample/formats.hpp"

namespace arenite::io {
namespace {

/// Finds the grain whose centre, or a periodic image of it, is a point, to the six digits that YADE writes.
template <int D> class Centres {
 public:
  Centres(const std::vector<RawGrain>& rows, const Laid<D>& laid)
      : rows_(rows),
        cell_(laid.cell),
        largest_(rows.empty() ? 0 : std::ranges::max_element(rows, {}, &RawGrain::radius)->radius),
        places_(mapped(rows, [&](const RawGrain& g) { return laid.cell.wrapped(laid.frame.of(g.place)); })),
        grid_(geometry::around(std::span<const Vec<D>>(places_)), std::max(2 * largest_, 1e-9), most_cells),
        cells_(grid_.size(), 0, places_.size(), [&](std::size_t k) { return grid_.cell(places_[k]); }) {}

  /// Index of the grain, or -1.
  std::int64_t find(Vec<D> p) const {
    constexpr double slack = 1e-3;
    double digits = 0;
    for (int axis = 0; axis < D; ++axis) digits += 1e-5 * std::abs(p[axis]);
    const Vec<D> base = cell_.wrapped(p);
    std::int64_t found = -1;
    cell_.each_near_cell([&](Cells<D> cells) {
      const Vec<D> image = base + cell_.way(cells);
      cells_.for_near(grid_, image, [&](std::int32_t g) {
        const double reach = digits + slack * rows_[static_cast<std::size_t>(g)].radius;
        if (found < 0 && norm(places_[static_cast<std::size_t>(g)] - image) <= reach) found = g;
      });
    });
    return found;
  }

 private:
  static constexpr double most_cells = D == 2 ? 4096 : 64;  // along a side
  const std::vector<RawGrain>& rows_;
  const DomainIn<D>& cell_;
  double largest_;
  std::vector<Vec<D>> places_;
  geometry::CellGrid<D> grid_;
  geometry::SortedCells cells_;
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
template <int D> bool may_be_wall(Vec<D> n, const Laid<D>& laid) {
  constexpr double slack = 1e-3;  // six digits, and walls that settled
  for (int along = 0; along < D; ++along) {
    bool may = !laid.cell.periodic[along];
    for (int axis = 0; axis < D; ++axis)
      may = may && (axis == along || std::abs(n[axis]) <= slack * std::abs(n[along]));
    if (may) return true;
  }
  return false;
}

std::string not_joined(std::size_t count, std::size_t all, bool cell) {
  return fmt::format(
      "{} of {} interactions end at no grain's centre, and their forces are not those of a wall of the box; {}", count,
      all,
      cell
          ? fmt::format("the cell does not join the grains across its periodic sides: correct {} (O.cell.hSize) and {}",
                        option("box"), option("periodic"))
          : fmt::format("if they cross a periodic side give the cell by {} and {}; spheres and interactions must be "
                        "written at the same step",
                        option("box"), option("periodic")));
}

/// Of each interaction both ends, and the forces on its second body.
struct Interactions {
  std::vector<Vec3> ends, normal, shear;
};

template <int D>
void add_interactions(const Interactions& from, const RawGrains& grains, const Laid<D>& laid, RawContacts& contacts,
                      Problems& problems) {
  const Centres<D> centres(grains.rows, laid);
  const std::size_t count = from.normal.size();
  std::size_t not_of_walls = 0, without_grain = 0;
  for (std::size_t c = 0; c < count; ++c) {
    const Vec3 branch = from.ends[2 * c + 1] - from.ends[2 * c];
    Vec3 n = from.normal[c], force = n + from.shear[c];
    std::int64_t i = centres.find(laid.frame.of(from.ends[2 * c])),
                 j = centres.find(laid.frame.of(from.ends[2 * c + 1]));
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
      not_of_walls += !may_be_wall(laid.frame.of(n), laid);
      row.wall = side_towards(laid.frame.of(n));
      row.is_towards = true;
    } else {
      row.j = grains.rows[static_cast<std::size_t>(j)].id;
      if (const double length = norm(laid.frame.of(branch)); length > 0) row.normal = branch / length;
    }
    contacts.rows.push_back(row);
  }
  if (not_of_walls > 0) problems.add(not_joined(not_of_walls, count, laid.cell.is_cell()));
  if (without_grain > 0)
    contacts.notes.push_back(
        fmt::format("{} of {} interactions belong to no grain in the list and are left out.", without_grain, count));
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
      material = cells[1].ends_with("_matId") ? id_columns + 4 : 0;
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
  if (!options.length_unit) grains.notes.push_back(assumed_unit("length", "m", "length-unit"));
  return grains;
}

RawContacts read_yade_interactions(const Reading& reading, const RawGrains& grains) {
  RawContacts contacts;
  const SampleOptions& options = reading.options;
  Problems& problems = reading.problems;
  Words words{Lines(reading.text)};
  Interactions found;
  auto& [ends, normal, shear] = found;
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
  if (!options.force_unit) contacts.notes.push_back(assumed_unit("force", "N", "force-unit"));
  grains.laid([&](const auto& laid) { add_interactions(found, grains, laid, contacts, problems); });
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
                "a layer, told; beyond: spheres"},
               {"columns", "by the #format line; vectors of interactions by their names"},
               {"interactions without a force", "contacts where they overlap, else left out and told"},
               {"matId", "the material"}},
    .is_grains = [](std::string_view line) { return line.starts_with("#format"); },
    .is_contacts = [](std::string_view line) { return line.starts_with("# vtk DataFile"); },
    .grains = read_yade_spheres,
    .contacts = read_yade_interactions};

}  // namespace arenite::io
