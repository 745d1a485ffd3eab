#pragma once
#include "recipe/recipe_reader.hpp"

namespace arenite::study {

/// Lays the recipe that the key `base` names under this one, and its base under both: sections are merged key by key, what else
/// is given here counts instead. A base's [sweep] is left out. The key is taken out of the tree, and the files that were
/// read are added to `reading.bases`. Throws InputError where there is no such file, or one leads back to itself.
void lay_base_under(Node& root, Reading& reading);

}  // namespace arenite::study
