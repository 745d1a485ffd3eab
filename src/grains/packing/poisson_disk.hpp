#pragma once
#include <cmath>

#include "core/random.hpp"
#include "grains/packing/free_space.hpp"

namespace arenite::packing {

/// Normal law of radii that keeps only those in [low, high], m.
struct CutNormal {
  double mean = 0, deviation = 0, low = 0, high = 0;

  /// One radius of the law; with `below` one of its part in [low, below].
  double draw(RandomStream& random, double below = HUGE_VAL) const;
};

/// Fast Poisson disk sampling (P Appendix): disks, or spheres, are tried in random directions from random ones, at the
/// least distance that the space allows, until all have been given up after so many trials in a row; the radius is
/// drawn anew at each trial, which favours small ones.
template <int D> void fill_redrawing(FreeSpace<D>& space, const CutNormal& law, int trials, RandomStream& random);

/// Afterwards: every place where a disk of the radius `least`, m, still fits is found exactly and filled, with a radius
/// of the law between that and what fits there: at the end it fits nowhere.
void fill_rest(FreeSpace<2>& space, const CutNormal& law, double least, RandomStream& random);

/// As `fill_redrawing`, with radii that are held until they are placed, so that those placed follow the law without
/// bias: every radius of the sequence goes beside a random disk where it fits, found exactly; the first that fits
/// nowhere in the box ends the sampling, and is returned, m.
double fill_holding(FreeSpace<2>& space, const CutNormal& law, RandomStream& random);

}  // namespace arenite::packing
