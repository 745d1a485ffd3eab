#pragma once
#include "model/phase_map.hpp"
#include "solid/peridynamics/options.hpp"
#include "solid/statics/loading.hpp"
#include "solid/statics/watch.hpp"

namespace arenite::peridynamics {

using statics::EffectiveModuli;
using statics::Ending;
using statics::Hinge;
using statics::LoadReport;
using statics::LoadResult;
using statics::StaticReport;
using statics::Support;
using statics::Tie;

/// Loads a sample by the displacement of its top row and finds its field at equilibrium. Throws InputError for a map or
/// options that make no sense; anything that a sound map can turn out to be is an Ending.
LoadResult load(const PhaseMap& map, const LoadOptions& options);

/// Three loads: tension, tension of the transposed map, shear. `options.loading` is not used; the watch sees one run
/// from 0 to 1, and what it stops leaves zeros.
EffectiveModuli effective_moduli(const PhaseMap& map, const LoadOptions& options);

}  // namespace arenite::peridynamics
