#pragma once
#include <string_view>
#include <vector>

#include "grains/fields/coarse_grained.hpp"
#include "model/colour_scale.hpp"
#include "model/result.hpp"

namespace arenite::fields {

/// A picture of coarse-grained fields. Stresses are whole, with their kinetic part; compression is positive, but for
/// the shear stress.
struct CoarseLayer {
  std::string_view name, label, symbol, unit;
  ColourScale colours = ColourScale::even;
  bool is_of_motion = false;  ///< nothing where grains are at rest
  std::vector<double> (*of)(const CoarseFields& fields) = nullptr;
  std::string_view formula = {};  ///< instead, of other layers (core/formula.hpp)
};

/// All, in the order of the page. A new one is one more row.
const std::vector<CoarseLayer>& coarse_layers();

/// A layer at every point of the grid.
std::vector<double> values_of(const CoarseLayer& layer, const CoarseFields& fields);

/// Fields of a state as pictures show them: of a kernel as wide as the mean grain, or as a cell where there are many
/// grains. `shear_rate`, 1/s: of a cell that is sheared.
CoarseFields fields_to_show(const Packing& packing, double shear_rate);

/// Whether grains fluctuate about the mean flow.
bool are_in_motion(const CoarseFields& fields);

}  // namespace arenite::fields
