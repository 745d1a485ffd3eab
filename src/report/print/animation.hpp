#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "core/parameters.hpp"

namespace arenite::report {

/// What grains of an animation can be coloured by, and the unit that its scale is given in.
struct Colouring {
  const char *name, *unit, *sentence = "";
  bool never_negative = false;
};
/// All, the usual one first; `colourings` of python/arenite/figures/motion.py draws them.
const std::vector<Colouring>& colourings();

/// A film of a run's stored states.
struct Animation {
  std::size_t by = 0;  ///< in `colourings`
  bool chains = false;
  std::string stage, map;
  std::string low, high;  ///< of the colour scale, as they are written
  double fps = 10;        ///< states per second
  std::string size, curve;
};
void declare(ParameterVisitor& visitor, Animation& animation);

/// Sides of a picture in pixels.
struct PictureSize {
  int width = 0, height = 0;
};
/// As asked for, or the usual one, which is wider with a curve. Throws InputError for what is no size.
PictureSize size_of(const Animation& animation);

}  // namespace arenite::report
