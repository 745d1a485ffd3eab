#include <gtest/gtest.h>

#include <string>

#include "grains/dem/run_stage.hpp"
#include "grains/texture/texture.hpp"
#include "io/disk/file.hpp"
#include "recipe/recipe.hpp"
#include "support/numbers_of.hpp"
#include "workflow/make_packing.hpp"
#include "workflow/run.hpp"

namespace arenite::verification {
namespace {

constexpr const char* example = ARENITE_SOURCE_DIR "/examples/16-shapes/recipe.toml";

/// The texture of a recipe's last state.
texture::Texture texture_of(const recipe::Recipe& recipe) {
  dem::Engine engine(workflow::make_packing(recipe).snapshots.back().packing, recipe.contact, recipe.integration);
  for (const dem::Stage& stage : recipe.stages) {
    dem::StageRun run = dem::begin_stage(engine, stage);
    while (!run.finished) dem::continue_stage(engine, stage, run);
    EXPECT_TRUE(run.result.converged) << run.result.outcome;
  }
  return texture::measure(packing_of(engine));
}

double number(const texture::Texture& t, const std::string& path) { return test::value_of(t.numbers, path); }

/// Three degrees of freedom a grain: z = 6 at jamming. Solid fraction near 0.89 at this aspect ratio (Schreck, Xu and
/// O'Hern, Soft Matter 6, 2960, 2010).
TEST(ShapePackings, DumbbellsWithoutFrictionAreIsostaticAndDenserThanDisks) {
  const texture::Texture t = texture_of(recipe::read_recipe(example));
  EXPECT_EQ(number(t, "grains"), 200);
  EXPECT_NEAR(number(t, "coordination/without_rattlers"), 6, 0.2);
  EXPECT_NEAR(t.solid_fraction.value, 0.888, 0.01);
  EXPECT_LT(number(t, "coordination/all, neighbours"), number(t, "coordination/all") - 0.1);
  EXPECT_EQ(number(t, "long_axes/grains"), 200);
  EXPECT_LT(number(t, "long_axes/order"), 4 * number(t, "long_axes/noise"));
}

/// Random pentagons: 0.838 +- 0.002 (A. B. Shubin, Rasplavy 2025 no. 1, 10); a hundred of them with rounded corners,
/// and z = 6 as above.
TEST(ShapePackings, PentagonsWithoutFrictionAreIsostaticAndAsDenseAsPublished) {
  const std::string dumbbell = "shape = \"clump\"\nmembers = 2\naspect = 1.4\n";
  std::string text = io::read_file(example);
  for (std::size_t at = text.find(dumbbell); at != std::string::npos; at = text.find(dumbbell))
    text.replace(at, dumbbell.size(), "shape = \"polygon\"\ncorners = 5\n");
  const texture::Texture t = texture_of(
      recipe::parse_recipe(text, "pentagons.toml",
                           {"populations.0.count=50", "populations.1.count=50", "populations.1.diameter=10 mm",
                            "packing.solid_fraction=0.45", "container.width=150 mm",
                            "stages.1.equilibrium.unbalanced=1e-3", "stages.1.equilibrium.kinetic=1e-3"}));
  EXPECT_NEAR(number(t, "coordination/without_rattlers"), 6, 0.4);
  EXPECT_NEAR(t.solid_fraction.value, 0.85, 0.03);
  EXPECT_FALSE(t.numbers.contains("long_axes"));
}

}  // namespace
}  // namespace arenite::verification
