#include "io/sample/sample.hpp"

#include <fmt/core.h>

#include <utility>

#include "core/text.hpp"
#include "io/sample/assemble.hpp"
#include "io/sample/formats.hpp"
#include "io/sample/plane.hpp"
#include "io/sample/snapshots.hpp"
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

}  // namespace arenite::io
