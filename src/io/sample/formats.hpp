#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/problems.hpp"
#include "io/formats.hpp"
#include "io/sample/sample.hpp"
#include "io/table/table.hpp"

// What the formats of grains and contacts share: rows as their files give them, in space and in SI.
namespace arenite::io {

/// The two axes of space that span the plane of a sample.
struct Plane {
  int first = 0, second = 1;
  int across() const { return 3 - first - second; }
  Vec2 of(Vec3 v) const { return {v[first], v[second]}; }
};

/// A grain as its file gives it, in SI; `line` says where.
struct RawGrain {
  std::int64_t id = 0;
  Vec3 place;   ///< of its centre; z is 0 where the file has none
  Vec2 centre;  ///< the same in the plane of the sample
  double radius = 0;
  std::string material;   ///< as written; empty if the file has none
  std::int64_t zone = 0;  ///< 0: none; 1: glued
  int line = 0;
};

/// A contact as its file gives it, in SI. The force on grain j is fn n + ft t with n from i to j and t = n turned by
/// +90 degrees, or the vector `force_on_j`.
struct RawContact {
  std::int64_t i = 0, j = 0;
  int wall = -1;         ///< side (model/domain.hpp) instead of grain j; -1 for a grain
  std::string boundary;  ///< name of what is neither a grain nor a side; empty otherwise
  double fn = 0, ft = 0;
  std::optional<Vec3> force_on_j;  ///< instead of fn, ft
  std::optional<Vec3> normal;      ///< from i to j
  std::optional<Vec3> point;       ///< where they touch
  std::optional<double> overlap;
  int line = 0;

  bool is_of_grains() const { return wall < 0 && boundary.empty(); }
};

/// When a snapshot was taken, as far as its file says.
struct Moment {
  std::optional<std::int64_t> step;
  std::optional<double> time;
  bool operator==(const Moment&) const = default;
};

/// A cell as a file states it: a parallelepiped with a corner and three edges, m.
struct RawCell {
  Vec3 corner;
  std::array<Vec3, 3> edge;
  std::array<bool, 3> periodic{};
};

/// Units that a file names for all that it holds: factors to SI.
struct StatedUnits {
  std::string_view name;
  double length = 1, force = 1;
};

struct RawGrains {
  std::vector<RawGrain> rows;
  std::optional<RawCell> stated;  ///< by the file
  std::optional<StatedUnits> units;
  Plane plane;
  bool has_box = false;
  Domain cell;  ///< its walls' places, periodic sides and tilt, in the plane
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

/// What to read of a file: the snapshot of this number, in the order of the file.
struct Reading {
  std::string_view text;
  std::size_t snapshot = 0;
  const SampleOptions& options;
  Problems& problems;
};

/// A program's files: what they are, how they are recognised by their first line that is not empty, and read; what is
/// wrong goes to the problems. Contacts of every format are also accepted as a table, since many codes have no format
/// of their own for them. `moments` gives those of all snapshots of a file that states any, `columns` being the names
/// for one without header.
struct SampleFormat {
  using Moments = std::vector<Moment> (*)(std::string_view text, const std::string& columns);
  std::string_view name, grains_are, contacts_are;
  Statements states = {};
  bool (*is_grains)(std::string_view first_line);
  bool (*is_contacts)(std::string_view first_line);
  RawGrains (*grains)(const Reading& reading);
  RawContacts (*contacts)(const Reading& reading, const RawGrains& grains);
  Moments grain_moments = nullptr, contact_moments = nullptr;
};
namespace samples {
ARENITE_FAMILY(SampleFormat, ARENITE_SAMPLE_FORMATS)
}

/// The note that a unit was assumed: of "length" m, unless --length-unit or the header of a column says otherwise.
std::string assumed_unit(const char* what, const char* si, const char* option, const char* column = "");

/// The rows of a table with columns x, y, radius (or diameter) and perhaps z, id, material and zone; without ids grains
/// are numbered from 0. `needed` goes on in the problem of a column that lacks. A column's own unit wins over that of
/// the options.
RawGrains grains_in(const Table& table, const char* needed, const SampleOptions& options, Problems& problems);

}  // namespace arenite::io
