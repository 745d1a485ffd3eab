#pragma once
#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/parameters.hpp"
#include "model/packing.hpp"

namespace arenite::io {

/// What the files of a sample do not say themselves. SI.
struct SampleOptions {
  std::string format = "auto";                    ///< name of a format (samples::all), or "auto": by content
  std::string grain_columns, contact_columns;     ///< for files without header: "id,x,y,-,radius"
  std::optional<double> length_unit, force_unit;  ///< factors to SI of what has no unit; else SI is taken, with a note
  double pixel = 0;            ///< m, width of a pixel on the sample, for tables in pixels; 0: not known
  std::optional<Vec2> box;     ///< width, height, m
  std::optional<Vec2> origin;  ///< lower left corner, m; default: the origin if all centres fit, else around them
  double tilt = 0;             ///< m
  std::array<bool, 2> periodic{};
  std::optional<double> thickness;                 ///< m
  std::optional<std::filesystem::path> materials;  ///< table of material, name, density, stiffness, or of id, material
  bool y_down = false;         ///< y counts image rows, which point down: it is turned round, fn and ft kept
  bool merge_doubled = false;  ///< a contact listed twice is taken once, with the mean of its forces

  double length() const { return length_unit.value_or(1); }
  double force() const { return force_unit.value_or(1); }
};

/// Every parameter: its name, unit, range and meaning, for commands and Python.
void declare(ParameterVisitor& visitor, SampleOptions& options);

/// Grains and contacts from anybody's files.
struct Sample {
  Packing packing;               ///< thickness 0 and box of no area where they are not known
  std::size_t doubled_rows = 0;  ///< rows merged into earlier ones
  std::vector<std::string> notes;
};

/// Reads and checks both files; without a name of contacts there are none. What the files state (units, step or time,
/// cell, third coordinate, names of columns) is used, or refused, or told in a note: docs/formats.md. Throws InputError
/// with every problem found, up to 20 a file.
Sample read_sample(const std::filesystem::path& grains, const std::filesystem::path& contacts,
                   const SampleOptions& options);

}  // namespace arenite::io
