#include "io/sample/sample.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "core/error.hpp"
#include "core/text.hpp"
#include "io/sample/assemble.hpp"
#include "io/sample/formats.hpp"
#include "io/sample/plane.hpp"
#include "io/sample/snapshots.hpp"
#include "io/table/table.hpp"
#include "io/table/text_file.hpp"

namespace arenite::io {
namespace {

std::string_view first_line(std::string_view text) {
  Lines lines(text);
  for (std::string_view line; lines.next(line);)
    if (!split_blanks(line).empty()) return line;
  return {};
}

const SampleFormat& format_of(std::string_view grains, const SampleOptions& options) {
  if (const SampleFormat* named = format_named(samples::all, options.format)) return *named;
  if (!options.grain_columns.empty()) return samples::csv;
  const std::string_view line = first_line(grains);
  return *first_format(samples::all,
                       [&](const SampleFormat& format) { return format.is_grains(line); });  // else a table
}

/// That of the grains, or a table, or another program's: by content, unless the user names format or columns.
const SampleFormat& format_of_contacts(std::string_view contacts, const SampleFormat& of_grains,
                                       const SampleOptions& options) {
  const std::string_view line = first_line(contacts);
  const bool own = &of_grains != &samples::csv && of_grains.is_contacts(line);  // everything may be a table
  if (own || options.format == of_grains.name) return of_grains;
  if (!options.contact_columns.empty()) return samples::csv;
  return *first_format(samples::all, [&](const SampleFormat& format) { return format.is_contacts(line); });
}

std::vector<Moment> moments_in(SampleFormat::Moments moments, std::string_view text, const std::string& columns) {
  return moments != nullptr && !text.empty() ? moments(text, columns) : std::vector<Moment>();
}

/// Image rows point down; from here on y points up.
void turn_rows_up(RawGrains& grains) {
  for (RawGrain& g : grains.rows) g.centre.y = -g.centre.y;
  auto& wall = grains.cell.wall;
  wall[bottom].position = -std::exchange(wall[top].position, -wall[bottom].position);
  grains.cell.tilt = -grains.cell.tilt;
}
void turn_rows_up(RawContacts& contacts, int down) {
  for (RawContact& c : contacts.rows)
    for (auto* vector : {&c.normal, &c.force_on_j, &c.point})
      if (*vector) (**vector)[down] = -(**vector)[down];
}

void apply_box(const SampleOptions& options, RawGrains& grains, Problems& problems) {
  auto& periodic = grains.cell.periodic;
  for (int axis = 0; axis < 2; ++axis) periodic[axis] |= options.periodic[axis];
  if (options.box) {
    const Vec2 corner = options.origin.value_or(Vec2{});
    grains.lay_box(corner, corner + *options.box);
    grains.cell.tilt = options.tilt;
    if (!options.origin) place_box(grains, problems);
  }
  if (!grains.has_box && (periodic[0] || periodic[1]))
    problems.add("periodic sides need the size of the cell; give --box LX,LY[,tilt]");
}

}  // namespace

Sample read_sample(const std::filesystem::path& grains_path, const std::filesystem::path& contacts_path,
                   const SampleOptions& options) {
  const std::string grains_text = read_text(grains_path);
  const std::string contacts_text = contacts_path.empty() ? std::string() : read_text(contacts_path);
  Problems grain_problems(grains_path.string()), contact_problems(contacts_path.string());
  const SampleFormat& format = format_of(grains_text, options);
  const SampleFormat& of_contacts = format_of_contacts(contacts_text, format, options);

  Sample sample;
  const auto moments = moments_in(format.grain_moments, grains_text, options.grain_columns);
  const auto taken =
      common_snapshot(moments, moments_in(of_contacts.contact_moments, contacts_text, options.contact_columns),
                      sample.notes, contact_problems);
  RawGrains grains = format.grains({grains_text, taken.grains, options, grain_problems});
  if (!grain_problems.any()) lay_in_plane(grains, grain_problems);
  if (options.y_down) turn_rows_up(grains);
  if (!grain_problems.any()) apply_box(options, grains, grain_problems);

  RawContacts contacts;
  const bool readable = !grain_problems.any() || &of_contacts == &samples::csv;  // the others look at the grains
  if (!contacts_path.empty() && readable && !contact_problems.any())
    contacts = of_contacts.contacts({contacts_text, taken.contacts, options, contact_problems}, grains);
  if (options.y_down) turn_rows_up(contacts, grains.plane.second);
  assemble(grains, contacts, options, sample, grain_problems, contact_problems);
  return sample;
}

namespace {

using Visitor = ParameterVisitor;

void declare_format(Visitor& v, SampleOptions& options) {
  std::vector<Word> words{{"auto", "by their first line"}};
  for (const SampleFormat* format : samples::all) words.push_back({format->name, {}});
  const auto at = std::ranges::find(words, options.format, &Word::word);
  auto index = static_cast<int>(at == words.end() ? 0 : at - words.begin());
  v.choice({"format", "Format of the files."}, index, words);
  options.format = words[static_cast<std::size_t>(index)].word;
}

void declare_unit(Visitor& v, const Key& key, std::optional<double>& factor, Dimension dimension) {
  std::string text, problem;
  v.text(key, text);
  try {
    if (!text.empty()) factor = unit_factor(text, dimension);
  } catch (const InputError& error) { problem = error.problems().front().message; }
  v.require(problem.empty(), {key.name}, problem);
}

/// A list of lengths, or none.
std::vector<double> lengths(Visitor& v, const Key& key, std::vector<double> values, std::size_t most) {
  v.numbers(key, values, "mm", range::any);
  const bool right = values.empty() || (values.size() >= 2 && values.size() <= most);
  v.require(right, {key.name},
            most == 2 ? "must be two lengths, for example 350 mm and 350 mm"
                      : "must be two or three lengths, for example 350 mm and 350 mm");
  return right ? values : std::vector<double>{};
}

void declare_frame(Visitor& v, SampleOptions& options) {
  std::vector<double> box, origin;
  if (options.box) box = {options.box->x, options.box->y, options.tilt};
  if (options.origin) origin = {options.origin->x, options.origin->y};
  box = lengths(v, {"box", "Width and height of the sample, and tilt of a sheared periodic cell."}, box, 3);
  v.require(box.empty() || (box[0] > 0 && box[1] > 0), {"box"}, "width and height must be positive");
  if (!box.empty()) options.box = {box[0], box[1]};
  if (box.size() == 3) options.tilt = box[2];
  origin = lengths(
      v, {"origin", "Lower left corner of the box; unless given 0, or around the centres if they lie elsewhere."},
      origin, 2);
  if (!origin.empty()) options.origin = {origin[0], origin[1]};
  constexpr const char* words[] = {"", "x", "y", "xy"};
  std::string periodic = words[(options.periodic[0] ? 1 : 0) + (options.periodic[1] ? 2 : 0)];
  v.text({"periodic", "Periodic directions: x, y or xy."}, periodic);
  v.require(std::ranges::count(words, periodic) > 0, {"periodic"}, "must be x, y or xy");
  options.periodic = {periodic.find('x') != std::string::npos, periodic.find('y') != std::string::npos};
}

}  // namespace

void declare(Visitor& v, SampleOptions& options) {
  declare_format(v, options);
  v.text({"grain_columns", "Columns of a grain table without header, e.g. \"id,x,y,-,radius\"."},
         options.grain_columns);
  v.text(
      {"contact_columns",
       "Columns of a contact table without header, e.g. \"i,j,-,ft [N],fn [N]\" or \"i,j,fx,fy\"; or of a LAMMPS dump "
       "with computes other than those in docs/measure.md, e.g. \"-,patom1,patom2,fx,fy,p1,p2\"."},
      options.contact_columns);
  declare_unit(v, {"length_unit", "Unit of lengths in columns without a unit, e.g. mm; m unless given."},
               options.length_unit, dimension::length);
  declare_unit(v, {"force_unit", "Unit of forces in columns without a unit, e.g. kN; N unless given."},
               options.force_unit, dimension::force);
  v.number_above_0({"pixel", "Side of a pixel on the sample, for a table in pixels."}, options.pixel, "mm");
  declare_frame(v, options);
  v.number({"thickness", "Length of the cylinders, out of the plane; stresses need it."}, options.thickness, "mm",
           range::positive);
  std::string materials = options.materials ? options.materials->string() : "";
  v.text(
      {"materials", "Table of materials (material,name,density,...) or of the material of each grain (id,material)."},
      materials);
  if (!materials.empty()) options.materials = materials;
  v.flag({"y_down", "y counts image rows, which point down; y is flipped, fn and ft are kept."}, options.y_down);
  v.flag(
      {"merge_doubled", "A contact listed twice is taken once, with the mean of its forces; otherwise it is an error."},
      options.merge_doubled);
}

}  // namespace arenite::io
