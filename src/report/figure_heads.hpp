#pragma once
#include <vector>

#include "report/figures/drawing.hpp"
#include "statistics/numbers.hpp"

namespace arenite::report::figures {

/// The heads of all figures of a packing, a field or a film in the order of the page, pictures among them, which have
/// renderers of their own.
std::vector<Head> packing_heads();
std::vector<Head> field_heads();
std::vector<Head> voxel_heads();
std::vector<Head> sphere_heads();
std::vector<Head> film_heads();
/// All of these as {"stage", "field", "voxels", "spheres", "film"}: the one list of page and print.
Numbers heads_of_parts();
/// Of several results, which have no cards.
std::vector<Head> heads_over_runs();

}  // namespace arenite::report::figures
