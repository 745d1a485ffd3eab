#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "dem/parameters.hpp"
#include "dem/stage.hpp"
#include "model/material.hpp"
#include "packing/population.hpp"

namespace arenite::study {

using packing::Population;
using packing::SizeLaw;

struct Frame {
  double width = 0, height = 0;        ///< m
  double thickness = 0;                ///< m
  bool periodic_x = false, periodic_y = false;
};

struct PackingParameters {
  enum class Method { random, lattice, file };
  Method method = Method::random;
  std::int64_t grains = 0;             ///< total, where populations give ratios
  std::string file;                    ///< CSV of centres, radii, materials
  double solid_fraction = 0.78;        ///< of the random filling; loading stages compact it further
};

/// A glued region: grains whose centre lies inside are in zone `zone`.
struct Region {
  enum class Shape { circle, rectangle };
  Shape shape = Shape::circle;
  double x = 0, y = 0;                 ///< centre, m from the frame's lower left corner
  double radius = 0;                   ///< circle
  double width = 0, height = 0;        ///< rectangle
  std::optional<std::int64_t> count;   ///< the nearest grains to (x, y), that many, instead of a shape
};

using dem::Cycles;
using dem::RestCriterion;
using dem::SideDrive;
using dem::Stage;

/// What a recipe says, checked and in SI. The declaration of every key (name, dimension, range, sentence) is in
/// study/recipe_keys.cpp.
struct Recipe {
  std::string title;
  std::uint64_t seed = 1;
  std::string source_file;             ///< as given; relative paths in the recipe start at its folder
  Materials materials;
  std::vector<Population> populations;
  Frame frame;
  PackingParameters packing;
  dem::ContactParameters contact;
  dem::IntegrationParameters integration;
  std::optional<Region> glued;
  std::vector<Stage> stages;
};

}  // namespace arenite::study
