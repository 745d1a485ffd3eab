#pragma once
#include <array>

#include "model/elasticity/bounds.hpp"
#include "model/voxel_map.hpp"
#include "solid/elements/load.hpp"
#include "solid/elements/stress.hpp"
#include "solid/statics/loading.hpp"

namespace arenite::elements {

/// The effective stiffness of a sample that repeats itself in all directions, Pa: rows and columns in Voigt's order,
/// strains of shear doubled. It needs no clamps.
template <int D> struct EffectiveStiffness {
  std::array<Voigt<D>, voigt_count<D>> stiffness{};
  std::array<statics::StaticReport, voigt_count<D>> solves;  ///< by the strain that was applied
  statics::Support support;
  elasticity::BoundsIn<D> bounds;  ///< by what fills the cells, void included
};

/// Uniform strains, three in the plane and six in space, one after the other; the sample answers each with
/// displacements that repeat with it.
EffectiveStiffness<2> effective_stiffness(const PhaseMap& map, const SolveOptions& options);
EffectiveStiffness<3> effective_stiffness(const VoxelMap& map, const SolveOptions& options);

}  // namespace arenite::elements
