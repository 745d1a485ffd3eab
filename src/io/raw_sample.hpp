#pragma once
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/vec2.hpp"
#include "model/domain.hpp"

namespace arenite::io {

/// Units of columns that name none, as factors to SI; whether anybody chose them.
struct UnitFactors {
  double length = 1, force = 1;
  bool length_chosen = false, force_chosen = false;
  double pixel = 0;                    ///< m, of columns in "px"; 0: not known
};

/// A grain as its file gives it, in SI; `line` says where.
struct RawGrain {
  std::int64_t id = 0;
  Vec2 centre;
  double radius = 0;
  std::string material;                ///< as written; empty if the file has none
  std::int64_t zone = 0;               ///< 0: none; 1: glued
  int line = 0;
};

/// A contact as its file gives it, in SI. The force on grain j is fn n + ft t with n from i to j and t = n turned by
/// +90 degrees, or the vector `force_on_j`.
struct RawContact {
  std::int64_t i = 0, j = 0;
  int wall = -1;                       ///< side (model/domain.hpp) instead of grain j; -1 for a grain
  double fn = 0, ft = 0;
  std::optional<Vec2> force_on_j;      ///< instead of fn, ft
  std::optional<Vec2> normal;          ///< from i to j
  int line = 0;
};

struct RawGrains {
  std::vector<RawGrain> rows;
  bool has_box = false;
  Vec2 box_low, box_high;              ///< m
  bool periodic_x = false, periodic_y = false;
  double tilt = 0;
  std::vector<std::string> notes;
};

struct RawContacts {
  std::vector<RawContact> rows;
  bool lists_both_ways = false;        ///< the format itself lists every contact once for each grain
  std::vector<std::string> notes;
};

/// The side that a direction points to: the wall of a contact whose file names none.
inline int side_towards(Vec2 d) {
  if (std::abs(d.x) > std::abs(d.y)) return d.x < 0 ? left : right;
  return d.y < 0 ? bottom : top;
}

}  // namespace arenite::io
