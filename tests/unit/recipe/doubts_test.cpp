#include "recipe/doubts.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "unit/recipe/smallest_recipe.hpp"

namespace arenite::recipe {
namespace {

Recipe with_stage(const std::string& stage, const std::string& more = "") {
  return parse_recipe(smallest + more + "[[stages]]\nname = \"test\"\n" + stage, "r.toml");
}
constexpr const char* biaxial =
    "right = { pressure = \"10 kPa\" }\ntop = { velocity = \"1 mm/s\" }\nduration = \"1 s\"\n";

TEST(Doubts, PlatensThatRubAreSaid) {
  const Recipe rubbing = with_stage(biaxial, "[contact]\nfriction = 0.5\n");
  ASSERT_EQ(doubts_of(rubbing).size(), 1u);
  EXPECT_NE(doubts_of(rubbing)[0].find("contact.wall_friction = 0"), std::string::npos);
  EXPECT_EQ(rubbing.notices, doubts_of(rubbing));
  EXPECT_TRUE(doubts_of(with_stage(biaxial, "[contact]\nfriction = 0.5\nwall_friction = 0\n")).empty());
  EXPECT_TRUE(doubts_of(with_stage("top = { pressure = \"10 kPa\" }\n", "[contact]\nfriction = 0.5\n")).empty());
}

TEST(Doubts, StagesThatMayNotEndAreSaid) {
  for (const auto& [stage, key] : {std::pair{"gravity = true\nopen = { right = true }\n", "duration"},
                                   {"top = { pressure = \"0 kPa\" }\n", "stages.test.top"},
                                   {"top = { pressure = \"1 kPa\" }\nsnapshots = 10\n", "stages.test.snapshots"}}) {
    const auto doubts = doubts_of(with_stage(stage));
    ASSERT_EQ(doubts.size(), 1u) << stage;
    EXPECT_NE(doubts[0].find(key), std::string::npos) << doubts[0];
    EXPECT_TRUE(doubts_of(with_stage(std::string(stage) + "duration = \"1 s\"\n")).empty());
  }
}

TEST(Doubts, RoughWallsThatPushTheirGrainsIntoTheNextAreSaid) {
  const std::string lid = "slide = { top = \"1 mm/s\" }\nduration = \"1 s\"\n", rough = "rough = { top = true }\n";
  const auto doubts = doubts_of(with_stage(lid + rough));
  ASSERT_EQ(doubts.size(), 1u);
  EXPECT_NE(doubts[0].find("into the right one; set container.periodic_x = true"), std::string::npos) << doubts[0];
  EXPECT_TRUE(doubts_of(with_stage(lid)).empty());
  Recipe periodic = with_stage(lid + rough);
  periodic.container.periodic[0] = true;
  EXPECT_TRUE(doubts_of(periodic).empty());
}

/// The only doubt of a recipe; empty where there is none or another.
std::string only_doubt(const Recipe& recipe) {
  const auto doubts = doubts_of(recipe);
  return doubts.size() == 1 ? doubts[0] : std::string();
}

TEST(Doubts, IncrementsWithoutEffectAreSaid) {
  const std::string pressed = "top = { pressure = \"1 kPa\" }\n", forced = "top = { force = \"1 kN\" }\n",
                    timed = "duration = \"1 s\"\n", steps = "increments = 5\n";
  EXPECT_NE(only_doubt(with_stage(pressed + steps)).find("stages.test.increments: has no effect"), std::string::npos);
  EXPECT_NE(only_doubt(with_stage(forced + timed + steps)).find("stages.test.increments: has no effect"),
            std::string::npos);
  EXPECT_TRUE(doubts_of(with_stage(forced + steps)).empty());
  EXPECT_EQ(only_doubt(with_stage(pressed + "snapshots = 4\n")).find("increments"), std::string::npos)
      << "of pressures there are none";
  EXPECT_NE(only_doubt(with_stage(forced + "snapshots = 4\n")).find("increments"), std::string::npos);
  const std::string cycled =
      "strain_cycles = { of = \"top\", max = 0.01, rate = \"1 1/s\", count = 3 }\nsnapshots = 4\n";
  EXPECT_NE(only_doubt(with_stage(cycled)).find("store_every"), std::string::npos);
  EXPECT_NE(only_doubt(with_stage(pressed + timed + "equilibrium = { unbalanced = 0.01 }\n"))
                .find("stages.test.equilibrium: does not end"),
            std::string::npos);
}

TEST(Doubts, KeysThatAnotherMakesIdleAreSaid) {
  const std::string stage = "top = { force = \"1 kN\" }\n";
  for (const auto& [more, key] :
       {std::pair{"[packing]\ngrains = 5\n", "packing.grains: "},
        {"[contact]\nrestitution = 0.7\nnormal_damping = \"1 N s/m\"\n", "contact.restitution: "},
        {"[integration]\nsafety = 0.2\ntime_step = \"1 us\"\n", "integration.safety: "},
        {"[membrane]\nlargest_strain = 0.5\n", "membrane: "},
        {"[contact]\nsurface_energy = \"1 kN/mm\"\n", "contact.surface_energy: "},
        {"[contact]\nglued_pairs = [[0, 1]]\n", "contact.glued_pairs: "},
        {"[contact]\neffective_radius = \"sum\"\n", "contact.effective_radius: "},
        {"[contact]\nfriction_cap = \"as_printed\"\n", "contact.friction_cap: "}}) {
    const std::string doubt = only_doubt(with_stage(stage, more));
    EXPECT_TRUE(doubt.starts_with(std::string(key) + "has no effect, because ")) << more << doubt;
  }
  const std::string map = "[map]\nfile = \"m.png\"\nsmoothing = 2\n";
  const std::string load = "[[loads]]\nname = \"tension\"\n";
  EXPECT_TRUE(only_doubt(parse_recipe(map + load, "r.toml")).starts_with("map.smoothing: has no effect"));
  EXPECT_TRUE(doubts_of(parse_recipe(map + "labels = \"watershed\"\n" + load, "r.toml")).empty());
  const std::string elements = "[map]\nfile = \"m.png\"\n" + load + "method = \"elements\"\n";
  EXPECT_TRUE(only_doubt(parse_recipe(elements + "stop_at_voids = true\n", "r.toml"))
                  .starts_with("loads.tension.stop_at_voids: has no effect, because elements have no bonds"));
  const Recipe high =
      parse_recipe(smallest + "[packing]\nsolid_fraction = 0.5\n", "r.toml", {"container.height=300 mm"});
  EXPECT_TRUE(only_doubt(high).starts_with("packing.solid_fraction: has no effect")) << only_doubt(high);
  for (const char* more :
       {"[contact]\nrestitution = 0.7\n", "[integration]\nsafety = 0.2\n", "[packing]\nsolid_fraction = 0.5\n",
        "[contact]\nadhesion = \"geometrical\"\nsurface_energy = \"1 kN/mm\"\nglued_pairs = [[0, 1]]\n"})
    EXPECT_TRUE(doubts_of(with_stage(stage, more)).empty()) << more;
}

TEST(Doubts, ABoundaryFarFromTheBoxIsSaid) {
  const std::string wall = "[[boundaries]]\nname = \"plate\"\npoints = [[\"0 mm\", \"Y\"], [\"100 mm\", \"Y\"]]\n";
  const auto at = [&](const std::string& y, const std::string& stage) {
    std::string text = wall;
    for (std::size_t k; (k = text.find('Y')) != text.npos;) text.replace(k, 1, y);
    return parse_recipe(smallest + text + "[[stages]]\nname = \"test\"\n" + stage, "r.toml",
                        {"container.height=300 mm"});
  };
  EXPECT_NE(only_doubt(at("20 m", "")).find("\"plate\" stands 1.97e+04 mm outside"), std::string::npos);
  EXPECT_TRUE(doubts_of(at("200 mm", "")).empty());
  EXPECT_TRUE(doubts_of(at("-50 mm", "")).empty()) << "beneath an opening";
  EXPECT_TRUE(doubts_of(at("20 m",
                           "duration = \"1 s\"\nboundaries = [{ name = \"plate\", velocity = [\"0 mm/s\", "
                           "\"-1 m/s\"] }]\n"))
                  .empty())
      << "it may come";
}

TEST(Stages, CyclesAreOfForceOrOfPressure) {
  const auto cycles = with_stage(
      "top = { pressure = \"1 kPa\" }\ncycles = { side = \"top\", min_pressure = \"1 kPa\", "
      "max_pressure = \"2 kPa\", count = 3 }\n");
  EXPECT_TRUE(cycles.stages[1].cycles->of_pressure);
  EXPECT_EQ(cycles.stages[1].cycles->max, 2000);
  EXPECT_EQ(parse_recipe(to_toml(cycles), "r.toml"), cycles);
  EXPECT_THROW(
      with_stage(
          "top = { pressure = \"1 kPa\" }\ncycles = { side = \"top\", min = \"1 N\", max = \"2 N\", count = 3 }\n"),
      InputError);
  EXPECT_THROW(
      with_stage("top = { pressure = \"1 kPa\" }\ncycles = { side = \"top\", min = \"1 N\", max_pressure = \"2 kPa\", "
                 "count = 3 }\n"),
      InputError);
}

}  // namespace
}  // namespace arenite::recipe
