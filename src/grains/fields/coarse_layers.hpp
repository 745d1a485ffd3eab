#pragma once
#include <functional>
#include <string_view>
#include <vector>

#include "grains/fields/coarse_grained.hpp"
#include "model/colour_scale.hpp"
#include "model/result.hpp"

namespace arenite::fields {

/// A picture of coarse-grained fields. Stresses are whole, with their kinetic part; compression is positive, but for
/// the shear stress.
template <int D> struct CoarseLayerIn {
  std::string_view name, label, symbol, unit;
  ColourScale colours = ColourScale::even;
  bool is_of_motion = false;  ///< nothing where grains are at rest
  std::function<std::vector<double>(const CoarseFieldsIn<D>& fields)> of = nullptr;
  std::string_view formula = {};  ///< instead, of other layers (core/formula.hpp)
  bool from_least = false;        ///< its colours begin at its least value, not at 0
};

/// All, in the order of the page. A new one is one more row.
template <int D> const std::vector<CoarseLayerIn<D>>& coarse_layers();

/// Whether fields have something of a layer: of motion where grains fluctuate about the mean flow.
template <int D> bool has_layer(const CoarseLayerIn<D>& layer, const CoarseFieldsIn<D>& fields);

/// A layer at every point of the grid.
template <int D> std::vector<double> values_of(const CoarseLayerIn<D>& layer, const CoarseFieldsIn<D>& fields);

/// The grid over the box of a state that pictures show. In the plane its points are a mean diameter apart, or further
/// where these would be more than 2500; in space half of that, or further where these would be more than 48 along the
/// longest side.
template <int D> GridIn<D> grid_to_show(const PackingIn<D>& packing);

/// The kernel's, m: the mean diameter, or the distance of the points where that is more.
template <int D> double width_to_show(const PackingIn<D>& packing, const GridIn<D>& grid);

/// Fields of a state as pictures show them. `shear_rate`, 1/s: of a cell that is sheared.
template <int D>
CoarseFieldsIn<D> fields_to_show(const PackingIn<D>& packing, double shear_rate, const GridIn<D>& grid);

}  // namespace arenite::fields
