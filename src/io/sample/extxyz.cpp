#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/text.hpp"
#include "core/units.hpp"
#include "io/sample/formats.hpp"
#include "io/sample/named_columns.hpp"
#include "io/table/comment_units.hpp"
#include "io/table/table.hpp"

namespace arenite::io {
namespace {

/// The second line of a frame: name=value or name="several values", which some write in single quotes, brackets or
/// braces; names in lower case.
std::map<std::string, std::string_view> pairs_in(std::string_view line) {
  std::map<std::string, std::string_view> pairs;
  while (true) {
    line = trimmed(line);
    const std::size_t equals = line.find('=');
    if (equals == line.npos) return pairs;
    std::string_view name = trimmed(line.substr(0, equals));
    if (const auto blank = name.find_last_of(" \t"); blank != name.npos) name.remove_prefix(blank + 1);
    line = trimmed(line.substr(equals + 1));
    constexpr std::string_view opening = "\"'[{", closing = "\"']}";
    const std::size_t quote = line.empty() ? opening.npos : opening.find(line.front());
    const bool quoted = quote != opening.npos;
    if (quoted) line.remove_prefix(1);
    const std::size_t end = std::min(quoted ? line.find(closing[quote]) : line.find_first_of(" \t"), line.size());
    pairs.emplace(lower_case(name), line.substr(0, end));
    line.remove_prefix(std::min(end + (quoted ? 1 : 0), line.size()));
  }
}

/// Calls `see` with the number of grains and the second line of each frame and passes over its rows, unless `see`
/// reads them itself and says so; what is no frame ends it.
template <class See> void each_frame(std::string_view text, const See& see) {
  Lines lines(text);
  for (std::string_view line; lines.next(line);) {
    if (trimmed(line).empty()) continue;
    const auto count = to_integer(trimmed(line));
    if (!count || *count < 0 || !lines.next(line)) return;
    if (see(*count, line, lines)) return;
    for (std::int64_t row = 0; row < *count; ++row)
      if (!lines.next(line)) return;
  }
}

std::vector<Moment> moments_xyz(std::string_view text, const std::string&) {
  std::vector<Moment> moments;
  each_frame(text, [&](std::int64_t, std::string_view comment, Lines&) {
    const auto pairs = pairs_in(comment);
    Moment& moment = moments.emplace_back();
    for (const char* name : {"step", "timestep"})
      if (const auto at = pairs.find(name); at != pairs.end()) moment.step = to_integer(at->second);
    if (const auto at = pairs.find("time"); at != pairs.end()) moment.time = to_number(at->second);
    return false;
  });
  return moments;
}

/// "species:S:1:pos:R:3:.." as names of columns as `grains_in` knows them; of others none. Nothing where it cannot be
/// read.
std::vector<std::string> property_columns(std::string_view properties) {
  const auto parts = split_cells(properties, ':');
  std::vector<std::string> names;
  for (std::size_t k = 0; k + 2 < parts.size(); k += 3) {
    const std::string name = lower_case(parts[k]);
    const auto width = to_integer(parts[k + 2]);
    if (!width || *width < 1 || *width > 64) return {};
    const bool single = *width == 1;
    if ((name == "pos" || name == "position") && *width == 3) names.insert(names.end(), {"x", "y", "z"});
    else if (single && (name == "radius" || name == "radii")) names.emplace_back("radius");
    else if (single && (name == "id" || name == "diameter" || name == "zone")) names.push_back(name);
    else if (single && (name == "material" || name == "type")) names.emplace_back("material");
    else names.insert(names.end(), static_cast<std::size_t>(*width), "");
  }
  for (const char* name : {"x", "radius", "diameter", "id", "zone", "material"})
    if (std::ranges::count(names, name) > 1) return {};
  return names;
}

/// Which sides are periodic, as three words or one for all; nothing where they say something else.
std::optional<std::array<bool, 3>> periodic_sides(std::string_view stated) {
  std::string text = lower_case(stated);
  std::ranges::replace(text, ',', ' ');
  std::vector<bool> flags;
  for (const std::string_view word : split_blanks(text)) {
    const bool yes = word == "t" || word == "true" || word == "1" || word == "yes";
    if (!yes && word != "f" && word != "false" && word != "0" && word != "no") return std::nullopt;
    flags.push_back(yes);
  }
  if (flags.size() == 1) flags.resize(3, flags.front());
  if (flags.size() != 3) return std::nullopt;
  return std::array{bool(flags[0]), bool(flags[1]), bool(flags[2])};
}

/// The three edges and the corner; periodic along all axes unless the file says otherwise.
std::optional<RawCell> cell_in(const std::map<std::string, std::string_view>& pairs, double length, int line,
                               Problems& problems) {
  const auto numbers = [&](const char* name, std::size_t count) {
    std::vector<double> values;
    const auto at = pairs.find(name);
    if (at == pairs.end()) return values;
    for (const std::string_view cell : split_blanks(at->second))
      values.push_back(number_or_problem(cell, name, length, line, problems));
    if (values.size() != count)
      problems.add(line, "{} has {} numbers instead of {}; correct it", name, values.size(), count);
    values.resize(count, 0.0);
    return values;
  };
  const auto edges = numbers("lattice", 9), corner = numbers("origin", 3);
  if (edges.empty()) return std::nullopt;
  RawCell cell;
  for (std::size_t k = 0; k < 9; ++k) cell.edge[k / 3][static_cast<int>(k % 3)] = edges[k];
  for (std::size_t k = 0; k < corner.size(); ++k) cell.corner[static_cast<int>(k)] = corner[k];
  cell.periodic = {true, true, true};
  if (const auto at = pairs.find("pbc"); at != pairs.end()) {
    if (const auto stated = periodic_sides(at->second)) cell.periodic = *stated;
    else problems.add(line, "pbc says \"{}\", which is not understood; write three of T and F", at->second);
  }
  return cell;
}

/// The names of numbered materials, "1:POM 2:HDPE", as this program's own export states them; none of what is written
/// in another way.
MaterialNames material_names(std::string_view stated) {
  MaterialNames names;
  for (const std::string_view word : split_blanks(stated)) {
    const auto parts = split_cells(word, ':');
    if (parts.size() != 2 || !to_integer(parts[0]) || parts[1].empty()) return {};
    names.emplace(parts[0], parts[1]);
  }
  return names;
}

RawGrains read_xyz(const Reading& reading) {
  RawGrains grains;
  Problems& problems = reading.problems;
  SampleOptions options = reading.options;
  Table table;
  MaterialNames names;
  std::size_t frame = 0;
  each_frame(reading.text, [&](std::int64_t count, std::string_view comment, Lines& lines) {
    if (frame++ < reading.snapshot) return false;
    table.header_line = lines.number();
    const auto pairs = pairs_in(comment);
    const auto properties = pairs.find("properties");
    for (const std::string& name :
         properties == pairs.end() ? std::vector<std::string>{} : property_columns(properties->second))
      table.columns.push_back({name, {}, {}});
    if (table.columns.empty())
      problems.add(lines.number(),
                   "the second line says no Properties that can be read; write extended XYZ with "
                   "Properties=pos:R:3:radius:R:1");
    for (const char* name : {"units", "unit", "length_unit"})
      if (const auto at = pairs.find(name); at != pairs.end() && !options.length_unit)
        if (const std::string unit = unit_among(at->second, dimension::length); !unit.empty())
          options.length_unit = unit_factor(unit, dimension::length);
    grains.stated = cell_in(pairs, options.length(), lines.number(), problems);
    if (const auto stated = pairs.find("materials"); stated != pairs.end()) names = material_names(stated->second);
    std::string_view line;
    while (std::ssize(table.rows) < count && lines.next(line))
      table.rows.push_back({lines.number(), split_blanks(line)});
    if (std::ssize(table.rows) < count)
      problems.add(table.header_line, "{} grains are announced, but {} follow; the file is cut off", count,
                   table.rows.size());
    bool more = false;
    while (!more && lines.next(line)) more = !trimmed(line).empty();
    if (more && !to_integer(trimmed(line)))
      problems.add(lines.number(), "{} grains are announced, but more rows follow; correct the number", count);
    return true;
  });
  if (table.header_line == 0) problems.add("the file is empty; give extended XYZ with at least one frame");
  for (const auto& [line, cells] : table.rows)
    if (cells.size() != table.columns.size() && !table.columns.empty())
      problems.add(line, "this row has {} values, but Properties names {}; the file is cut off or damaged",
                   cells.size(), table.columns.size());
  if (problems.any()) return grains;
  const auto cell = grains.stated;
  grains = grains_in(table, "Properties need pos:R:3 and radius:R:1", options, problems);
  grains.stated = cell;
  grains.material_name = std::move(names);
  if (!options.length_unit) grains.notes.push_back(assumed_unit(options, "length", "m", "length-unit"));
  return grains;
}

bool is_count(std::string_view line) {
  line = trimmed(line);
  return !line.empty() && std::ranges::all_of(line, [](unsigned char c) { return std::isdigit(c) != 0; });
}

}  // namespace

/// Extended XYZ as OVITO and ASE write it: the number of grains, a line with Lattice, Origin, pbc, Time, Step and
/// Properties, and a row a grain; frames follow one another.
const SampleFormat samples::extxyz{
    .name = "extxyz",
    .grains_are = "extended XYZ with pos and radius",
    .contacts_are = "a table, or where spheres overlap",
    .states =
        {{"units (units=mm or length_unit=mm in the second line)",
          "taken where no option gives another; without: m, told, or that given by options"},
         {"step, time",
          "grains are of the last frame, or of the one that the contacts are of; told where this cannot be known"},
         {"cell (Lattice, Origin), pbc",
          "taken, without pbc as periodic; refused where pbc is not three of T and F (or true, 1, yes and their like), "
          "or "
          "it is tilted in another way "
          "than along x with y, or smaller between its walls than the centres span; one of no size is left aside, "
          "told"},
         {"number of grains", "compared with the rows that follow"},
         {"third coordinate", "read, as of tables"},
         {"Materials (\"1:POM 2:HDPE\")", "the names of numbered materials"},
         {"columns (Properties)", "pos, radius (radii) or diameter, id, material (type), zone; others are passed over"},
         {"forces", "none are in the file"}},
    .is_grains = is_count,
    .grains = read_xyz,
    .grain_moments = moments_xyz};

}  // namespace arenite::io
