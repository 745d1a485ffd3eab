#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "model/voxel_map.hpp"
#include "solid/elements/elements.hpp"
#include "solid/elements/options.hpp"
#include "solid/statics/loading.hpp"

namespace arenite::elements {

/// How a sample of elements is solved.
struct SolveOptions {
  double tolerance = 1e-6;  ///< of the residual, relative to that of uniform strain
  int max_iterations = 0;   ///< 0: `statics::usual_cap`
  int cell = 0;  ///< elements a side of the coarse cells; 0: 16 in the plane, 8 to 16 in space (thin struts: 4)
  Material material{};
  int threads = 1;  ///< that work on a sample in space; the field does not depend on their number
  statics::Watch watch{};
};
/// What 0 stands for, in a sample of so many elements.
template <int D> int coarse_side(const SolveOptions& options, std::size_t elements);
template <int D> int most_iterations(const SolveOptions& options);

/// Another way to the equilibrium of a sample in space than statics::StaticSolver, with the meaning of its arguments:
/// one that more than this process works at (cluster/).
struct OtherSolver {
  std::string name;  ///< "PETSc 3.18.5 on 4 processes"
  std::function<statics::StaticReport(const Voxels& elements, const std::vector<std::uint8_t>& prescribed,
                                      FieldIn<3, double>& u, double tolerance, int max_iterations,
                                      const statics::Watch& watch)>
      solve;
};

/// How it is held between its lowest and its highest level and loaded: shear moves the top along x.
struct LoadOptions : SolveOptions {
  statics::Loading loading = statics::Loading::tension;
  statics::LowerEdge lower = statics::LowerEdge::fixed;
  double strain = 1e-4;                 ///< displacement of the upper edge over the height
  const OtherSolver* solver = nullptr;  ///< in space
};

/// Loads a sample by the displacement of its upper edge, or face, and finds its field at equilibrium, in the middle of
/// every pixel or voxel. What prune() finds loose carries nothing. Throws InputError for a map or options that make no
/// sense; anything that a sound map can turn out to be is an Ending.
statics::LoadResult load(const PhaseMap& map, const LoadOptions& options);
statics::LoadResultIn<3> load(const VoxelMap& map, const LoadOptions& options);

/// The force of every element on its corners, clamps or not; of unit spacing (statics::judge).
template <int D> FieldIn<D, double> forces_of(const ElementsIn<D>& elements, const FieldIn<D, double>& u);

/// Three loads (statics/loading.hpp). `options.loading` is not used.
statics::EffectiveModuli effective_moduli(const PhaseMap& map, const LoadOptions& options);

}  // namespace arenite::elements
