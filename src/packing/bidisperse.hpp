#pragma once
#include <cstdint>
#include <functional>

#include "model/packing.hpp"

namespace arenite::packing {

/// Two size classes of disks placed by fast Poisson disk sampling in two steps (P II.A, II.B, Appendix): large ones with a
/// gap between them that leaves room, then small ones without.
struct BidisperseParameters {
  double large_radius = 0;           ///< mean, m
  double size_ratio = 2.5;           ///< gamma = mean large over mean small radius
  double volume_ratio = 1.4;         ///< theta = area of large over area of small disks
  double deviation = 0.25;           ///< standard deviation of each class over its mean radius
  double cut = 1.5;                  ///< radii are cut at this many standard deviations
  bool cut_each_class = false;       ///< cut every class by itself; otherwise P's common range of both classes
  bool hold_radius = false;          ///< a radius is kept until it is placed; otherwise drawn anew at each trial (P)
  double box_area = 900;             ///< over pi large_radius^2
  int trials = 30;                   ///< places tried round a disk before it is given up
  bool operator==(const BidisperseParameters&) const = default;
};

struct BidisperseReport {
  double gap = 0;                    ///< d_min between large disks, m: found so that theta comes out
  double volume_ratio = 0;           ///< reached
  double solid_fraction = 0;
  double mean_large = 0, mean_small = 0;  ///< radii, m
  std::size_t large = 0, small = 0;
  std::size_t left_out = 0;          ///< small disks taken out again, where even no gap leaves too many
};

/// Grains of materials 0 (large) and 1 (small) in the square box of the domain, which is set here; sides are walls or
/// periodic as `domain` says. Same seed: same packing. Throws InputError where gamma or theta is out of reach.
BidisperseReport sample_bidisperse(Packing& packing, const BidisperseParameters& parameters, std::uint64_t seed);

}  // namespace arenite::packing
