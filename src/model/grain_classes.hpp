#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "model/packing.hpp"
#include "model/phase_map.hpp"

/// Large and small grains of a sample of two sizes, told by their materials (P II.B).
namespace arenite {

/// Materials of the large and of the small grains.
struct ClassMaterials {
  std::int32_t large = 0, small = 1;
};

/// Mean radius of the grains of a material (of all: -1), m; 0 without any.
template <int D> double mean_radius(const PackingIn<D>& packing, std::int32_t material = -1);

/// Of two materials that with the larger mean radius is the large grains'; nothing where a packing has no two classes.
template <int D> std::optional<ClassMaterials> classes_by_radius(const PackingIn<D>& packing);

/// The class of every grain by its material; empty without classes.
template <int D>
std::vector<GrainClass> classes_of(const PackingIn<D>& packing, const std::optional<ClassMaterials>& materials);

/// Lengths that a sample takes from the mean radius of its large grains, as P does, whose grid has 40 nodes to it
/// (P II.B): necks bridge gaps of 3 nodes, and the window is 1024 nodes wide.
struct SampleLengths {
  static constexpr double gap_over_radius = 3.0 / 40, window_over_radius = 1024.0 / 40;
  double gap = 0, window = 0;  ///< m
};
SampleLengths sample_lengths(double large_radius);

}  // namespace arenite
