#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/rectangle.hpp"
#include "grains/packing/bidisperse.hpp"
#include "grains/packing/free_space.hpp"

namespace arenite::packing {

/// Disks of both classes, large ones first.
struct TwoClasses {
  std::vector<Disk> disks;
  std::size_t large = 0;                  ///< how many
  double gap = 0;                         ///< between large ones, m
  double area_large = 0, area_small = 0;  ///< m^2
  int samplings = 0;                      ///< that the search took

  double volume_ratio() const { return area_large / area_small; }
};

/// Both steps of the sampling, with that gap between large disks. Another `attempt` is another sampling.
TwoClasses sample_two_classes(const BidisperseParameters& parameters, const geometry::Box<2>& box, double gap,
                              std::uint64_t seed, std::uint64_t attempt = 0);

/// Removes small disks at random, each as likely, until the volume ratio is as near to the one asked for as it gets;
/// returns how many.
std::size_t leave_out_small(TwoClasses& classes, double volume_ratio, std::uint64_t seed);

}  // namespace arenite::packing
