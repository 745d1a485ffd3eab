#pragma once
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/random.hpp"
#include "grains/packing/bidisperse.hpp"
#include "grains/packing/free_space.hpp"

namespace arenite::packing {

/// Normal law of radii that keeps only those in [low, high], m.
struct CutNormal {
  double mean = 0, deviation = 0, low = 0, high = 0;

  /// One radius of the law; with `below` one of its part in [low, below].
  double draw(RandomStream& random, double below = HUGE_VAL) const;
};

/// Fast Poisson disk sampling (P Appendix): disks are tried at random angles round random disks, at the least distance that the space allows, until
/// all have been given up after so many trials in a row; the radius is drawn anew at each trial, which favours small ones. With `least` > 0 every
/// place where a disk of that radius, m, still fits is then found exactly and filled, with a radius of the law between that and what fits there: at
/// the end it fits nowhere. The space holds `disks` already, and new ones are appended to both.
void fill_redrawing(FreeSpace& space, std::vector<Disk>& disks, const CutNormal& law, int trials, double least, RandomStream& random);

/// The same with radii that are held until they are placed, so that those placed follow the law without bias: every radius of the sequence goes
/// beside a random disk where it fits, found exactly; the first that fits nowhere in the box ends the sampling, and is returned, m.
double fill_holding(FreeSpace& space, std::vector<Disk>& disks, const CutNormal& law, RandomStream& random);

/// Throws InputError with everything that is wrong with the parameters.
void check(const BidisperseParameters& parameters);

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
TwoClasses sample_two_classes(const BidisperseParameters& parameters, const geometry::Box& box, double gap, std::uint64_t seed, std::uint64_t attempt = 0);

/// The gap at which the volume ratio asked for comes out, by a line through the ratios that samplings reach; gap 0 where even that leaves too many
/// small disks. Throws InputError where the ratio is below what the widest gap gives.
TwoClasses find_gap(const BidisperseParameters& parameters, const geometry::Box& box, std::uint64_t seed);

/// Removes small disks at random, each as likely, until the volume ratio is as near to the one asked for as it gets; returns how many.
std::size_t leave_out_small(TwoClasses& classes, double volume_ratio, std::uint64_t seed);

}  // namespace arenite::packing
