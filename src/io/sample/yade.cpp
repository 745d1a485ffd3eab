#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/option.hpp"
#include "core/text.hpp"
#include "io/sample/centres.hpp"
#include "io/sample/formats.hpp"
#include "io/sample/named_columns.hpp"

namespace arenite::io {
namespace {

constexpr std::string_view periodic_word = "##PERIODIC::";

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

/// Places of columns, by their names in the #format line.
struct SphereColumns {
  std::array<std::size_t, 4> place{0, 1, 2, 3};  ///< of x, y, z, r
  std::optional<std::size_t> id, material;
  std::size_t count = 4;  ///< that a row must have
};
/// "id_x_y_z_r_matId"; what else stands there lies behind these (attrs). A name that is none of them may be a diameter.
SphereColumns sphere_columns(std::string_view format, int line, Problems& problems) {
  SphereColumns columns;
  const auto names = split_cells(format, '_');
  const auto find = [&](std::string_view name) -> std::optional<std::size_t> {
    const auto at = std::ranges::find(names, name);
    return at == names.end() ? std::nullopt : std::optional(static_cast<std::size_t>(at - names.begin()));
  };
  constexpr std::string_view needed[] = {"x", "y", "z", "r"};
  for (std::size_t k = 0; k < 4; ++k) {
    const auto at = find(needed[k]);
    if (!at) {
      problems.add(line, "the #format line is {} and names no {}; export x_y_z_r, x_y_z_r_matId or id_x_y_z_r_matId",
                   format, needed[k]);
      return columns;
    }
    columns.place[k] = *at;
  }
  columns.id = find("id");
  columns.material = find("matId");
  columns.count = 1 + std::max({std::ranges::max(columns.place), columns.id.value_or(0), columns.material.value_or(0)});
  return columns;
}

/// The cell that SpherePack.save states: "##PERIODIC:: 4 4 4".
RawCell periodic_cell(const std::vector<std::string_view>& cells, double length, int line, Problems& problems) {
  RawCell cell;
  cell.periodic = {true, true, true};
  if (cells.size() != 4) problems.add(line, "##PERIODIC:: has {} lengths instead of 3; correct it", cells.size() - 1);
  else
    for (std::size_t k = 0; k < 3; ++k)
      cell.edge[k][static_cast<int>(k)] = number_or_problem(cells[k + 1], "##PERIODIC::", length, line, problems);
  return cell;
}

RawGrains read_yade_spheres(const Reading& reading) {
  RawGrains grains;
  const SampleOptions& options = reading.options;
  Problems& problems = reading.problems;
  Lines lines(reading.text);
  SphereColumns columns;
  for (std::string_view line; lines.next(line) && !problems.any();) {
    const auto cells = split_blanks(line);
    const int at = lines.number();
    if (cells.empty()) continue;
    if (cells.front() == periodic_word) grains.stated = periodic_cell(cells, options.length(), at, problems);
    if (cells.front() == "#format" && cells.size() > 1) columns = sphere_columns(cells[1], at, problems);
    if (cells.front().starts_with('#')) continue;
    if (cells.size() < columns.count) {
      problems.add(at, "expected at least {} values according to the #format line, found {}", columns.count,
                   cells.size());
      continue;
    }
    const auto length = [&](std::size_t k) {
      return number_or_problem(cells[columns.place[k]], k < 3 ? "coordinate" : "r", options.length(), at, problems);
    };
    RawGrain g;
    g.line = at;
    g.id = columns.id ? integer_or_problem(cells[*columns.id], "id", at, problems)
                      : static_cast<std::int64_t>(grains.rows.size());
    g.place = {length(0), length(1), length(2)};
    g.radius = length(3);
    if (columns.material) g.material = cells[*columns.material];
    grains.rows.push_back(std::move(g));
  }
  if (grains.rows.empty() && !problems.any()) problems.add("the file has no spheres; write them with export.textExt");
  if (!options.length_unit) grains.notes.push_back(assumed_unit(options, "length", "m", "length-unit"));
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
  if (!options.force_unit) contacts.notes.push_back(assumed_unit(options, "force", "N", "force-unit"));
  grains.laid([&](const auto& laid) { add_interactions(found, grains, laid, contacts, problems); });
  return contacts;
}

}  // namespace

/// Spheres written by YADE's export.text or export.textExt: "#format x_y_z_r" (or x_y_z_r_matId, x_y_z_r_attrs,
/// id_x_y_z_r_matId), then one sphere a line; or by SpherePack.save of a periodic pack. Without ids spheres are
/// numbered from 0 in their order. Interactions written by VTKExporter.exportInteractions with what = {'normalForce':
/// 'i.phys.normalForce', 'shearForce': 'i.phys.shearForce'}: both centres of every interaction and the force on the
/// second body. The file has no ids, so ends are matched with the centres of the grains; an end that is no grain's
/// centre is a wall.
const SampleFormat samples::yade{
    .name = "yade",
    .grains_are = "YADE export.textExt",
    .contacts_are = "YADE VTKExporter.exportInteractions of normalForce and shearForce",
    .states =
        {{"units", "none are in the files: m and N, told, or those given by options"},
         {"step, time",
          "none are in the files; interactions that end at no grain's centre show another step and are refused"},
         {"cell",
          "that of SpherePack.save (##PERIODIC::) is taken; none is in other files: --box and --periodic give it, "
          "and periodic sides without it are refused"},
         {"third coordinate",
          "centres within 2 % of a radius are a plane, x-y, x-z or y-z (the last two are told); within a radius "
          "a layer, told; beyond: spheres"},
         {"columns",
          "by their names in the #format line, refused where x, y, z and r are not among them; without it x, y, "
          "z, r; vectors of interactions by their names"},
         {"interactions without a force", "contacts where they overlap, else left out and told"},
         {"matId", "the material"}},
    .is_grains = [](std::string_view line) { return line.starts_with("#format") || line.starts_with(periodic_word); },
    .is_contacts = [](std::string_view line) { return line.starts_with("# vtk DataFile"); },
    .grains = read_yade_spheres,
    .contacts = read_yade_interactions};

}  // namespace arenite::io
