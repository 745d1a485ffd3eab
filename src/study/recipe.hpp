#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "dem/parameters.hpp"
#include "dem/stage.hpp"
#include "model/material.hpp"
#include "packing/population.hpp"
#include "packing/region.hpp"

namespace arenite::study {

using packing::Population;
using packing::Region;
using packing::SizeLaw;

struct FrameParameters {
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
  FrameParameters frame;
  PackingParameters packing;
  dem::ContactParameters contact;
  dem::IntegrationParameters integration;
  std::optional<Region> glued;
  std::vector<Stage> stages;
};

}  // namespace arenite::study
