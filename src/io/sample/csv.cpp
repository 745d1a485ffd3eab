#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/sample/column_units.hpp"
#include "io/sample/formats.hpp"
#include "io/sample/named_columns.hpp"
#include "io/sample/number_columns.hpp"
#include "io/sample/table_snapshots.hpp"

namespace arenite::io {
namespace {

constexpr std::string_view grain_names[] = {"id", "grain"}, pair_names[] = {"i", "id1", "j", "id2"};

std::vector<Moment> grain_moments_csv(std::string_view text, const std::string& columns) {
  return moments_of_rows(text, columns, grain_names);
}
std::vector<Moment> contact_moments_csv(std::string_view text, const std::string& columns) {
  return moments_of_rows(text, columns, pair_names);
}

/// The rows of the snapshot that is read; nothing where they cannot be used.
std::optional<Table> rows_of(const Reading& reading, const std::string& columns,
                             std::span<const std::string_view> names, SnapshotsOfRows& snapshots) {
  Table table = read_table(reading.text, columns, reading.problems);
  if (table.columns.empty()) return std::nullopt;
  take_units_of_comments(reading.text, reading.options, table);
  snapshots = SnapshotsOfRows(table, names);
  snapshots.keep(reading.snapshot, table);
  if (!knows_pixels(table, reading.options, reading.problems)) return std::nullopt;
  return table;
}

/// Says so where the snapshot that is taken has fewer grains than another: the file may be cut off within it.
void note_fewer(const std::vector<std::size_t>& sizes, std::size_t taken, std::vector<std::string>& notes) {
  if (taken >= sizes.size() || sizes[taken] == std::ranges::max(sizes)) return;
  notes.push_back(
      fmt::format("The snapshot that was taken has {} grains, and another of the file {}: if none left the sample, the "
                  "file is cut off.",
                  sizes[taken], std::ranges::max(sizes)));
}

RawGrains read_grains_csv(const Reading& reading) {
  const SampleOptions& options = reading.options;
  Problems& problems = reading.problems;
  SnapshotsOfRows snapshots;
  const auto rows = rows_of(reading, options.grain_columns, grain_names, snapshots);
  if (!rows) return {};
  const Table& table = *rows;
  StatedColumns units(table);
  units.see_vector({"x", "y", "z"}, options.length_unit.has_value(), problems);
  if (const auto size = table.find({"radius", "r", "diameter", "d"}))
    units.see({table.columns[*size].name}, options.length_unit.has_value());
  RawGrains grains = grains_in(table, "grains need id, x, y, radius and may have z, material, zone", options, problems);
  units.tell(grains.notes);
  if (!units.are_mixed())
    note_assumed_unit(options, table, "x", options.length_unit.has_value(), "length", "m", "length-unit", grains.notes);
  note_fewer(snapshots.sizes(), reading.snapshot, grains.notes);
  return grains;
}

RawContacts read_contacts_csv(const Reading& reading, const RawGrains& grains) {
  SnapshotsOfRows snapshots;
  const auto rows = rows_of(reading, reading.options.contact_columns, pair_names, snapshots);
  return rows ? contacts_in(*rows, reading, grains) : RawContacts{};
}

}  // namespace

/// Grains from a table with columns id, x, y, radius (or diameter) and perhaps z, material and zone; units in the
/// header win over those of the options. Contacts from one with columns i, j and fn, ft (or fx, fy: the force on j) and
/// perhaps nx, ny, overlap and the contact point x, y; j may name a wall, left, right, bottom or top, or with nx, ny a
/// boundary. Of spheres vectors have three components, and back and front are walls, too.
const SampleFormat samples::csv{
    .name = "csv",
    .grains_are = "table id,x,y,radius[,z,material,zone]",
    .contacts_are =
        "table i,j,fn,ft[,nx,ny,overlap,x,y] or i,j,fx,fy (force on j is fn n + ft t, n from i to j); of "
        "spheres i,j,fx,fy,fz",
    .states =
        {{"units (header, a row below it, or a comment above, \"# units: mm, N\")",
          "taken, those of a comment where no option gives others; columns without any: m and N, told, or those given "
          "by "
          "options"},
         {"units of some columns only", "told; refused of components of one vector"},
         {"names of columns behind # or %", "the header, where the first row has as many numbers"},
         {"step, timestep, frame, time (columns)",
          "rows of the last moment that grains and contacts have in common; refused where they have none, told where "
          "one file states a step and the other a time or nothing"},
         {"cell", "no column holds it; --box and --periodic give it"},
         {"z",
          "centres within 2 % of a radius are a plane, x-y, x-z or y-z (the last two are told); within a radius a "
          "layer, told; beyond: spheres"},
         {"names of columns", "those listed above; other columns are passed over"},
         {"contacts with walls",
          "refused where the box is periodic there, or the grain more than two radii from the wall; told where it is "
          "not near it"},
         {"nx, ny",
          "refused where most are turned from the line through the centres by more than 20 degrees, a few told"},
         {"walls in column i", "taken as in column j, with the normal and the force turned round"},
         {"fx, fy beside fn, ft", "fn, ft are taken; refused where the two contradict each other"},
         {"contacts without ft", "frictionless, told"},
         {"snapshots with fewer grains than others", "told"},
         {"materials of some grains only", "told"},
         {"rows without a force",
          "contacts where they overlap (column overlap, or the centres), else left out and told"},
         {"contact point (x, y of a contact)", "the lever arms end there; without it in the middle of the overlap"},
         {"sep=; of spreadsheets", "the separator"},
         {"decimal commas",
          "read where cells are in quotes or separated by other signs; refused where they may set thousands apart"},
         {"exponents with D", "read as E"},
         {"encoding", "UTF-8, UTF-16 with its mark, else Latin-1"}},
    .is_grains = [](std::string_view) { return true; },
    .is_contacts = [](std::string_view) { return true; },
    .grains = read_grains_csv,
    .contacts = read_contacts_csv,
    .grain_moments = grain_moments_csv,
    .contact_moments = contact_moments_csv};

}  // namespace arenite::io
