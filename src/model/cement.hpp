#pragma once
#include <cstdint>
#include <vector>

namespace arenite {

/// A trapezium of matrix between two grains (P Fig. 2a): its bases stand at the two centres, across the line that joins
/// them. What lies inside a grain is grain.
struct Bridge {
  std::int32_t i = 0, j = 0;     ///< grains
  double half_i = 0, half_j = 0; ///< half of each base, m
};

/// Matrix held by two grains between two arcs that touch both of them, as a liquid would (zero contact angle): an arc's
/// circle has `radius` and touches both grains from outside.
struct Meniscus {
  std::int32_t i = 0, j = 0;
  double radius = 0;             ///< m; infinite: the arcs are straight tangents
};

/// The binding matrix of a packing, as geometry; a raster or an exact area is made from it and the grains. What is
/// there adds up: a point is matrix if any part says so and no grain covers it.
struct Cement {
  bool full = false;             ///< every point that is not grain is matrix
  double coating = 0;            ///< thickness of an even layer round every grain, m
  std::vector<Bridge> bridges;
  std::vector<Meniscus> menisci;
};

}  // namespace arenite
