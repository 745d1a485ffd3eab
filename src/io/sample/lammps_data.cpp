#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/text.hpp"
#include "io/sample/formats.hpp"
#include "io/sample/lammps_dump.hpp"
#include "io/sample/named_columns.hpp"

namespace arenite::io {
namespace {

/// The word behind "name =" in the first line, as write_data writes it: "timestep = 500, units = si".
std::string_view said(std::string_view line, std::string_view name) {
  const std::size_t at = line.find(name);
  if (at == line.npos) return {};
  std::string_view rest = trimmed(line.substr(at + name.size()));
  if (!rest.starts_with('=')) return {};
  rest = trimmed(rest.substr(1));
  return rest.substr(0, std::min(rest.find_first_of(", \t"), rest.size()));
}

std::string_view top_line(std::string_view text) { return text.substr(0, std::min(text.find('\n'), text.size())); }

std::vector<Moment> data_file_moments(std::string_view text, const std::string&) {
  const auto step = to_integer(said(top_line(text), "timestep"));
  return step ? std::vector<Moment>{{step, std::nullopt}} : std::vector<Moment>{};
}

/// Columns of the section Atoms by its style; behind them may stand three numbers of images.
const std::map<std::string_view, std::vector<const char*>>& columns_by_style() {
  static const std::map<std::string_view, std::vector<const char*>> all{
      {"sphere", {"id", "material", "diameter", "", "x", "y", "z"}},
      {"bpm/sphere", {"id", "", "material", "diameter", "", "x", "y", "z"}}};
  return all;
}

/// Sides of the box as the header has them, in the file's unit.
struct DataBox {
  RawCell cell;
  std::array<bool, 3> has{};

  /// Whether a line is one of them.
  bool takes(const std::vector<std::string_view>& cells, double length, int line, Problems& problems) {
    const auto number = [&](std::size_t k) { return number_or_problem(cells[k], "box bound", length, line, problems); };
    constexpr const char* ends[3][2] = {{"xlo", "xhi"}, {"ylo", "yhi"}, {"zlo", "zhi"}};
    for (int axis = 0; axis < 3; ++axis)
      if (cells.size() == 4 && cells[2] == ends[axis][0] && cells[3] == ends[axis][1]) {
        cell.corner[axis] = number(0);
        cell.edge[axis][axis] = number(1) - number(0);
        return has[axis] = true;
      }
    if (cells.size() != 6 || cells[3] != "xy") return false;
    cell.edge[1].x = number(0);
    cell.edge[2].x = number(1);
    cell.edge[2].y = number(2);
    return true;
  }
};

RawGrains read_data(const Reading& reading) {
  RawGrains grains;
  Problems& problems = reading.problems;
  const std::string_view system = said(top_line(reading.text), "units");
  const auto units = unit_system(system, reading.options, problems);
  SampleOptions options = reading.options;
  if (units) options.length_unit = units->length;
  DataBox box;
  Table table;
  std::string_view section;
  std::int64_t announced = -1;
  Lines lines(reading.text);
  std::string_view line;
  lines.next(line);  // which LAMMPS passes over
  while (lines.next(line)) {
    const std::size_t hash = std::min(line.find('#'), line.size());
    auto cells = split_blanks(line.substr(0, hash));
    if (cells.empty()) continue;
    if (!to_number(cells.front())) {
      section = trimmed(line.substr(0, hash));
      if (section != "Atoms") continue;
      const std::string_view style = trimmed(line.substr(std::min(hash + 1, line.size())));
      table.header_line = lines.number();
      const auto known = columns_by_style().find(style);
      if (known == columns_by_style().end()) {
        problems.add(lines.number(),
                     "the section Atoms is of style \"{}\", but only sphere and bpm/sphere have diameters; write it as "
                     "\"Atoms # sphere\"",
                     style);
        return grains;
      }
      for (const char* name : known->second) table.columns.push_back({name, {}, {}});
    } else if (section == "Atoms") {
      const std::size_t wanted = table.columns.size();
      if (cells.size() != wanted && cells.size() != wanted + 3)
        problems.add(lines.number(), "an atom of this style has {} values, or {} with images, found {}", wanted,
                     wanted + 3, cells.size());
      cells.resize(wanted, "0");
      table.rows.push_back({lines.number(), std::move(cells)});
    } else if (section.empty() && !box.takes(cells, options.length(), lines.number(), problems)) {
      if (cells.size() == 2 && cells[1] == "atoms") announced = to_integer(cells[0]).value_or(-1);
    }
  }
  if (table.header_line == 0) problems.add("the file has no section \"Atoms # sphere\"; write it with write_data");
  if (announced >= 0 && announced != std::ssize(table.rows))
    problems.add(table.header_line, "the file announces {} atoms, but {} follow; {}, so write it again", announced,
                 table.rows.size(), is_cut_off(announced, table.rows.size()));
  if (problems.any()) return grains;
  grains = grains_in(table, "Atoms # sphere", options, problems);
  grains.units = units;
  if (box.has == std::array{true, true, true}) grains.stated = box.cell;
  if (!options.length_unit) grains.notes.push_back(assumed_unit_of(options, system, "length", "m", "length-unit"));
  return grains;
}

}  // namespace

/// LAMMPS's write_data of atom_style sphere or bpm/sphere: a header with the box, then "Atoms # sphere" with a row an
/// atom, id type diameter density x y z and perhaps three numbers of images. Contacts are those of a dump local.
const SampleFormat samples::lammps_data{
    .name = "lammps_data",
    .grains_are = "LAMMPS write_data of atom_style sphere",
    .contacts_are = "as of lammps, a table, or where spheres overlap",
    .states = {{"units (first line)",
                "taken; without: those of the contacts' dump, or m, told, or that given by options"},
               {"step (first line)", "compared with that of the contacts"},
               {"box, tilt",
                "taken; refused where it is tilted in another way than along x with y. Whether its sides are "
                "periodic is not in the file, --periodic says it"},
               {"z", "read, as of dumps"},
               {"columns", "by the style behind \"Atoms #\"; other styles are refused"},
               {"images, velocities, other sections", "passed over"},
               {"type", "the material"},
               {"forces", "none are in the file"}},
    .is_grains = [](std::string_view line) { return line.starts_with("LAMMPS data file"); },
    .grains = read_data,
    .grain_moments = data_file_moments,
    .units_named = [](std::string_view text) { return said(top_line(text), "units"); }};

}  // namespace arenite::io
