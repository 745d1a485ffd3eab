#pragma once
#include "core/pages.hpp"
#include "solid/statics/loading.hpp"
#include "solid/voxels/voxels.hpp"

namespace arenite::voxels {

/// Empties all voxels that faces do not join to both clamps, the lowest and the highest layer, and counts them. `tie`
/// says, a corner (padded), what the stiffest-held of its voxels is tied to. What hangs by an edge or a corner could
/// turn about it and carries nothing.
statics::Support prune(Voxels& voxels, Buffer<statics::Tie>& tie);

/// Empties, in a periodic sample, all voxels that faces do not join to their own images, and counts them: the others
/// float.
statics::Support prune_periodic(Voxels& voxels);

}  // namespace arenite::voxels
