#pragma once
#include "core/pages.hpp"
#include "solid/elements/elements.hpp"
#include "solid/statics/loading.hpp"

namespace arenite::elements {

/// Empties all pixels that edges (voxels that faces) do not join to both clamps, the lowest and the highest level, and
/// counts them. `tie` says, a corner (padded), what the stiffest-held of its cells is tied to. What hangs by less could
/// turn about it and carries nothing.
template <int D> statics::Support prune(ElementsIn<D>& elements, Buffer<statics::Tie>& tie);

/// Empties, in a periodic sample, all cells that are not joined like this to their own images, and counts them: the
/// others float.
template <int D> statics::Support prune_periodic(ElementsIn<D>& elements);

}  // namespace arenite::elements
