#pragma once
#include "core/pages.hpp"
#include "solid/elements/elements.hpp"
#include "solid/statics/loading.hpp"

namespace arenite::elements {

/// Empties all pixels that edges do not join to both clamps, and counts them. `tie` says, a corner (padded), what the
/// stiffest-held of its pixels is tied to. What hangs by a corner could turn about it and carries nothing.
statics::Support prune(Elements& elements, Buffer<statics::Tie>& tie);

}  // namespace arenite::elements
