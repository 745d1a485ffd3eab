#pragma once
#include <array>
#include <cstddef>
#include <string>

#include "core/vec.hpp"
#include "model/elasticity/bounds.hpp"
#include "model/voxel_map.hpp"
#include "solid/statics/loading.hpp"
#include "solid/voxels/voxels.hpp"

namespace arenite::voxels {

/// How a sample of voxels is solved.
struct SolveOptions {
  double tolerance = 1e-6;  ///< of the residual, relative to that of uniform strain
  int max_iterations = 0;   ///< 0: 200, more for tolerances below 1e-6
  int cell = 8;             ///< voxels a side of the cells of the coarse space; thin struts want 4
  Material material{};
  statics::Watch watch{};
};

/// How it is held between its lowest and its highest layer and loaded: shear moves the top along x.
struct LoadOptions : SolveOptions {
  statics::Loading loading = statics::Loading::tension;
  statics::LowerEdge lower = statics::LowerEdge::fixed;
  double strain = 1e-4;  ///< displacement of the upper face over the height
};

struct LoadReport : statics::StaticReport {
  statics::Ending ending = statics::Ending::empty;
  std::string sentence;  ///< the same in words, with what was found loose
  statics::Support support;
  Vec3 top_force, bottom_force;  ///< of the clamps on the sample, N
  /// sum sigma_zz V over F_top times the height, less one: zero at equilibrium.
  double identity_defect = 0;
  double modulus = 0;  ///< apparent: mean stress of the top over the strain, Pa; Young's or shear
  std::size_t coarse_nodes = 0;
};

struct LoadResult {
  LoadReport report;
  VoxelStress field;
};

/// Loads a sample by the displacement of its upper face and finds its field at equilibrium. Voxels that no faces join
/// to both clamps carry nothing. Throws InputError for a map or options that make no sense.
LoadResult load(const VoxelMap& map, const LoadOptions& options);

/// The effective stiffness of a sample that repeats itself in all directions, Pa: rows and columns in Voigt's order
/// (xx, yy, zz, yz, xz, xy), strains of shear doubled.
struct EffectiveStiffness {
  std::array<std::array<double, 6>, 6> stiffness{};
  std::array<statics::StaticReport, 6> solves;  ///< by the strain that was applied
  statics::Support support;
  elasticity::SpaceBounds bounds;  ///< by what fills the voxels, void included
};

/// Six uniform strains, one after the other; the sample answers each with displacements that repeat with it.
EffectiveStiffness effective_stiffness(const VoxelMap& map, const SolveOptions& options);

}  // namespace arenite::voxels
