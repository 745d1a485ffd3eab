#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "model/packing.hpp"
#include "model/phase_map.hpp"
#include "model/result.hpp"
#include "recipe/recipe.hpp"

namespace arenite::workflow {

/// Materials of the large and of the small grains: those of [bidisperse], or of two materials the one with the larger
/// mean radius; nothing where a packing has no two classes.
struct ClassMaterials {
  std::int32_t large = 0, small = 1;
};
std::optional<ClassMaterials> class_materials(const recipe::Recipe& recipe, const Packing& packing);

/// The class of every grain by its material; empty without classes.
std::vector<GrainClass> classes(const Packing& packing, const std::optional<ClassMaterials>& materials);

/// Cements and rasterises a packing, with its phases, pores, voids and coordination as numbers. Throws InputError for a
/// saturation out of reach and a crop wider than the sample.
FieldResult make_cemented_sample(const recipe::Recipe& recipe, const Packing& packing);

}  // namespace arenite::workflow
