#pragma once
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/problems.hpp"
#include "io/formats.hpp"
#include "io/table/table.hpp"
#include "model/packing.hpp"

namespace arenite::io {

/// What the files of a sample do not say themselves. SI.
struct SampleOptions {
  std::string format = "auto";                    ///< name of a format (samples::all), or "auto": by content
  std::string grain_columns, contact_columns;     ///< for files without header: "id,x,y,-,radius"
  std::optional<double> length_unit, force_unit;  ///< factors to SI of columns without unit; else SI is taken, with a note
  double pixel = 0;                               ///< m, width of a pixel on the sample, for tables in pixels; 0: not known
  std::optional<Vec2> box;                        ///< width, height, m
  std::optional<Vec2> origin;                     ///< lower left corner, m; default: the origin if all centres fit, else around them
  double tilt = 0;                                ///< m
  std::array<bool, 2> periodic{};
  std::optional<double> thickness;                 ///< m
  std::optional<std::filesystem::path> materials;  ///< table of material, name, density, stiffness, or of id, material
  bool y_down = false;                             ///< y counts image rows, which point down: it is turned round, fn and ft kept
  bool merge_doubled = false;                      ///< a contact listed twice is taken once, with the mean of its forces

  double length() const { return length_unit.value_or(1); }
  double force() const { return force_unit.value_or(1); }
};

/// Grains and contacts from anybody's files.
struct Sample {
  Packing packing;               ///< thickness 0 and box of no area where they are not known
  std::size_t doubled_rows = 0;  ///< rows merged into earlier ones
  std::vector<std::string> notes;
};

/// Reads and checks both files; without a name of contacts there are none. Throws InputError with every problem found, up to 20 a file.
Sample read_sample(const std::filesystem::path& grains, const std::filesystem::path& contacts, const SampleOptions& options);

/// Grains to start a simulation from, as a laboratory gives them: a table with columns id, x, y, radius (or diameter) and material; lengths in m
/// unless the header names a unit. Centres count from the container's lower left corner. Throws InputError with every problem found: unknown material, a
/// grain outside the container, an id that occurs twice.
Grains read_placed_grains(const std::filesystem::path& path, const Materials& materials, const Domain& domain);

/// A grain as its file gives it, in SI; `line` says where.
struct RawGrain {
  std::int64_t id = 0;
  Vec2 centre;
  double radius = 0;
  std::string material;   ///< as written; empty if the file has none
  std::int64_t zone = 0;  ///< 0: none; 1: glued
  int line = 0;
};

/// A contact as its file gives it, in SI. The force on grain j is fn n + ft t with n from i to j and t = n turned by +90 degrees, or the vector
/// `force_on_j`.
struct RawContact {
  std::int64_t i = 0, j = 0;
  int wall = -1;  ///< side (model/packing.hpp) instead of grain j; -1 for a grain
  double fn = 0, ft = 0;
  std::optional<Vec2> force_on_j;  ///< instead of fn, ft
  std::optional<Vec2> normal;      ///< from i to j
  int line = 0;
};

struct RawGrains {
  std::vector<RawGrain> rows;
  bool has_box = false;
  Domain cell;  ///< its walls' places, periodic sides and tilt
  std::vector<std::string> notes;

  void lay_box(Vec2 low, Vec2 high) {
    has_box = true;
    cell.wall[left].position = low.x;
    cell.wall[right].position = high.x;
    cell.wall[bottom].position = low.y;
    cell.wall[top].position = high.y;
  }
};

struct RawContacts {
  std::vector<RawContact> rows;
  bool lists_both_ways = false;  ///< the format itself lists every contact once for each grain
  std::vector<std::string> notes;
};

/// The side that a direction points to: the wall of a contact whose file names none.
inline int side_towards(Vec2 d) {
  if (std::abs(d.x) > std::abs(d.y)) return d.x < 0 ? left : right;
  return d.y < 0 ? bottom : top;
}

/// Puts the corner of a box whose place nobody gave: at the origin if all centres lie in it so, else around the grains. A box smaller than the
/// grains' extent is a problem unless it is periodic.
void place_box(RawGrains& grains, Problems& problems);

/// Checks rows against each other and makes a packing of them: numbers of grains become indices, the file's forces on j become the model's forces on
/// i, arms halve the overlap. Throws InputError with the problems of both files.
void assemble(const RawGrains& grains, const RawContacts& contacts, const SampleOptions& options, Sample& sample, Problems& grain_problems,
              Problems& contact_problems);

/// Gives the packing its materials, in the order in which grains name them first, and every grain its material. `file` is a table with a column
/// material (as the grains write it) and any of name, density, stiffness, thermoelastic_factor; its order then is the materials' order. Or it has
/// columns id and material, for grains whose file has no material.
void assign_materials(const RawGrains& raw, const std::optional<std::filesystem::path>& file, Packing& packing, Problems& problems);

/// A program's files: what they are, how they are recognised by their first line that is not empty, and read; what is wrong goes to the problems.
/// Contacts of every format are also accepted as a table, since many codes have no format of their own for them.
struct SampleFormat {
  std::string_view name, grains_are, contacts_are;
  Statements states = {};
  bool (*is_grains)(std::string_view first_line);
  bool (*is_contacts)(std::string_view first_line);
  RawGrains (*grains)(std::string_view text, const SampleOptions& options, Problems& problems);
  RawContacts (*contacts)(std::string_view text, const RawGrains& grains, const SampleOptions& options, Problems& problems);
};
namespace samples {
ARENITE_FAMILY(SampleFormat, ARENITE_SAMPLE_FORMATS)
}

/// The rows of a table with columns x, y, radius (or diameter) and perhaps id, material and zone; without ids grains are numbered from 0. `needed` goes
/// on in the problem of a column that lacks. A column's own unit wins over that of the options.
RawGrains grains_in(const Table& table, const char* needed, const SampleOptions& options, Problems& problems);

/// Which columns are the two grains, fx, fy, p1 and p2 of a file of contacts, from what they hold, where their names do not say: the two grains are neighbouring columns of whole numbers that are
/// grains; the normal force is the first pair of neighbouring columns along the line between their centres that is not the line itself, the tangential force the first behind it
/// that is across (one place further than fy where a force along z follows). `candidates`: the columns that may be meant, in their order; rows with
/// another number of cells are passed over. Nothing where the numbers do not tell.
std::vector<std::size_t> find_pair_columns(const std::vector<std::vector<std::string_view>>& rows, const std::vector<std::size_t>& candidates,
                                           const RawGrains& grains);

}  // namespace arenite::io
