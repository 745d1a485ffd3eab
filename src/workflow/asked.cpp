#include "workflow/asked.hpp"

#include <cmath>
#include <utility>

#include "grains/dem/programme.hpp"
#include "grains/dem/run_stage.hpp"
#include "grains/fields/driven.hpp"
#include "grains/fields/laboratory/triaxial.hpp"
#include "grains/fields/loading_axis.hpp"
#include "grains/fields/stage_numbers.hpp"
#include "grains/packing/population.hpp"
#include "grains/texture/texture.hpp"

namespace arenite::workflow {
namespace {

texture::Pull pull_of(const dem::ContactParameters& contact) {
  if (contact.adheres()) return texture::Pull::adhesion;
  return contact.attractive_dashpot ? texture::Pull::dashpots : texture::Pull::measured;
}

int cycled_side(const dem::Stage& stage) {
  if (stage.strain_cycles && stage.strain_cycles->of != dem::StrainCycles::shear) return stage.strain_cycles->of;
  return stage.cycles ? stage.cycles->side : -1;
}

void note_axis(Asked& asked, const StageResult&, const dem::Stage& stage) {
  if (!std::isfinite(asked.load_axis)) asked.load_axis = fields::loading_axis(stage).value_or(statistics::unknown);
}
void note_axis(Asked& asked, const SphereResult&, const dem::Stage& stage) {
  const Vec3 direction = fields::loading_direction(stage).value_or(Vec3{});
  if (!std::isfinite(asked.load_axis)) asked.load_direction = {direction.x, direction.y, direction.z};
}

template <int D> void note_stage(Asked& asked, const StageResultIn<D>& made, const dem::Stage& stage) {
  asked.friction = stage.friction.value_or(asked.friction);
  asked.gravity = dem::gravity_at(stage, fields::length_of(made, stage));
  asked.slide = stage.slide;
  note_axis(asked, made, stage);
  asked.cycled = cycled_side(stage);
  asked.closes = fields::closing_axis(stage);
  asked.in_motion = fields::ends_in_motion(stage);
}

/// The curve of the recipe's size laws, which belongs to the packing.
void note_sizes(Asked& asked, const recipe::Recipe& recipe) {
  if (recipe.populations.empty() || recipe.dimension == 3) return;  // the curve is one of cylinders
  auto curve = packing::asked_size_curve(recipe.populations, recipe.materials, recipe.packing.grains);
  asked.diameter = std::move(curve.diameter);
  asked.passing = std::move(curve.passing);
}

}  // namespace

template <int D>
void note_asked(StageResultIn<D>& made, const recipe::Recipe& recipe, std::size_t place,
                const PackingIn<D>* loaded_before) {
  Asked& asked = made.asked;
  asked = {};
  asked.known = true;
  asked.friction = recipe.contact.friction;
  asked.pull = static_cast<int>(pull_of(recipe.contact));
  asked.measure = recipe.measure;
  if (recipe.measure && recipe.measure->load_axis) asked.load_axis = *recipe.measure->load_axis;
  const dem::EquilibriumCriterion criterion =
      place > 0 ? recipe.stages[place - 1].equilibrium : dem::EquilibriumCriterion{};
  asked.in_equilibrium =
      made.converged && !made.snapshots.empty() && dem::is_at_rest(made.snapshots.back().equilibrium, criterion);
  if (place == 0) return note_sizes(asked, recipe);
  note_stage(asked, made, recipe.stages[place - 1]);
  if (loaded_before) asked.box = loaded_before->domain.extents();
  fields::add_driven(made, recipe.stages[place - 1]);
}

template void note_asked(StageResult&, const recipe::Recipe&, std::size_t, const Packing*);
template void note_asked(SphereResult&, const recipe::Recipe&, std::size_t, const PackingIn<3>*);

}  // namespace arenite::workflow
