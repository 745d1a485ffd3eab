#include "io/sample/sample.hpp"

#include <utility>

#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "io/disk/file.hpp"
#include "io/table/table.hpp"

namespace arenite::io {
namespace {

std::string_view first_line(std::string_view text) {
  Lines lines(text);
  std::string_view line;
  while (lines.next(line))
    if (!split_blanks(line).empty()) return line;
  return {};
}

bool all_numbers(std::string_view line, std::size_t count) {
  const auto cells = split_blanks(line);
  if (cells.size() != count) return false;
  for (const auto cell : cells)
    if (!to_number(cell)) return false;
  return true;
}

/// A family of files: how its grains are recognised, and how grains and contacts are read. Contacts of every format are also accepted as a table,
/// since many codes have no format of their own for them.
struct Format {
  const char* name;
  bool (*is_grains)(std::string_view first);
  bool (*is_contacts)(std::string_view first);
  RawGrains (*grains)(std::string_view, const SampleOptions&, Problems&);
  RawContacts (*contacts)(std::string_view, const RawGrains&, const SampleOptions&, Problems&);
};

bool is_lammps(std::string_view first) { return first.starts_with("ITEM:"); }
bool is_anything(std::string_view) { return true; }

constexpr Format formats[] = {
    {"lammps", is_lammps, is_lammps, read_lammps_atoms, read_lammps_pairs},
    {"yade", [](std::string_view l) { return l.starts_with("#format"); }, [](std::string_view l) { return l.starts_with("# vtk DataFile"); }, read_yade_spheres,
     read_yade_interactions},
    {"mercury", [](std::string_view l) { return all_numbers(l, 6); }, [](std::string_view l) { return l.starts_with('#') || all_numbers(l, 16); },
     read_mercury_data, read_mercury_fstat},
    {"csv", is_anything, is_anything, read_grains_csv, read_contacts_csv},
};
constexpr const Format& csv = formats[std::size(formats) - 1];

const Format& format_of(std::string_view grains, const SampleOptions& options) {
  for (const Format& format : formats)
    if (options.format == "auto" ? options.grain_columns.empty() && format.is_grains(first_line(grains)) : options.format == format.name) return format;
  return csv;
}

/// Image rows point down; from here on y points up.
void turn_rows_up(RawGrains& grains) {
  for (RawGrain& g : grains.rows) g.centre.y = -g.centre.y;
  std::swap(grains.box_low.y, grains.box_high.y);
  grains.box_low.y = -grains.box_low.y;
  grains.box_high.y = -grains.box_high.y;
  grains.tilt = -grains.tilt;
}
void turn_rows_up(RawContacts& contacts) {
  for (RawContact& c : contacts.rows) {
    if (c.normal) c.normal->y = -c.normal->y;
    if (c.force_on_j) c.force_on_j->y = -c.force_on_j->y;
  }
}

void apply_box(const SampleOptions& options, RawGrains& grains, Problems& problems) {
  grains.periodic[0] |= options.periodic[0];
  grains.periodic[1] |= options.periodic[1];
  if (options.box) {
    grains.has_box = true;
    grains.tilt = options.tilt;
    grains.box_low = options.origin.value_or(Vec2{});
    grains.box_high = grains.box_low + *options.box;
    if (!options.origin) place_box(grains, problems);
  }
  if (!grains.has_box && (grains.periodic[0] || grains.periodic[1])) problems.add("periodic sides need the size of the cell; give --box LX,LY[,tilt]");
}

/// The text of a file; one with zero bytes is no text in any encoding that is read here.
std::string read_text(const std::filesystem::path& path) {
  std::string text = read_file(path);
  if (text.find('\0') == std::string::npos) return text;
  refuse(path.string(), "is no text file; results (.h5) are for `arenite show`, or for `arenite export --to csv`, whose tables can be measured");
}

}  // namespace

std::vector<std::string> sample_formats() { return mapped<std::string>(formats, &Format::name); }

Sample read_sample(const std::filesystem::path& grains_path, const std::filesystem::path& contacts_path, const SampleOptions& options) {
  const std::string grains_text = read_text(grains_path), contacts_text = contacts_path.empty() ? std::string() : read_text(contacts_path);
  Problems grain_problems(grains_path.string()), contact_problems(contacts_path.string());

  const Format& format = format_of(grains_text, options);
  RawGrains grains = format.grains(grains_text, options, grain_problems);
  if (options.y_down) turn_rows_up(grains);
  if (!grain_problems.any()) apply_box(options, grains, grain_problems);
  const bool own = format.is_contacts(first_line(contacts_text)) || options.format == format.name;
  RawContacts contacts;
  if (!contacts_path.empty()) contacts = (own ? format : csv).contacts(contacts_text, grains, options, contact_problems);
  if (options.y_down) turn_rows_up(contacts);

  Sample sample;
  assemble(grains, contacts, options, sample, grain_problems, contact_problems);
  return sample;
}

}  // namespace arenite::io
