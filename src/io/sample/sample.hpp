#pragma once
#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
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
  int dimension = 0;           ///< 2, 3, or 0: by the centres
  std::vector<double> box;     ///< width, height, in space depth, and if it is sheared its tilt, m; empty: not given
  std::vector<double> origin;  ///< lowest corner, m; empty: the origin if all centres fit, else around them
  std::array<bool, 3> periodic{};
  std::optional<double> thickness;                 ///< m
  std::optional<std::filesystem::path> materials;  ///< table of material, name, density, stiffness, or of id, material
  bool y_down = false;         ///< y counts image rows, which point down: it is turned round, fn and ft kept
  bool merge_doubled = false;  ///< a contact listed twice is taken once, with the mean of its forces
  bool may_be_given = true;    ///< whoever asks can give these, so that sentences may name them

  double length() const { return length_unit.value_or(1); }
  double force() const { return force_unit.value_or(1); }
};

/// Every parameter: its name, unit, range and meaning, for commands and Python.
void declare(ParameterVisitor& visitor, SampleOptions& options);

/// Grains and contacts from anybody's files. In the plane thickness is 0 and the box of no area where they are not
/// known; in space an unknown box is the smallest that holds the spheres, without walls.
template <int D> struct SampleIn {
  PackingIn<D> packing;
  std::size_t doubled_rows = 0;  ///< rows merged into earlier ones
  std::vector<std::string> notes;
};
using Sample = SampleIn<2>;
using AnySample = std::variant<Sample, SampleIn<3>>;

/// Reads and checks both files; without a name of contacts there are none. What the files state (units, step or time,
/// cell, third coordinate, names of columns) is used, or refused, or told in a note: docs/formats.md. Centres in a
/// plane, or in a layer, are disks, others spheres, unless the options say it. Throws InputError with every problem
/// found, up to 20 a file.
AnySample read_any_sample(const std::filesystem::path& grains, const std::filesystem::path& contacts,
                          const SampleOptions& options);

/// The same of files that have been read, by the names that problems call them.
struct SampleText {
  std::string name, text;
};
AnySample sample_of(const SampleText& grains, const SampleText& contacts, const SampleOptions& options);

/// The same of disks; refuses spheres.
Sample read_sample(const std::filesystem::path& grains, const std::filesystem::path& contacts,
                   const SampleOptions& options);

/// The format other than a table that recognises a file of grains by its first line; null if none does.
const struct SampleFormat* known_sample_format(const std::filesystem::path& grains);

}  // namespace arenite::io
