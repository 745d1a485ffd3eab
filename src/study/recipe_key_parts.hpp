#pragma once
#include "core/parameters.hpp"
#include "study/recipe.hpp"

namespace arenite::study {

// The parts of declare(ParameterVisitor&, Recipe&). Where a part's keys must agree with others, it gets the recipe as
// far as it is known by then.
void declare(ParameterVisitor& visitor, dem::ContactParameters& contact);
void declare(ParameterVisitor& visitor, dem::IntegrationParameters& integration);
void declare_materials(ParameterVisitor& visitor, Materials& materials);
void declare(ParameterVisitor& visitor, Population& population, const Recipe& recipe);
void declare(ParameterVisitor& visitor, Stage& stage, const Recipe& recipe);

}  // namespace arenite::study
