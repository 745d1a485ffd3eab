#pragma once
#include "model/packing.hpp"
#include "model/result.hpp"
#include "recipe/recipe.hpp"

namespace arenite::workflow {

/// Cements and rasterises a packing, with its phases, pores, voids and coordination as numbers. Throws InputError for a
/// saturation out of reach and a crop wider than the sample.
FieldResult make_cemented_sample(const recipe::Recipe& recipe, const Packing& packing);

}  // namespace arenite::workflow
