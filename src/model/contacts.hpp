#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/vec2.hpp"

namespace arenite {

/// Contacts as a structure of arrays, each physical contact once. A contact joins grain i with grain j, or with a
/// wall: then j = wall_partner(side) < 0. n points from j to i, t is n turned by +90 degrees, and the force on i is
/// fn n + ft t (fn > 0 pushes apart); the force on j is the opposite. The contact point lies at x_i - arm_i n and, for
/// two grains, at x_j + arm_j n, so the branch vector from j to i is (arm_i + arm_j) n.
struct Contacts {
  std::vector<std::int32_t> i, j;
  std::vector<double> nx, ny;
  std::vector<double> fn, ft;          ///< N
  std::vector<double> arm_i, arm_j;    ///< m; arm_j = 0 for a wall
  std::vector<double> overlap;         ///< h, m; NaN where the source of the data does not say
  std::vector<double> sliding_velocity;///< v_s, m/s; NaN where unknown
  std::vector<std::uint8_t> glued;     ///< 1 where adhesion acts

  std::size_t size() const { return i.size(); }
  bool is_wall(std::size_t c) const { return j[c] < 0; }
  int wall_side(std::size_t c) const { return -1 - j[c]; }
  Vec2 normal(std::size_t c) const { return {nx[c], ny[c]}; }
  Vec2 force_on_i(std::size_t c) const { return {fn[c] * nx[c] - ft[c] * ny[c], fn[c] * ny[c] + ft[c] * nx[c]}; }
  /// Adds one contact; overlap and sliding velocity unknown, not glued.
  void add(std::int32_t i, std::int32_t j, Vec2 normal, double fn, double ft, double arm_i, double arm_j);
};

constexpr std::int32_t wall_partner(int side) { return -1 - side; }

}  // namespace arenite
