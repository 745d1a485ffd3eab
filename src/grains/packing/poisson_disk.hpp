#pragma once
#include <vector>

#include "grains/packing/cut_normal.hpp"
#include "grains/packing/free_space.hpp"

namespace arenite::packing {

/// How one class of disks is sampled.
struct PoissonDiskParameters {
  CutNormal law;                       ///< of radii
  double least = 0;                    ///< radius that must not fit anywhere at the end, m; 0: no such promise
  int trials = 30;                     ///< places tried round a disk before it is given up
};

/// Fast Poisson disk sampling (P Appendix): disks are tried at random angles round random disks, at the least distance
/// that the space allows, until all have been given up after so many trials in a row; the radius is drawn anew at each
/// trial, which favours small ones. With `least` every place where a disk of that radius still fits is then found
/// exactly and filled, with a radius of the law between that and what fits there: at the end it fits nowhere. The space holds `disks` already, and new ones are appended to both.
void fill_redrawing(FreeSpace& space, std::vector<Disk>& disks, const PoissonDiskParameters& parameters, RandomStream& random);

/// The same with radii that are held until they are placed, so that those placed follow the law without bias: every
/// radius of the sequence goes beside a random disk where it fits, found exactly; the first that fits nowhere in the
/// box ends the sampling, and is returned, m.
double fill_holding(FreeSpace& space, std::vector<Disk>& disks, const PoissonDiskParameters& parameters, RandomStream& random);

}  // namespace arenite::packing
