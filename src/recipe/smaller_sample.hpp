#pragma once
#include <cstddef>

#include "recipe/recipe.hpp"

/// A small sample of the same kind as a recipe's, to look at where that is large.
namespace arenite::recipe {

/// Grains that a recipe asks for, before anything is made; 0 where only its file knows.
std::size_t grains_asked(const Recipe& recipe);

/// A recipe of fewer grains in a container that is smaller along x and y, in space along z as along x.
struct SmallerSample {
  Recipe recipe;
  double across = 1, along = 1;  ///< its width and height over those of the recipe's
};

/// With a share of the grains: alike along all axes, but disks never in a container narrower than some grains: a narrow
/// sample is only less high. In space without boundaries, whose faces would stand elsewhere in it. All of it at 1.
SmallerSample smaller_sample(const Recipe& recipe, double share);

}  // namespace arenite::recipe
