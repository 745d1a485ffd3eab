#include "io/sample/sample.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <fstream>
#include <span>
#include <string_view>
#include <utility>

#include "core/error.hpp"
#include "core/option.hpp"
#include "core/text.hpp"
#include "io/disk/file.hpp"
#include "io/sample/assemble.hpp"
#include "io/sample/formats.hpp"
#include "io/sample/lammps_dump.hpp"
#include "io/sample/layout.hpp"
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
  if (of_grains.contacts && (own || options.format == of_grains.name)) return of_grains;
  if (!options.contact_columns.empty()) return samples::csv;
  return *first_format(samples::all,
                       [&](const SampleFormat& format) { return format.contacts && format.is_contacts(line); });
}

std::vector<Moment> moments_in(SampleFormat::Moments moments, std::string_view text, const std::string& columns) {
  return moments != nullptr && !text.empty() ? moments(text, columns) : std::vector<Moment>();
}

/// Units that only the contacts state are those of the grains, too, if theirs is a format that could state them.
SampleOptions with_units_of_contacts(const SampleFormat& of_grains, std::string_view grains,
                                     const SampleFormat& of_contacts, std::string_view contacts, SampleOptions options,
                                     std::vector<std::string>& notes) {
  if (!of_grains.units_named || !of_contacts.units_named || options.length_unit) return options;
  if (!of_grains.units_named(grains).empty()) return options;
  Problems told_by_the_contacts;
  const auto there = unit_system(of_contacts.units_named(contacts), options, told_by_the_contacts);
  if (!there) return options;
  options.length_unit = there->length;
  notes.push_back(
      fmt::format("The file of grains states no units; those of the contacts, {}, are taken.", there->name));
  return options;
}

/// Image rows point down; from here on y points up.
template <int D> void turn_rows_up(std::vector<RawGrain>& rows, Laid<D>& laid) {
  for (RawGrain& g : rows) g.place[laid.frame.axis[1]] = -g.place[laid.frame.axis[1]];
  auto& wall = laid.cell.wall;
  wall[bottom].position = -std::exchange(wall[top].position, -wall[bottom].position);
  laid.cell.tilt = -laid.cell.tilt;
}
void turn_rows_up(RawContacts& contacts, int down) {
  for (RawContact& c : contacts.rows)
    for (auto* vector : {&c.normal, &c.force_on_j, &c.point})
      if (*vector) (**vector)[down] = -(**vector)[down];
}

template <int D> constexpr const char* wanted_box = "the grains lie in a plane; give {} LX,LY[,tilt]";
template <> constexpr const char* wanted_box<3> = "the spheres fill space; give {} LX,LY,LZ[,tilt]";

template <int D> void apply_box(const SampleOptions& options, Laid<D>& laid, RawGrains& grains, Problems& problems) {
  const auto axes = static_cast<std::size_t>(D);
  auto& periodic = laid.cell.periodic;
  for (int axis = 0; axis < D; ++axis) periodic[axis] |= options.periodic[axis];
  if (!options.box.empty()) {
    const bool has_corner = !options.origin.empty();
    if (options.box.size() < axes || options.box.size() > axes + 1) return problems.add(wanted_box<D>, option("box"));
    if (has_corner && options.origin.size() != axes)
      return problems.add("{} has {} lengths; give one along each of the {} axes", option("origin"),
                          options.origin.size(), axes);
    const Vec<D> corner = by_axis<D>([&](int axis) { return has_corner ? options.origin[axis] : 0.0; });
    laid.lay_box(corner, corner + by_axis<D>([&](int axis) { return options.box[axis]; }));
    laid.cell.tilt = options.box.size() > axes ? options.box[axes] : 0;
    if (!has_corner) place_box(grains, problems);
  } else if (laid.has_box) {
    check_stated_box(grains, problems);
  }
  if (!laid.has_box && std::ranges::count(periodic, true) > 0)
    problems.add("periodic sides need the size of the cell; give {} LX,LY[,tilt], in space LX,LY,LZ", option("box"));
}

}  // namespace

AnySample sample_of(const SampleText& grains_file, const SampleText& contacts_file, const SampleOptions& options) {
  const std::string_view grains_text = grains_file.text, contacts_text = contacts_file.text;
  Problems grain_problems(grains_file.name), contact_problems(contacts_file.name);
  const SampleFormat& format = format_of(grains_text, options);
  const SampleFormat& of_contacts = format_of_contacts(contacts_text, format, options);

  std::vector<std::string> notes;
  const auto moments = moments_in(format.grain_moments, grains_text, options.grain_columns);
  const auto taken =
      common_snapshot(moments, moments_in(of_contacts.contact_moments, contacts_text, options.contact_columns),
                      !contacts_file.name.empty(), notes, contact_problems);
  const SampleOptions for_grains =
      with_units_of_contacts(format, grains_text, of_contacts, contacts_text, options, notes);
  RawGrains grains = format.grains({grains_text, taken.grains, for_grains, grain_problems});
  if (!grain_problems.any()) lay_out(grains, options.dimension, grain_problems);
  grains.laid([&](auto& laid) {
    if (options.y_down) turn_rows_up(grains.rows, laid);
    if (!grain_problems.any()) apply_box(options, laid, grains, grain_problems);
  });

  RawContacts contacts;
  const bool readable = !grain_problems.any() || &of_contacts == &samples::csv;  // the others look at the grains
  if (!contacts_file.name.empty() && readable && !contact_problems.any())
    contacts = of_contacts.contacts({contacts_text, taken.contacts, options, contact_problems}, grains);
  if (options.y_down) turn_rows_up(contacts, grains.axes()[1]);
  return grains.laid([&]<int D>(const Laid<D>& laid) -> AnySample {
    SampleIn<D> sample;
    sample.notes = notes;
    assemble(grains, laid, contacts, options, sample, grain_problems, contact_problems);
    return sample;
  });
}

AnySample read_any_sample(const std::filesystem::path& grains, const std::filesystem::path& contacts,
                          const SampleOptions& options) {
  const bool is_binary = known_sample_format(grains) == &samples::vtk;
  return sample_of({grains.string(), is_binary ? read_file(grains) : read_text(grains)},
                   {contacts.string(), contacts.empty() ? std::string() : read_text(contacts)}, options);
}

Sample read_sample(const std::filesystem::path& grains, const std::filesystem::path& contacts,
                   const SampleOptions& options) {
  SampleOptions in_plane = options;
  in_plane.dimension = 2;
  return std::get<Sample>(read_any_sample(grains, contacts, in_plane));
}

const SampleFormat* known_sample_format(const std::filesystem::path& grains) {
  std::ifstream file(grains, std::ios::binary);
  std::string head(4096, '\0');
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(file.gcount()));
  if (head.empty()) return nullptr;
  const std::string_view line = first_line(head);
  return first_format(samples::all,
                      [&](const SampleFormat& format) { return &format != &samples::csv && format.is_grains(line); });
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
void declare_lengths(Visitor& v, const Key& key, std::vector<double>& values, std::size_t most) {
  v.numbers(key, values, "mm", range::any);
  const bool right = values.empty() || (values.size() >= 2 && values.size() <= most);
  v.require(right, {key.name},
            most == 3 ? "must be two lengths, in space three, for example 350 mm and 350 mm"
                      : "must be two to four lengths, for example 350 mm and 350 mm");
  if (!right) values.clear();
}

void declare_frame(Visitor& v, SampleOptions& options) {
  declare_lengths(
      v,
      {"box", "Width and height of the sample, of spheres depth, and behind them the tilt of a sheared periodic cell."},
      options.box, 4);
  const auto sizes = std::span(options.box).first(std::min<std::size_t>(options.box.size(), 2));
  v.require(std::ranges::all_of(sizes, [](double size) { return size > 0; }), {"box"},
            "width and height must be positive");
  declare_lengths(v,
                  {"origin", "Lowest corner of the box; unless given 0, or around the centres if they lie elsewhere."},
                  options.origin, 3);
  std::string periodic;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (options.periodic[axis]) periodic += "xyz"[axis];
  v.text({"periodic", "Periodic directions: x, y, z, two of them or all."}, periodic);
  if (periodic == "all") periodic = "xyz";
  const bool right = periodic.find_first_not_of("xyz") == periodic.npos && std::ranges::is_sorted(periodic) &&
                     std::ranges::adjacent_find(periodic) == periodic.end();
  v.require(right, {"periodic"}, "must be x, y, z, two of them (xy, xz, yz) or all");
  for (std::size_t axis = 0; axis < 3; ++axis) options.periodic[axis] = periodic.find("xyz"[axis]) != periodic.npos;
}

void declare_dimension(Visitor& v, SampleOptions& options) {
  int index = std::max(options.dimension - 1, 0);
  v.choice({"dimension", "Whether grains are disks in a plane or spheres in space."}, index,
           {{"auto", "as the centres lie"}, {"2", "disks"}, {"3", "spheres"}});
  options.dimension = index > 0 ? index + 1 : 0;
}

}  // namespace

void declare(Visitor& v, SampleOptions& options) {
  declare_format(v, options);
  declare_dimension(v, options);
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
