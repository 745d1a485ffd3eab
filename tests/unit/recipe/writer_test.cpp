#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <fstream>
#include <span>
#include <sstream>
#include <string>

#include "core/error.hpp"
#include "model/packing.hpp"
#include "recipe/doubts.hpp"
#include "recipe/recipe.hpp"

namespace arenite::recipe {
namespace {

/// A positive double of many digits, in the given decade.
double any_number(double scale) { return scale * (1 + *rc::gen::inRange<int>(0, 1'000'000'000) * 1e-9 / 3); }

template <class Family, class... Law> Family any_law(Law... law) { return *rc::gen::element<Family>(law...); }

template <class Enum> Enum any_of(int count) { return static_cast<Enum>(*rc::gen::inRange(0, count)); }

template <class T> std::optional<T> maybe(T value) {
  return *rc::gen::arbitrary<bool>() ? std::optional<T>(value) : std::nullopt;
}

SizeLaw any_size() {
  const double d = any_number(1e-3);
  return any_law<SizeLaw>(packing::FixedSize{d}, packing::UniformSizes{d, 2 * d},
                          packing::NormalSizes{{d, 2 * d}, 1.5 * d, d / 7}, packing::SizeList{{d, d / 3, 2 * d}});
}

Stage any_stage(int index, bool has_adhesion) {
  Stage stage;
  stage.name = "stage-" + std::to_string(index);
  stage.gravity = *rc::gen::arbitrary<bool>();
  for (auto& side : std::span(stage.side).first<sides>()) {
    side.kind = any_of<SideDrive::Kind>(4);
    if (side.kind != SideDrive::Kind::fixed) side.value = any_number(1e2);
  }
  stage.increments = *rc::gen::inRange(1, 100);
  stage.duration = any_number(1);
  stage.snapshots = *rc::gen::inRange(1, 100);
  stage.friction = maybe(any_number(0.1));
  stage.drag = any_number(1);
  stage.critical_drag = any_number(1);
  stage.mass_scaling = stage.gravity ? dem::MassScaling::none : any_of<dem::MassScaling>(2);
  stage.inertial_number = any_number(1e-2);
  stage.glue = has_adhesion && *rc::gen::arbitrary<bool>();
  if (stage.side[bottom].kind == SideDrive::Kind::force)
    stage.cycles = maybe(Cycles{bottom, any_number(1), any_number(10), 3, 7, {}});
  stage.equilibrium = {any_number(1e-5),        any_number(1e-7),        any_number(1e-3),
                       maybe(any_number(1e-2)), maybe(any_number(1e-2)), 1'000'000};
  return stage;
}

cement::CementParameters any_cement() {
  using Kind = cement::CementParameters::Kind;
  cement::CementParameters cement;
  cement.gap = maybe(any_number(1e-4));
  cement.kind = any_of<Kind>(5);
  const bool is_free = cement.kind != Kind::none && cement.kind != Kind::full;
  if (is_free) cement.saturation = maybe(any_number(0.3));
  if (cement.kind == Kind::bridges) cement.full_width = *rc::gen::arbitrary<bool>();
  if (cement.saturation) return cement;
  if (cement.kind == Kind::bridges) cement.width = any_number(0.2);
  if (cement.kind == Kind::coating) cement.thickness = any_number(1e-4);
  if (cement.kind == Kind::menisci) cement.volume = any_number(1e-8);
  return cement;
}

GridSection any_grid() {
  return {*rc::gen::inRange(7, 4000),
          GridSection{}.voxels,
          maybe(any_number(0.02)),
          {*rc::gen::arbitrary<bool>(), *rc::gen::inRange(1, 9), *rc::gen::arbitrary<bool>()}};
}

Load any_load(int index) {
  Load load;
  load.name = "load-" + std::to_string(index);
  load.axis = any_of<Load::Axis>(2);
  load.tolerance = any_number(1e-7);
  load.stiffness = {any_number(1e9), maybe(any_number(1e9)), maybe(any_number(1e9)), *rc::gen::arbitrary<bool>()};
  load.stop_at_voids = *rc::gen::arbitrary<bool>();
  load.statistics.clamp_rows = *rc::gen::inRange(0, 9);
  load.statistics.leave_out_surface = *rc::gen::arbitrary<bool>();
  load.statistics.leave_out_unloaded = *rc::gen::arbitrary<bool>();
  load.statistics.mean_over_area = *rc::gen::arbitrary<bool>();
  load.failure = *rc::gen::arbitrary<bool>();
  if (load.failure) {
    load.max_strain = any_number(0.1);
    load.end_stress = any_number(0.1);
    load.band = any_number(0.1);
    load.cracks_stay_open = *rc::gen::arbitrary<bool>();
    load.toughness = {any_number(1e5), maybe(any_number(1e5)), maybe(any_number(1e5))};
    load.strength = {maybe(any_number(1e6)), maybe(any_number(1e6)), maybe(any_number(1e6))};
    return load;
  }
  load.loading = any_of<peridynamics::Loading>(3);
  if (load.loading != peridynamics::Loading::shear) load.lower = any_of<peridynamics::LowerEdge>(2);
  load.strain = any_number(1e-3);
  load.method = any_of<LoadMethod>(4);
  load.exact_stretch = *rc::gen::arbitrary<bool>();
  load.moduli = *rc::gen::arbitrary<bool>();
  load.max_iterations = *rc::gen::inRange(0, 1000);
  return load;
}

/// Two size classes instead of populations.
void sample_two_classes(Recipe& recipe) {
  recipe.packing = {};
  recipe.packing.method = PackingParameters::Method::poisson;
  recipe.container.width = recipe.container.height = 0;
  recipe.populations.clear();
  recipe.bidisperse =
      BidisperseSection{{any_number(1e-3), any_number(1), any_number(1), any_number(0.1), any_number(0.5),
                         *rc::gen::arbitrary<bool>(), *rc::gen::arbitrary<bool>(), any_number(100),
                         *rc::gen::inRange(1, 100), *rc::gen::arbitrary<bool>(), any_number(0.01)},
                        "B c",
                        "A"};
}

Recipe any_recipe() {
  Recipe recipe;
  recipe.source_file = "r.toml";
  recipe.title =
      *rc::gen::element<std::string>("", "plain", "with \"quotes\" and \\", "Körner, µ", "tab\there\nand line");
  recipe.seed = *rc::gen::inRange<std::uint64_t>(0, std::uint64_t{1} << 62);
  recipe.container = {any_number(0.3), maybe(any_number(0.3)).value_or(0), any_number(0.06), false, {}};
  recipe.materials = {{"A", any_number(1e3), any_number(1e6), any_number(1e-8)},
                      {"B c", any_number(1e3), any_number(1e6), 0}};
  for (Material& m : recipe.materials) m.youngs_modulus = any_number(1e9), m.poisson = 0.25;
  recipe.packing.grains = 1000;
  recipe.packing.solid_fraction = any_number(0.5);
  for (const char* material : {"A", "B c"}) recipe.populations.push_back({material, {}, any_number(1), any_size(), {}});
  auto& contact = recipe.contact;
  contact.normal = any_law<dem::NormalLaw>(dem::Linear{}, dem::Hertz{}, dem::HertzMindlin{});
  contact.stiffness_rule = any_of<dem::StiffnessRule>(2);
  contact.wall_stiffness = any_of<dem::WallStiffness>(3);
  contact.restitution = any_number(0.1);
  contact.normal_damping = maybe(any_number(10));
  contact.attractive_dashpot = *rc::gen::arbitrary<bool>();
  contact.friction_law = any_law<dem::FrictionLaw>(dem::NoFriction{}, dem::RegularisedCoulomb{}, dem::CundallStrack{});
  contact.wall_friction = maybe(any_number(0.1));
  contact.sliding_viscosity = maybe(any_number(10));
  contact.arms = any_of<dem::Arms>(2);
  contact.adhesion = any_law<dem::Adhesion>(dem::NoAdhesion{}, dem::GeometricalAdhesion{}, dem::BreakingAdhesion{});
  contact.surface_energy = any_number(1e5);
  contact.effective_radius = any_of<dem::EffectiveRadius>(3);
  contact.friction_cap = any_of<dem::FrictionCap>(2);
  if (*rc::gen::arbitrary<bool>()) contact.glued_pairs = {{0, 1}, {7, 3}};
  recipe.integration.integrator = any_of<dem::IntegratorKind>(3);
  recipe.integration.time_step = maybe(any_number(1e-7));
  recipe.integration.rotations = *rc::gen::arbitrary<bool>();
  recipe.integration.kernel = *rc::gen::element<std::string>("auto", "portable", "avx2", "avx512");
  const bool has_adhesion = contact.adheres();
  if (has_adhesion)
    recipe.glued = maybe(Region{Region::Shape::rectangle, {0.1, 0.1}, 0, any_number(0.01), any_number(0.01), {}});
  for (int i = 0; i < *rc::gen::inRange(1, 4); ++i) recipe.stages.push_back(any_stage(i, has_adhesion));
  if (*rc::gen::arbitrary<bool>()) sample_two_classes(recipe);
  recipe.cement = maybe(any_cement());
  recipe.grid = maybe(any_grid());
  for (int i = 0; i < *rc::gen::inRange(0, 3); ++i) recipe.loads.push_back(any_load(i));
  return recipe;
}

TEST(ResolvedRecipe, ReadsBackAsTheSameRecipe) {
  EXPECT_TRUE(rc::check("parse(to_toml(r)) == r", [] {
    Recipe recipe = any_recipe();
    recipe.notices = doubts_of(recipe);
    const std::string text = to_toml(recipe);
    RC_LOG(text);
    const Recipe back = parse_recipe(text, "r.toml");
    RC_ASSERT(back == recipe);
    RC_ASSERT(to_toml(back) == text);
  }));
}

TEST(ResolvedRecipe, CommentedRecipeSaysTheSame) {
  EXPECT_TRUE(rc::check("parse(to_commented_toml(r)) == r", [] {
    Recipe recipe = any_recipe();
    recipe.notices = doubts_of(recipe);
    const std::string text = to_commented_toml(recipe);
    RC_LOG(text);
    RC_ASSERT(parse_recipe(text, "r.toml") == recipe);
  }));
}

TEST(ResolvedRecipe, IsCompleteAndCarriesUnits) {
  const std::string text = to_toml(recipe_templates().front().make());
  for (const char* line :
       {"width = \"350 mm\"", "stiffness = \"27.35 kN/mm\"", "diameter = \"16.4 mm\"", "restitution = 0.5",
        "integrator = \"velocity_verlet\"", "bottom = { force = \"50 kN\" }", "top = \"fixed\""}) {
    EXPECT_NE(text.find(std::string("\n") + line + "\n"), std::string::npos) << line;
  }
}

TEST(ResolvedRecipe, KernelThatDoesNotExistIsRefused) {
  Recipe recipe = recipe_templates().front().make();
  recipe.integration.kernel = "avx1024";
  EXPECT_THROW(to_toml(recipe), InputError);
}

TEST(RecipeTemplate, EveryTemplateIsAValidRecipeAsPrinted) {
  for (const auto& each : recipe_templates()) {
    Recipe expected = each.make();
    expected.source_file = "t.toml";
    EXPECT_EQ(parse_recipe(to_commented_toml(expected), "t.toml"), expected) << each.name;
    EXPECT_EQ(parse_recipe(to_toml(expected), "t.toml"), expected) << each.name;
  }
}

TEST(RecipeTemplate, CommentedDefaultsAreTheDefaults) {
  std::istringstream lines(to_commented_toml(recipe_templates().front().make()));
  std::string uncommented;
  int defaults = 0;
  bool section_is_absent = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty()) section_is_absent = false;
    section_is_absent = section_is_absent || line.starts_with("# [");
    const bool is_default = !section_is_absent && line.starts_with("# ") && line.find(" = ") != std::string::npos &&
                            line.find("...") == std::string::npos && line.find(" # ") != std::string::npos;
    defaults += is_default ? 1 : 0;
    uncommented += (is_default ? line.substr(2) : line) + "\n";
  }
  EXPECT_GT(defaults, 15);
  Recipe expected = recipe_templates().front().make();
  expected.source_file = "t.toml";
  EXPECT_EQ(parse_recipe(uncommented, "t.toml"), expected);
}

TEST(KeyReference, PageInTheDocsIsCurrent) {
  std::ifstream in(ARENITE_SOURCE_DIR "/docs/recipe.md", std::ios::binary);
  std::ostringstream page;
  page << in.rdbuf();
  EXPECT_EQ(page.str(), key_reference()) << "write it anew: build/arenite man --keys > docs/recipe.md";
}

}  // namespace
}  // namespace arenite::recipe
