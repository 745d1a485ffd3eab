#include "io/sample/sample.hpp"

#include <utility>

#include "core/problems.hpp"
#include "io/disk/file.hpp"
#include "io/table/table.hpp"

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
  return *first_format(samples::all, [&](const SampleFormat& format) { return format.is_grains(first_line(grains)); });  // what is no other is a table
}

/// Image rows point down; from here on y points up.
void turn_rows_up(RawGrains& grains) {
  for (RawGrain& g : grains.rows) g.centre.y = -g.centre.y;
  auto& wall = grains.cell.wall;
  wall[bottom].position = -std::exchange(wall[top].position, -wall[bottom].position);
  grains.cell.tilt = -grains.cell.tilt;
}
void turn_rows_up(RawContacts& contacts) {
  for (RawContact& c : contacts.rows) {
    if (c.normal) c.normal->y = -c.normal->y;
    if (c.force_on_j) c.force_on_j->y = -c.force_on_j->y;
  }
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
  if (!grains.has_box && (periodic[0] || periodic[1])) problems.add("periodic sides need the size of the cell; give --box LX,LY[,tilt]");
}

/// The text of a file; one with zero bytes is no text in any encoding that is read here.
std::string read_text(const std::filesystem::path& path) {
  std::string text = read_file(path);
  if (text.find('\0') == std::string::npos) return text;
  refuse(path.string(), "is not a text file; results (.h5) are for `arenite show`, or for `arenite export --to csv`, whose tables can be measured");
}

}  // namespace

Sample read_sample(const std::filesystem::path& grains_path, const std::filesystem::path& contacts_path, const SampleOptions& options) {
  const std::string grains_text = read_text(grains_path), contacts_text = contacts_path.empty() ? std::string() : read_text(contacts_path);
  Problems grain_problems(grains_path.string()), contact_problems(contacts_path.string());

  const SampleFormat& format = format_of(grains_text, options);
  RawGrains grains = format.grains(grains_text, options, grain_problems);
  if (options.y_down) turn_rows_up(grains);
  if (!grain_problems.any()) apply_box(options, grains, grain_problems);
  const bool own = format.is_contacts(first_line(contacts_text)) || options.format == format.name;
  RawContacts contacts;
  if (!contacts_path.empty()) contacts = (own ? format : samples::csv).contacts(contacts_text, grains, options, contact_problems);
  if (options.y_down) turn_rows_up(contacts);

  Sample sample;
  assemble(grains, contacts, options, sample, grain_problems, contact_problems);
  return sample;
}

}  // namespace arenite::io
