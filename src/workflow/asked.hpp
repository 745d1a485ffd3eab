#pragma once
#include <cstddef>

#include "model/result.hpp"
#include "recipe/recipe.hpp"

namespace arenite::workflow {

/// Notes in the result of a stage, 0 the packing, what its recipe asked of it (model/result.hpp), and beside the rows
/// of its history what it drove (grains/fields/driven.hpp); `loaded_before` is what its strains refer to
/// (GrainStageIn), null for the first row.
template <int D>
void note_asked(StageResultIn<D>& made, const recipe::Recipe& recipe, std::size_t place,
                const PackingIn<D>* loaded_before = nullptr);

}  // namespace arenite::workflow
