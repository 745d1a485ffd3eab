#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "dem/parameters.hpp"
#include "model/material.hpp"

namespace arenite::study {

/// A size law of one population; diameters in m.
struct SizeLaw {
  enum class Kind { fixed, uniform, normal, list };
  Kind kind = Kind::fixed;
  double diameter = 0;                 ///< fixed
  double min = 0, max = 0;             ///< uniform; cut of normal
  double mean = 0, deviation = 0;      ///< normal
  std::vector<double> values;          ///< list: one a grain, or drawn from in turn
};

/// Grains of one material and size law; count, or share of `packing.grains`.
struct Population {
  std::string material;
  std::optional<std::int64_t> count;
  std::optional<double> ratio;         ///< share by number, relative to the other ratios
  SizeLaw size;
};

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
  double solid_fraction = 0.5;         ///< of the random filling, before settling
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

/// When an increment counts as done.
struct RestCriterion {
  double unbalanced = 1e-4;            ///< unbalanced force ratio
  double kinetic = 1e-6;               ///< kinetic over elastic energy
  double mobilisation = -1;            ///< mean |F_t|/F_n below this as well; < 0: not asked
  std::int64_t max_steps = 20'000'000; ///< of one increment; then the stage ends with exit status 3
};

/// What one side does in a stage. A force (or pressure) is reached from its present value in `increments` equal steps.
struct SideDrive {
  enum class Kind { fixed, velocity, force, pressure };
  Kind kind = Kind::fixed;
  double value = 0;                    ///< m/s inward, N, or Pa
};

/// Force cycles on one side after the ramp, e.g. 6-60 kN (T 3.2.1); each half cycle is a ramp to rest.
struct Cycles {
  std::string side;                    ///< "left", "right", "bottom", "top"
  double min = 0, max = 0;             ///< N
  std::int64_t count = 0;
  std::int64_t increments = 5;         ///< a half cycle
};

/// One stage of loading.
struct Stage {
  std::string name;
  bool gravity = false;                ///< 9.81 m/s^2 downwards
  std::array<SideDrive, 4> side;       ///< in the order of model/domain.hpp
  std::int64_t increments = 1;
  std::optional<double> duration;      ///< s; for stages driven by velocity, which do not end at rest
  std::optional<Cycles> cycles;
  RestCriterion rest;
  std::optional<double> friction;      ///< mu during this stage only (e.g. 0 to densify)
  double drag = 0;                     ///< 1/s, during this stage only
  bool glue = false;                   ///< adhesion acts from this stage on
  std::int64_t frames = 1;             ///< states stored for stages with a duration; increments store one each
};

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
