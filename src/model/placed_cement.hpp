#pragma once
#include <cstdint>
#include <vector>

#include "core/vec2.hpp"
#include "geometry/outline.hpp"
#include "model/cement.hpp"
#include "model/packing.hpp"

namespace arenite {

/// What a window shows of a cemented packing, periodic images included: every part that may reach into it, with
/// coordinates from the window's middle, so that a mirrored sample has mirrored numbers to the last bit.
struct PlacedCement {
  struct Grain {
    Vec2 centre;
    double radius;
    std::int32_t grain;          ///< in the packing
  };
  struct Joint {
    Vec2 a, b;                   ///< centres of grains i and j
    double radius_a, radius_b;   ///< of the grains, m
    double half_a, half_b;       ///< half bases of a bridge, m
    double arc;                  ///< radius of the arcs of a meniscus, m
    std::int32_t index;          ///< in Cement::bridges or Cement::menisci
  };
  geometry::Rectangle window;
  std::vector<Grain> grains;     ///< in the order of the packing
  std::vector<Joint> bridges, menisci;
  bool full = false;
  double coating = 0;            ///< m
};

PlacedCement place(const Packing& packing, const Cement& cement, const geometry::Rectangle& window);

/// Throws InputError, with every problem found, unless grains are finite with positive radii, the cell is unsheared, and
/// the parts of the cement name grains of the packing and have finite sizes.
void check(const Packing& packing, const Cement& cement);

std::vector<geometry::Outline> grain_outlines(const PlacedCement& placed);
/// Of matrix, each as if there were no grains: trapezia, halves of menisci, disks of grain with layer. Not for `full`.
std::vector<geometry::Outline> matrix_outlines(const PlacedCement& placed);
void add_bridge_outline(const PlacedCement::Joint& bridge, std::vector<geometry::Outline>& outlines);
void add_meniscus_outlines(const PlacedCement::Joint& meniscus, std::vector<geometry::Outline>& outlines);

}  // namespace arenite
