#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "core/vec.hpp"
#include "model/phase_map.hpp"

namespace arenite {

/// A sample in space, cut into voxels, row by row and layer by layer from the bottom: voxel (x, y, z) has index
/// x + width (y + height z). Voxels of one particle carry the same grain label, an index into `grain_class`; -1 where
/// there is no particle.
struct VoxelMap {
  int width = 0, height = 0, depth = 0;  ///< voxels along x, y, z
  double dx = 1;                         ///< side of a voxel, m
  std::vector<Phase> phase;              ///< one a voxel
  std::vector<std::int32_t> grain;       ///< one a voxel
  std::vector<GrainClass> grain_class;   ///< one a grain
  bool has_length = true;                ///< false: nobody said how long a voxel is, and `dx` stands for one

  std::size_t size() const { return phase.size(); }
  std::size_t index(int x, int y, int z) const {
    return static_cast<std::size_t>(x) +
           static_cast<std::size_t>(width) *
               (static_cast<std::size_t>(y) + static_cast<std::size_t>(height) * static_cast<std::size_t>(z));
  }
};

/// All voxels empty, no grains. Throws InputError for sizes that are not positive or too many.
VoxelMap make_voxel_map(int width, int height, int depth, double dx);

/// What the force of a clamp is spread over: width times height, m^2.
inline double section_of(const VoxelMap& map) { return map.width * map.dx * map.height * map.dx; }

/// Throws InputError, with every problem found, unless sizes, labels and spacing fit each other.
void check(const VoxelMap& map);

/// Displacement and stress in the middle of every voxel, in the map's order; zero in the void. Tension is positive.
struct VoxelStress {
  int width = 0, height = 0, depth = 0;
  double dx = 1;                              ///< m
  std::vector<float> ux, uy, uz;              ///< m
  std::vector<float> xx, yy, zz, yz, xz, xy;  ///< Pa
  std::vector<float> damage;                  ///< share of a voxel's bonds that broke in a test; empty: none was made
  std::size_t size() const { return xx.size(); }
};

/// The map of a sample in the plane or in space, and the stress that belongs to it.
template <int D> using MapIn = std::conditional_t<D == 2, PhaseMap, VoxelMap>;
template <int D> using StressIn = std::conditional_t<D == 2, StressField, VoxelStress>;

/// The components of a symmetric tensor by their two axes, in Voigt's order: xx, yy, xy; xx, yy, zz, yz, xz, xy.
template <int D> inline constexpr std::size_t voigt_count = D*(D + 1) / 2;
template <int D> inline constexpr std::array<std::array<int, 2>, voigt_count<D>> voigt_axes{};
template <> inline constexpr std::array<std::array<int, 2>, 3> voigt_axes<2>{{{0, 0}, {1, 1}, {0, 1}}};
template <>
inline constexpr std::array<std::array<int, 2>, 6> voigt_axes<3>{{{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}};

}  // namespace arenite
