#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "core/parameters.hpp"
#include "solid/cement/cement.hpp"
#include "solid/grid/cavities.hpp"

/// What follows the last stage of grains: the matrix between them, and the grid that both are brought to.
namespace arenite::recipe {

/// The nodes that the cemented packing is brought to, and the rules of its pores.
struct GridSection {
  static constexpr std::int64_t usual_nodes = 1024, usual_in_space = 128;
  std::int64_t nodes = usual_nodes;  ///< a side
  /// The usual number of the plane is beyond what most machines hold in space, and stands for that of space.
  std::int64_t nodes_in(int dimension) const { return dimension == 3 && nodes == usual_nodes ? usual_in_space : nodes; }
  std::optional<double> crop;  ///< side of the square, m; if not given, 25.6 mean large radii, or what fits
  grid::CavityRules cavities;
  bool operator==(const GridSection&) const = default;
};

/// Of the matrix between the grains of the plane (2) or between spheres (3).
void declare(ParameterVisitor& visitor, cement::CementParameters& law, int dimension);
void declare(ParameterVisitor& visitor, GridSection& grid);

std::vector<Word> words(cement::CementParameters::Kind);
std::vector<Word> words(grid::Cavity);

}  // namespace arenite::recipe
