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
  std::int64_t nodes = 1024;   ///< a side, and
  std::int64_t voxels = 128;   ///< in space, where 1024 are beyond what most machines hold: both "nodes"
  std::optional<double> crop;  ///< side of the square, m; if not given, 25.6 mean large radii, or what fits
  grid::CavityRules cavities;
  bool operator==(const GridSection&) const = default;
};

/// Of the matrix between the grains of the plane (2) or between spheres (3).
void declare(ParameterVisitor& visitor, cement::CementParameters& law, int dimension);
void declare(ParameterVisitor& visitor, GridSection& grid, int dimension = 2);

std::vector<Word> words(cement::CementParameters::Kind);
std::vector<Word> words(grid::Cavity);

}  // namespace arenite::recipe
