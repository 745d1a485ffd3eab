#pragma once
#include "model/phase_map.hpp"
#include "solid/elements/options.hpp"
#include "solid/statics/loading.hpp"

namespace arenite::elements {

/// How a sample of elements is held and loaded.
struct LoadOptions {
  statics::Loading loading = statics::Loading::tension;
  statics::LowerEdge lower = statics::LowerEdge::fixed;
  double strain = 1e-4;     ///< displacement of the upper edge over the height
  double tolerance = 1e-6;  ///< of the residual, relative to that of uniform strain
  int max_iterations = 0;   ///< 0: 50, more for tolerances below 1e-6
  Material material{};
  statics::Watch watch{};
};

/// Loads a sample by the displacement of its upper edge and finds its field at equilibrium, in the middle of every
/// pixel. Pixels that no edges join to both clamps carry nothing, those that hang by a corner among them. Throws
/// InputError for a map or options that make no sense; anything that a sound map can turn out to be is an Ending.
statics::LoadResult load(const PhaseMap& map, const LoadOptions& options);

/// Three loads (statics/loading.hpp). `options.loading` is not used.
statics::EffectiveModuli effective_moduli(const PhaseMap& map, const LoadOptions& options);

}  // namespace arenite::elements
