#pragma once
#include "grains/packing/bidisperse.hpp"

#include "grains/packing/free_space.hpp"
#include "grains/packing/poisson_disk.hpp"
#include "grains/packing/two_classes.hpp"

namespace arenite::packing {

inline BidisperseParameters parameters(double gamma, double theta, double box_area = 150) {
  BidisperseParameters p;
  p.large_radius = 1e-3;
  p.size_ratio = gamma;
  p.volume_ratio = theta;
  p.box_area = box_area;
  return p;
}

}  // namespace arenite::packing
