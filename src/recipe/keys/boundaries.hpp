#pragma once
#include "core/parameters.hpp"
#include "grains/dem/stage.hpp"

namespace arenite::recipe {

struct ContainerParameters;
struct Recipe;

/// Of a stage, tables in time that drive it, which sides are open, how boundaries move, what is counted as having
/// passed, and cycles; and what boundaries ask of a stage whose keys have all been read.
void declare_programmes(ParameterVisitor& visitor, dem::Stage& stage, const Recipe& recipe);
void declare_openings(ParameterVisitor& visitor, dem::Stage& stage, const Recipe& recipe);
void declare_cycles(ParameterVisitor& visitor, dem::Stage& stage, const Recipe& recipe);
void require_boundary_loads(ParameterVisitor& visitor, const dem::Stage& stage, const Recipe& recipe);
void require_usable_sides(ParameterVisitor& visitor, const dem::Stage& stage, const ContainerParameters& container);

}  // namespace arenite::recipe
