#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/rectangle.hpp"
#include "grains/packing/bidisperse.hpp"
#include "grains/packing/free_space.hpp"

namespace arenite::packing {

/// What they are called in messages.
template <int D> inline constexpr const char* round_grains = "disks";
template <> inline constexpr const char* round_grains<3> = "spheres";

/// Disks (D = 2) or spheres (3) of both classes, large ones first.
template <int D> struct TwoClasses {
  std::vector<Ball<D>> balls;
  std::size_t large = 0;                      ///< how many
  double gap = 0;                             ///< between large ones, m
  double volume_large = 0, volume_small = 0;  ///< m^D
  int samplings = 0;                          ///< that the search took

  std::size_t small() const { return balls.size() - large; }
  double volume_ratio() const { return volume_large / volume_small; }
};

/// Both steps of the sampling, with that gap between large disks. Another `attempt` is another sampling.
template <int D>
TwoClasses<D> sample_two_classes(const BidisperseParameters& parameters, const geometry::Box<D>& box, double gap,
                                 std::uint64_t seed, std::uint64_t attempt = 0);

/// Removes small ones at random, each as likely, until the volume ratio is as near to the one asked for as it gets;
/// returns how many.
template <int D> std::size_t leave_out_small(TwoClasses<D>& classes, double volume_ratio, std::uint64_t seed);

}  // namespace arenite::packing
