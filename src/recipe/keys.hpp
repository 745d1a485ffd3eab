#pragma once
#include "core/parameters.hpp"
#include "core/text.hpp"
#include "recipe/film_recipe.hpp"
#include "recipe/recipe.hpp"

namespace arenite::recipe {

using Visitor = ParameterVisitor;

/// Every key of a recipe: its name, unit, range and meaning, and what must hold between keys.
void declare(Visitor& visitor, Recipe& recipe);

// The parts of declare(Visitor&, Recipe&). Where a part's keys must agree with others, it gets the recipe as
// far as it is known by then.
void declare(Visitor& visitor, dem::ContactParameters& contact);
void declare(Visitor& visitor, dem::IntegrationParameters& integration);
void declare(Visitor& visitor, Population& population, const Recipe& recipe);
void declare(Visitor& visitor, Stage& stage, const Recipe& recipe);
void declare_bidisperse(Visitor& visitor, Recipe& recipe);
void declare(Visitor& visitor, Load& load, const Recipe& recipe);
void declare_boundaries(Visitor& visitor, Recipe& recipe);
/// Of a stage, which sides are open, how boundaries move, and what is counted as having passed.
void declare_openings(Visitor& visitor, Stage& stage, const Recipe& recipe);
/// What boundaries ask of a stage whose keys have all been read.
void require_boundary_loads(Visitor& visitor, const Stage& stage, const Recipe& recipe);
/// Of a stage, tables in time that drive it, and cycles of strain.
void declare_programmes(Visitor& visitor, Stage& stage, const Recipe& recipe);
void declare_strain_cycles(Visitor& visitor, Stage& stage, const Recipe& recipe);
/// Of cycles, how many have their states stored.
void declare_store_every(Visitor& visitor, std::optional<std::int64_t>& every);
/// Cement, grid and loads: what comes after loading by discrete elements.
void declare_field(Visitor& visitor, Recipe& recipe);

/// Every key of a film's recipe.
void declare(Visitor& visitor, FilmRecipe& recipe);

}  // namespace arenite::recipe
