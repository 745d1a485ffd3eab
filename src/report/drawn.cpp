#include "report/drawn.hpp"

#include <string>
#include <string_view>

#include "core/mapped.hpp"
#include "model/colour_scale.hpp"
#include "model/domain.hpp"
#include "model/kinds.hpp"
#include "report/colour_ends.hpp"
#include "statistics/written.hpp"

namespace arenite::report {
namespace {

template <class Names> Numbers names_of(const Names& names) {
  return mapped(names, [](std::string_view name) { return std::string(name); });
}

Numbers kinds_of_nodes() {
  Numbers list = Numbers::list();
  for (const NodeKindWords& kind : node_kinds)
    list.push_back({{"id", std::string(kind.id)}, {"one", std::string(kind.one)}, {"many", std::string(kind.many)}});
  return list;
}

}  // namespace

Numbers drawn() {
  return {
      {"kinds", kinds_of_nodes()},
      {"cracks", names_of(crack_types)},
      {"breaks", names_of(bond_breaks)},
      {"sides", names_of(side_names)},
      // Width of a contact force over the radius of a mean grain: at the mean force, and at most.
      {"chain", {{"width", 0.16}, {"widest", 1.1}}},
      // A crack between two grains: half its length over the smaller radius, short of the rims so that cracks of
      // neighbouring bonds do not run into each other; and over the sum of the radii how far apart its grains are at
      // most: beyond it there are two pieces, and no crack to be seen.
      {"crack", {{"half", 0.9}, {"farthest", 1.5}}},
      // Colours of values about a number that stands in the middle of their scale, and of values from their least on.
      {"colours",
       {{"centred", std::string(word_of(ColourScale::diverging))},
        {"one_sided", std::string(word_of(ColourScale::stress))}}},
      // Over the mean, at the end of a scale: nodes scatter less than grains.
      {"most_stress", {{"grains", 3}, {"nodes", 2}}},
      // The share of the values that lies beyond either end of a scale, where its reader chooses no other.
      {"beyond", {{"nodes", nodes_beyond}, {"pixels", pixels_beyond}, {"cells", cells_beyond}}},
      {"look", {{"azimuth", 35}, {"elevation", 25}}},
      // The way to the light: to the right of the picture, up in it, and towards the viewer; of length 1.
      {"light", {0.2507, 0.6217, 0.742}},
      {"units", statistics::prefixed_units()},
      {"cyclic", {"#2f6fb7", "#7a5fc0", "#b5549a", "#cf5148", "#d98a1f", "#a3a52e", "#4a9f63", "#1f919e", "#2f6fb7"}}};
}

}  // namespace arenite::report
