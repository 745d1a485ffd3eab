#pragma once
#include <cstdint>

#include "core/parameters.hpp"
#include "model/packing.hpp"

namespace arenite::packing {

/// Two size classes of disks, or of spheres, placed by fast Poisson disk sampling in two steps (P II.A, II.B,
/// Appendix): large ones with a gap between them that leaves room, then small ones without. Near size_ratio 1 a class
/// is only a label: with P's common cut at 1 both are one population, and what sets them apart is which step placed
/// them.
struct BidisperseParameters {
  double large_radius = 0;      ///< mean, m
  double size_ratio = 2.5;      ///< gamma = mean large over mean small radius, 1 or more
  double volume_ratio = 1.4;    ///< theta = area, of spheres volume, of large ones over that of small ones
  double deviation = 0.25;      ///< standard deviation of each class over its mean radius
  double cut = 1.5;             ///< radii are cut at this many standard deviations
  bool cut_each_class = false;  ///< cut every class by itself; otherwise P's common range, from the small mean less
                                ///< its cut to the large mean plus its cut
  bool hold_radius = false;     ///< a radius is kept until it is placed; otherwise drawn anew at each trial (P),
                                ///< which favours small ones; in the plane alone
  double box_area = 900;        ///< of the square over pi large_radius^2; volume of the cube over that of a sphere of
                                ///< large_radius
  int trials = 30;              ///< places tried round a disk before it is given up (redrawn radii)
  bool maximal = false;         ///< afterwards every place is filled where a disk of the class still fits (redrawn
                                ///< radii, in the plane alone); otherwise the sampling ends with the trials (P)
  double tolerance = 0.01;      ///< relative error of theta at which the search for the gap ends
  bool operator==(const BidisperseParameters&) const = default;
  void declare(ParameterVisitor& visitor);
};

/// Radii that are held, and every place that is left, are found exactly: on the free arcs of circles.
inline constexpr const char* of_disks_alone =
    "hold_radius and maximal find places on the arcs of circles, in the plane alone; leave them out in space and raise "
    "trials";

struct BidisperseReport {
  double gap = 0;                         ///< d_min between large ones, m: found so that theta comes out
  double volume_ratio = 0;                ///< reached
  double volume_ratio_error = 0;          ///< reached over asked, less 1
  double solid_fraction = 0;              ///< of the whole box
  double mean_large = 0, mean_small = 0;  ///< radii, m
  std::size_t large = 0, small = 0;
  std::size_t left_out = 0;  ///< small ones removed again at random, where every gap leaves too many
  int samplings = 0;         ///< of the whole box, until theta came out
};

/// Grains of materials 0 (large, first in the arrays) and 1 (small) in the square or cubic box of the domain, which is
/// set here; sides are walls or periodic as `packing.domain` says. No two overlap, and large ones keep the gap. A
/// maximal sampling is so exactly: after the first step no disk of (1 - cut deviation) large_radius fits with the gap,
/// after the second none of (1 - cut deviation) large_radius/size_ratio, unless disks were left out. With held radii
/// each step ends at the first radius that fits nowhere in the box. Same seed: same packing. Throws InputError where a
/// parameter is out of range or theta out of reach, and says what can be reached.
template <int D>
BidisperseReport sample_bidisperse(PackingIn<D>& packing, const BidisperseParameters& parameters, std::uint64_t seed);

/// Throws InputError with everything that is wrong with the parameters.
template <int D> void check(const BidisperseParameters& parameters);

}  // namespace arenite::packing
