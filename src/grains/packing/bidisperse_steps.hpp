#pragma once
#include <cstdint>
#include <vector>

#include "grains/packing/bidisperse.hpp"
#include "grains/packing/poisson_disk.hpp"

namespace arenite::packing {

/// Throws InputError with everything that is wrong with the parameters.
void check(const BidisperseParameters& parameters);

/// Disks of both classes, large ones first.
struct TwoClasses {
  std::vector<Disk> disks;
  std::size_t large = 0;               ///< how many
  double gap = 0;                      ///< between large ones, m
  double area_large = 0, area_small = 0;  ///< m^2

  double volume_ratio() const { return area_large / area_small; }
};

/// Both steps of the sampling, with that gap between large disks. Another `attempt` is another sampling.
TwoClasses sample_two_classes(const BidisperseParameters& parameters, const geometry::Box& box, double gap, std::uint64_t seed,
                              std::uint64_t attempt = 0);

/// A search's result and its cost.
struct GapSearch {
  TwoClasses best;
  int samplings = 0;
};

/// The gap at which the volume ratio asked for comes out, by a line through the ratios that samplings
/// reach; gap 0 where even that leaves too many small disks. Throws InputError where the ratio is below what the widest gap gives.
GapSearch find_gap(const BidisperseParameters& parameters, const geometry::Box& box, std::uint64_t seed);

/// Takes out small disks by lot, each as likely, until the volume ratio is as near to the one asked for as it gets;
/// returns how many.
std::size_t leave_out_small(TwoClasses& classes, double volume_ratio, std::uint64_t seed);

}  // namespace arenite::packing
