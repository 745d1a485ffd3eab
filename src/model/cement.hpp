#pragma once
#include <cstdint>
#include <vector>

#include "core/vec.hpp"
#include "geometry/outline.hpp"
#include "model/packing.hpp"

namespace arenite {

/// A trapezium of matrix between two grains (P Fig. 2a): its bases stand at the two centres, across the line that joins
/// them. What lies inside a grain is grain.
struct Bridge {
  std::int32_t i = 0, j = 0;      ///< grains
  double half_i = 0, half_j = 0;  ///< half of each base, m
};

/// Matrix held by two grains between two arcs that touch both of them, as a liquid would (zero contact angle): an arc's
/// circle has `radius` and touches both grains from outside.
struct Meniscus {
  std::int32_t i = 0, j = 0;
  double radius = 0;  ///< m; infinite: the arcs are straight tangents
};

/// The binding matrix of a packing, as geometry; a grid or an exact area is made from it and the grains. What is there
/// adds up: a point is matrix if any part says so and no grain covers it.
struct Cement {
  bool full = false;   ///< every point that is not grain is matrix
  double coating = 0;  ///< thickness of an even layer round every grain, m
  std::vector<Bridge> bridges;
  std::vector<Meniscus> menisci;
};

/// What a window shows of a cemented packing, periodic images included: every part that may reach into it, with
/// coordinates from the window's middle, so that a mirrored sample has mirrored numbers to the last bit.
struct PlacedCement {
  struct Grain {
    Vec2 centre;
    double radius;
    std::int32_t grain;  ///< in the packing
  };
  struct Neck {
    Vec2 a, b;                  ///< centres of grains i and j
    double radius_a, radius_b;  ///< of the grains, m
    double half_a, half_b;      ///< half bases of a bridge, m
    double arc;                 ///< radius of the arcs of a meniscus, m; 0: a bridge
  };
  geometry::Rectangle window;
  std::vector<Grain> grains;  ///< in the order of the packing
  std::vector<Neck> necks;    ///< bridges, then menisci
  bool full = false;
  double coating = 0;  ///< m
};

PlacedCement place(const Packing& packing, const Cement& cement, const geometry::Rectangle& window);

/// Throws InputError, with every problem found, unless grains are finite with positive radii, the cell is unsheared,
/// and the parts of the cement name grains of the packing and have finite sizes.
void check(const Packing& packing, const Cement& cement);

/// The trapezium of a bridge, or the halves of a meniscus on either side of its grains' joining line; nothing of a
/// bridge without length or width, or where the arcs meet.
std::vector<geometry::Outline> outlines_of(const PlacedCement::Neck& neck);

}  // namespace arenite
