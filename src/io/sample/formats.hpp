#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <numeric>
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

/// The axes of space along which a sample lies: two of a plane, or all three.
template <int D> struct Frame {
  std::array<int, D> axis = [] {
    std::array<int, D> all{};
    std::iota(all.begin(), all.end(), 0);
    return all;
  }();
  Vec<D> of(Vec3 v) const {
    return by_axis<D>([&](int k) { return v[axis[k]]; });
  }
  Vec3 in_space(Vec<D> v) const {
    Vec3 all;
    for (int k = 0; k < D; ++k) all[axis[k]] = v[k];
    return all;
  }
};

/// A grain as its file gives it, in SI; `line` says where.
struct RawGrain {
  std::int64_t id = 0;
  Vec3 place;  ///< of its centre; z is 0 where the file has none
  double radius = 0;
  std::string material;   ///< as written; empty if the file has none
  std::int64_t zone = 0;  ///< 0: none; 1: glued
  int line = 0;
};

/// A contact as its file gives it, in SI. The force on grain j is fn n + ft t with n from i to j and t = n turned by
/// +90 degrees, or the vector `force_on_j`. In space ft has no direction and is 0.
struct RawContact {
  std::int64_t i = 0, j = 0;
  int wall = -1;            ///< side (model/domain.hpp) instead of grain j; -1 for a grain
  bool is_towards = false;  ///< the file names no side: it is the one that the contact lies towards
  std::string boundary;     ///< name of what is neither a grain nor a side; empty otherwise
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

/// How the centres of a file lie in a plane or in space, and what holds them.
template <int D> struct Laid {
  Frame<D> frame;
  bool has_box = false;
  DomainIn<D> cell;  ///< its walls' places, periodic sides and tilt

  void lay_box(Vec<D> low, Vec<D> high) {
    has_box = true;
    for (int axis = 0; axis < D; ++axis) {
      cell.wall[2 * axis].position = low[axis];
      cell.wall[2 * axis + 1].position = high[axis];
    }
  }
};

/// Names of materials by what stands for them in the rows of a file.
using MaterialNames = std::map<std::string, std::string, std::less<>>;

struct RawGrains {
  std::vector<RawGrain> rows;
  MaterialNames material_name;    ///< that the file gives a number, by the number
  std::optional<RawCell> stated;  ///< by the file
  std::optional<StatedUnits> units;
  bool in_space = false;  ///< which of the two holds (lay_out)
  Laid<2> plane;
  Laid<3> space;
  std::vector<std::string> notes;

  /// Calls `see` for the one that holds.
  template <class See> decltype(auto) laid(const See& see) const { return in_space ? see(space) : see(plane); }
  template <class See> decltype(auto) laid(const See& see) { return in_space ? see(space) : see(plane); }
  /// The axes of space along which the sample lies.
  std::vector<int> axes() const {
    return laid([](const auto& in) { return std::vector<int>(in.frame.axis.begin(), in.frame.axis.end()); });
  }
};

struct RawContacts {
  std::vector<RawContact> rows;
  bool lists_both_ways = false;  ///< the format itself lists every contact once for each grain
  std::vector<std::string> notes;
};

/// The side that a direction points to: the wall of a contact whose file names none.
template <int D> int side_towards(Vec<D> d) {
  int axis = D - 1;
  for (int k = D - 2; k >= 0; --k)
    if (std::abs(d[k]) > std::abs(d[axis])) axis = k;
  return 2 * axis + (d[axis] < 0 ? 0 : 1);
}

/// What to read of a file: the snapshot of this number, in the order of the file.
struct Reading {
  std::string_view text;
  std::size_t snapshot = 0;
  const SampleOptions& options;
  Problems& problems;
};

/// A program's files, or with null for contacts those of one that has none: what they are, how they are recognised by
/// their first line that is not empty, and read; what is wrong goes to the problems. Contacts of every format are also
/// accepted as a table, since many codes have no format of their own for them. `moments` gives those of all snapshots
/// of a file that states any, `columns` being the names for one without header; `units_named` the name of the units
/// that a file states, or nothing.
struct SampleFormat {
  using Moments = std::vector<Moment> (*)(std::string_view text, const std::string& columns);
  std::string_view name, grains_are, contacts_are;
  Statements states = {};
  bool (*is_grains)(std::string_view first_line);
  bool (*is_contacts)(std::string_view first_line) = [](std::string_view) { return false; };
  RawGrains (*grains)(const Reading& reading);
  RawContacts (*contacts)(const Reading& reading, const RawGrains& grains) = nullptr;
  Moments grain_moments = nullptr, contact_moments = nullptr;
  std::string_view (*units_named)(std::string_view text) = nullptr;
};
namespace samples {
ARENITE_FAMILY(SampleFormat, ARENITE_SAMPLE_FORMATS)
}

/// Whether a file that states both means one size.
inline bool is_radius_of(double radius, double diameter) {
  return std::abs(diameter - 2 * radius) <= 1e-3 * std::abs(diameter);
}

}  // namespace arenite::io
