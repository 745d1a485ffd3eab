#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/vec2.hpp"

namespace arenite {

/// Grains as a structure of arrays: cylinders of equal length seen end on, so disks. All arrays have one
/// length. Index = position in these arrays = what Contacts refer to; `id` is the user's name for a grain.
struct Grains {
  std::vector<std::int64_t> id;
  std::vector<double> x, y;              ///< centre, m
  std::vector<double> radius;            ///< m
  std::vector<std::int32_t> material;    ///< index into Materials
  std::vector<double> angle;             ///< rotation since the start, rad, counter-clockwise
  std::vector<double> vx, vy;            ///< m/s
  std::vector<double> omega;             ///< rad/s
  std::vector<std::uint8_t> zone;        ///< 0: none; > 0: number of a region (1: glued agglomerate)

  std::size_t size() const { return x.size(); }
  Vec2 centre(std::size_t i) const { return {x[i], y[i]}; }
  /// Resizes every array; new grains are at rest at the origin, radius 0, id = index.
  void resize(std::size_t n);
};

}  // namespace arenite
