#include "recipe/recipe.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/error.hpp"
#include "model/packing.hpp"
#include "unit/recipe/parsed.hpp"
#include "unit/recipe/smallest_recipe.hpp"

namespace arenite::recipe {
namespace {

using Lines = std::vector<std::string>;

TEST(BadRecipe, BareNumberForAQuantityIsAnErrorAtItsLine) {
  EXPECT_EQ(problems(replaced(smallest, "\"350 mm\"", "350")),
            Lines{"r.toml:2:9: container.width: 350 has no unit; write it with its unit, for example \"350 mm\""});
  EXPECT_EQ(problems(replaced(smallest, "350 mm", "350")),
            Lines{"r.toml:2:9: container.width: \"350\" has no unit; write it with its unit, for example \"350 mm\""});
}

TEST(BadRecipe, WrongDimensionNamesBoth) {
  EXPECT_EQ(
      problems(replaced(smallest, "50 kN", "50 mm")),
      Lines{
          "r.toml:13:20: stages.0.bottom.force: \"50 mm\" is a length (m), but a force (N) is needed; write it in kN"});
}

TEST(BadRecipe, UnknownKeyOffersTheNearest) {
  EXPECT_EQ(problems(smallest + "incremets = 3\n"),
            Lines{"r.toml:14:1: stages.0.incremets: unknown key; did you mean increments?"});
  EXPECT_EQ(problems("sed = 1\n" + smallest), Lines{"r.toml:1:1: sed: unknown key; did you mean seed?"});
  EXPECT_EQ(problems(replaced(smallest, "thickness", "colour = 3\nthickness")),
            Lines{"r.toml:3:1: container.colour: unknown key; the keys here are: height, periodic_x, periodic_y, "
                  "thickness, width"});
}

TEST(BadRecipe, UnknownWordOffersTheNearest) {
  const auto found = problems(smallest + "[contact]\nfriction_law = \"cundal_strack\"\n");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].find(
                "r.toml:15:16: contact.friction_law: unknown word \"cundal_strack\"; did you mean \"cundall_strack\"?"),
            0u);
}

TEST(BadRecipe, ValueOutOfRangeNamesTheRange) {
  EXPECT_EQ(problems(replaced(smallest, "16.4 mm", "-16.4 mm")),
            Lines{"r.toml:10:12: populations.0.diameter: \"-16.4 mm\" is out of range; it must be above 0 mm"});
  EXPECT_EQ(problems(replaced(smallest, "count = 10", "count = -1")),
            Lines{"r.toml:9:9: populations.0.count: -1 is out of range; it must be from 0 to 100000000"});
  EXPECT_EQ(problems(smallest + "[contact]\nrestitution = 1.5\n"),
            Lines{"r.toml:15:15: contact.restitution: 1.5 is out of range; it must be above 0, up to 1"});
}

TEST(BadRecipe, NumbersMustBeFinite) {
  EXPECT_EQ(problems(smallest + "[contact]\nfriction = nan\n"),
            Lines{"r.toml:15:12: contact.friction: must be a finite number"});
  EXPECT_EQ(problems(smallest + "[contact]\nfriction = -inf\n"),
            Lines{"r.toml:15:12: contact.friction: must be a finite number"});
  EXPECT_EQ(problems(replaced(smallest, "16.4 mm", "nan mm")),
            Lines{"r.toml:10:12: populations.0.diameter: \"nan mm\" is not a finite number"});
}

TEST(BadRecipe, MissingKeyAndSectionAreNamed) {
  EXPECT_EQ(problems(replaced(smallest, "thickness = \"60 mm\"\n", "")),
            Lines{"r.toml:1:1: container.thickness: is missing; write for example thickness = \"1 mm\""});
  const auto found = problems("title = \"x\"\n");
  ASSERT_EQ(found.size(), 4u);
  EXPECT_EQ(found[0],
            "r.toml:1:1: container: is missing; add the section [container] (the box, or periodic cell, that holds the "
            "grains)");
  EXPECT_NE(found[1].find("materials"), std::string::npos);
  EXPECT_NE(found[2].find("populations"), std::string::npos);
  EXPECT_NE(found[3].find("stages"), std::string::npos);
}

TEST(BadRecipe, PackingThatSpaceDoesNotHaveIsRefusedInOneSentence) {
  const std::string numbers = "density = \"2500 kg/m^3\"\nstiffness = \"1 kN/mm\"\n";
  const std::string rest = "[materials.large]\n" + numbers + "[materials.small]\n" + numbers +
                           "[[stages]]\nname = \"compact\"\ntop = { pressure = \"50 kPa\" }\n";
  const std::string sampled =
      "dimension = 3\n[packing]\nmethod = \"poisson\"\n[container]\nperiodic_z = true\n[bidisperse]\n"
      "large_radius = \"1 mm\"\n";
  EXPECT_EQ(problems(sampled + rest), Lines{});
  EXPECT_EQ(problems(sampled + "maximal = true\n" + rest),
            Lines{"r.toml:6:1: bidisperse: hold_radius and maximal find places on the arcs of circles, in the plane "
                  "alone; leave them out in space and raise trials"});
  EXPECT_EQ(
      problems("dimension = 3\n[packing]\nmethod = \"file\"\nfile = \"a.csv\"\n[container]\nwidth = \"9 mm\"\n"
               "height = \"9 mm\"\ndepth = \"9 mm\"\n" +
               rest),
      Lines{"r.toml:2:1: packing: no packing is read from a file in space; leave that out, or take dimension = 2"});
}

TEST(BadRecipe, WrongKindsOfValueAreRefused) {
  EXPECT_EQ(problems(smallest + "gravity = \"yes\"\n"),
            Lines{"r.toml:14:11: stages.0.gravity: is a text, but must be true or false (without quotes)"});
  EXPECT_EQ(problems(smallest + "increments = 2.5\n"),
            Lines{"r.toml:14:14: stages.0.increments: 2.5 is not a whole number"});
  EXPECT_EQ(problems(replaced(smallest, "\"POM\"", "3")),
            Lines{"r.toml:8:12: populations.0.material: is a number, but must be a text in quotes"});
  EXPECT_EQ(problems(replaced(smallest, "\"16.4 mm\"", "[1]")),
            Lines{"r.toml:10:12: populations.0.diameter: is a list, but must be a number, such as \"1 mm\""});
  EXPECT_EQ(problems("contact = 3\n" + smallest),
            Lines{"r.toml:1:11: contact: is a number, but must be a section [contact]"});
  EXPECT_EQ(problems(replaced(smallest, "[[stages]]", "[stages]"))
                .at(0)
                .find("r.toml:11:1: stages: is a table, but must be sections [[stages]]"),
            0u);
}

TEST(BadRecipe, PopulationOfAnUnknownMaterialOffersTheNearest) {
  EXPECT_EQ(problems(replaced(smallest, "\"POM\"", "\"PON\"")),
            Lines{"r.toml:8:12: populations.0.material: there is no section [materials.PON]; did you mean \"POM\"?"});
}

TEST(BadRecipe, QuantityWithoutItsTagIsOfferedWithIt) {
  const std::string drive = "{ force = \"50 kN\" }";
  EXPECT_EQ(problems(replaced(smallest, drive, "\"50 kN\"")),
            Lines{"r.toml:13:10: stages.0.bottom: write { force = \"50 kN\" }"});
  EXPECT_EQ(problems(replaced(smallest, drive, "\"5 kPa\"")),
            Lines{"r.toml:13:10: stages.0.bottom: write { pressure = \"5 kPa\" }"});
  EXPECT_EQ(problems(replaced(smallest, drive, "\"fixd\"")),
            Lines{"r.toml:13:10: stages.0.bottom: unknown word \"fixd\"; did you mean \"fixed\"?"});
}

TEST(BadRecipe, OfTwoPeriodicEdgesOnlyOnePresses) {
  const auto periodic = replaced(smallest, "thickness", "periodic_y = true\nthickness");
  EXPECT_EQ(problems(periodic), Lines{});
  EXPECT_EQ(problems(periodic + "top = { pressure = \"5 kPa\" }\n"),
            Lines{"r.toml:15:7: stages.0.top: of the two periodic edges bottom and top one is under pressure and the "
                  "other fixed; leave bottom = \"fixed\""});
  EXPECT_EQ(problems(periodic + "top = { velocity = \"1 mm/s\" }\nduration = \"1 s\"\n").size(), 1u);
  EXPECT_EQ(problems(smallest + "top = { pressure = \"5 kPa\" }\n"), Lines{})
      << "two walls may press on a sample between them";
}

TEST(BadRecipe, GravityNeedsAFloor) {
  EXPECT_EQ(problems(replaced(smallest, "thickness", "periodic_y = true\nthickness") + "gravity = true\n"),
            Lines{"r.toml:15:11: stages.0.gravity: grains would fall for ever through periodic sides; set "
                  "container.periodic_y = false"});
}

TEST(BadRecipe, CyclesNeedAKnownSideUnderForce) {
  const std::string cycles = "cycles = { side = \"botom\", min = \"6 kN\", max = \"60 kN\", count = 3 }\n";
  EXPECT_EQ(problems(smallest + cycles)
                .at(0)
                .find("r.toml:14:19: stages.0.cycles.side: unknown word \"botom\"; did you mean \"bottom\"?"),
            0u);
  const auto not_driven = problems(smallest + replaced(cycles, "botom", "left"));
  EXPECT_EQ(not_driven, Lines{"r.toml:14:10: stages.0.cycles: cycles need a side under force; write left = { force = "
                              "\"...\" } in this stage"});
  EXPECT_EQ(problems(smallest + replaced(replaced(cycles, "botom", "bottom"), "60 kN", "6 kN")),
            Lines{"r.toml:14:49: stages.0.cycles.max: must be above min"});
}

TEST(BadRecipe, StageNamesDifferAndAreFileNames) {
  EXPECT_EQ(problems(smallest + "[[stages]]\nname = \"load\"\n").back(),
            "r.toml:15:8: stages.1.name: another stage is called \"load\"; names must differ");
  EXPECT_EQ(problems(replaced(smallest, "\"load\"", "\"../load\"")),
            Lines{"r.toml:12:8: stages.0.name: must be made of letters, digits, _ and -"});
}

TEST(BadRecipe, MovingSideNeedsADuration) {
  EXPECT_EQ(problems(replaced(smallest, "force = \"50 kN\"", "velocity = \"1 mm/s\"")).size(), 1u);
  EXPECT_TRUE(
      problems(replaced(smallest, "force = \"50 kN\"", "velocity = \"1 mm/s\"") + "duration = \"1 s\"\n").empty());
}

TEST(BadRecipe, CountAndRatioExcludeEachOther) {
  EXPECT_EQ(problems(replaced(smallest, "count = 10", "count = 10\nratio = 1")),
            Lines{"r.toml:10:9: populations.0.ratio: give either count or ratio"});
  EXPECT_EQ(problems(replaced(smallest, "count = 10\n", "")),
            Lines{"r.toml:7:1: packing: how many grains there are is missing; write packing.grains, or a count in "
                  "each population"});
  EXPECT_TRUE(problems(replaced(smallest, "count = 10\n", "") + "[packing]\ngrains = 100\n").empty());
  EXPECT_EQ(problems(replaced(smallest, "count = 10", "ratio = 1")).size(), 1u);
  EXPECT_TRUE(problems(replaced(smallest, "count = 10", "ratio = 1") + "[packing]\ngrains = 100\n").empty());
}

TEST(BadRecipe, GrainWiderThanTheContainerIsRefused) {
  EXPECT_EQ(
      problems(replaced(smallest, "16.4 mm", "16.4 m")),
      Lines{"r.toml:10:12: populations.0.diameter: the largest grain (16400 mm) is wider than the container (350 mm)"});
}

TEST(BadRecipe, KeyOfAnotherChoiceSaysWhenItExists) {
  EXPECT_EQ(
      problems(smallest + "[packing]\nfile = \"grains.csv\"\n"),
      Lines{"r.toml:15:1: packing.file: this key is only valid with method = \"file\"; leave it out or change that"});
}

TEST(BadRecipe, GlueNeedsAnAdhesion) {
  EXPECT_EQ(problems(smallest + "glue = true\n").at(0).find("r.toml:14:8: stages.0.glue: no adhesion is defined"), 0u);
  EXPECT_EQ(problems(smallest + "[contact]\nadhesion = \"geometrical\"\n").at(0),
            "r.toml:15:12: contact.surface_energy: must be above 0 kN/mm where adhesion acts");
}

TEST(BadRecipe, BondsNeedALawAndItsStrengths) {
  EXPECT_EQ(problems(smallest + "bond = true\n").at(0).find("r.toml:14:8: stages.0.bond: no bonds are defined"), 0u);
  const auto missing = problems(smallest + "bond = true\n[contact]\nbonds = \"parallel\"\n");
  ASSERT_EQ(missing.size(), 3u);
  EXPECT_NE(missing.at(0).find("contact.bond_modulus"), std::string::npos);
  const std::string whole =
      "[contact]\nbonds = \"parallel\"\nbond_modulus = \"1 GPa\"\nbond_tensile_strength = \"1 MPa\"\nbond_cohesion = "
      "\"1 MPa\"\n";
  EXPECT_TRUE(problems(smallest + "bond = true\n" + whole).empty());
}

TEST(BadRecipe, AllProblemsComeInOnePassInTheOrderOfTheText) {
  std::string text = replaced(smallest, "\"350 mm\"", "350");
  text = replaced(text, "kg/m^3", "kg/m^2");
  text = replaced(text, "\"16.4 mm\"", "\"0 mm\"");
  text = replaced(text, "\"load\"", "\"a b\"");
  const auto found = problems(text + "frixion = 3\n");
  ASSERT_EQ(found.size(), 5u);
  EXPECT_EQ(found[0].find("r.toml:2:9"), 0u);
  EXPECT_EQ(found[1].find("r.toml:5:11"), 0u);
  EXPECT_EQ(found[2].find("r.toml:10:12"), 0u);
  EXPECT_EQ(found[3].find("r.toml:12:8"), 0u);
  EXPECT_EQ(found[4], "r.toml:14:1: stages.0.frixion: unknown key; did you mean friction?");
}

TEST(BadRecipe, WhatIsNotTomlIsOneSentenceWithItsPlace) {
  EXPECT_EQ(
      problems("a = 1\na = 2\n"),
      Lines{"r.toml:2:5: this is not TOML; the key-value pair cannot be read: cannot redefine existing integer 'a'"});
  EXPECT_EQ(problems("a b\n"),
            Lines{"r.toml:1:3: this is not TOML; the key-value pair cannot be read: expected '=', saw 'b'"});
  EXPECT_EQ(problems("").at(0).find("r.toml: the recipe is empty;"), 0u);
  EXPECT_EQ(problems(" \r\n\t").at(0).find("r.toml: the recipe is empty;"), 0u);
}

TEST(BadRecipe, KeysOfEndlessDepthAreRefusedBeforeTheyAreBuilt) {
  std::string key = "a";
  for (int i = 0; i < 400'000; ++i) key += ".a";
  EXPECT_EQ(problems("x = 1\n" + key + " = 1\n"),
            Lines{"r.toml:2: no recipe key has that many parts; check the dots in this line"});
  EXPECT_EQ(problems("x = 1\n[" + key + "]\n").size(), 1u);
  EXPECT_EQ(problems("a = " + std::string(400'000, '[')).size(), 1u);
  EXPECT_TRUE(
      problems("title = \"" + std::string(100, '.') + "\" # " + std::string(100, '.') + "\n" + smallest).empty());
}

TEST(BadRecipe, OtherScriptsStayWithinQuotes) {
  EXPECT_EQ(problems("title = \"Körner\"\n\xcc\xaa\n").at(0).find("r.toml:2:1: this is not TOML;"), 0u);
  EXPECT_EQ(problems("title = \xc2\xa7\n").at(0).find("r.toml:1:9: this is not TOML;"), 0u);
  EXPECT_EQ(parsed("title = \"\"\"ä \\\n §\"\"\" # ß\n" + smallest).title, "ä §");
}

}  // namespace
}  // namespace arenite::recipe
