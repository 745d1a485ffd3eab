#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "core/parameters.hpp"

namespace arenite::report {

/// What grains of an animation can be coloured by, and the unit that its scale is given in.
struct Colouring {
  const char *name, *unit, *sentence = "";
};
/// All, the usual one first; `colourings` of python/arenite/figures/motion.py draws them.
const std::vector<Colouring>& colourings();

/// A film of a run's stored states.
struct Animation {
  std::size_t by = 0;  ///< in `colourings`
  bool chains = false;
  std::string stage, map;
  double fps = 10;  ///< states per second
};
void declare(ParameterVisitor& visitor, Animation& animation);

}  // namespace arenite::report
