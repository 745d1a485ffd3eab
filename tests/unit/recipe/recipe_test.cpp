#include "recipe/recipe.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "model/packing.hpp"
#include "unit/recipe/smallest_recipe.hpp"

namespace arenite::recipe {
namespace {

Recipe parsed(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return parse_recipe(text, "r.toml", overrides);
}

/// Every problem as main prints it, in order.
std::vector<std::string> problems(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    parsed(text, overrides);
  } catch (const InputError& error) {
    std::vector<std::string> lines;
    for (const auto& problem : error.problems()) lines.push_back(to_string(problem));
    return lines;
  }
  return {};
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), by);
}

using Lines = std::vector<std::string>;

TEST(Recipe, SmallestRecipeGivesSiValuesAndDefaults) {
  const Recipe recipe = parsed(smallest);
  EXPECT_EQ(recipe.container.width, 0.35);
  EXPECT_EQ(recipe.container.thickness, 0.06);
  ASSERT_EQ(recipe.materials.size(), 1u);
  EXPECT_EQ(recipe.materials[0].name, "POM");
  EXPECT_EQ(recipe.materials[0].stiffness, 27.35e6);
  EXPECT_EQ(recipe.populations.at(0).size, SizeLaw(packing::FixedSize{0.0164}));
  EXPECT_EQ(recipe.stages.at(0).side[bottom], (SideDrive{SideDrive::Kind::force, 50e3}));
  EXPECT_EQ(recipe.stages[0].side[top], SideDrive{});
  EXPECT_EQ(recipe.stages[0].equilibrium, EquilibriumCriterion{});
  EXPECT_EQ(recipe.contact, dem::ContactParameters{});
  EXPECT_EQ(recipe.contact.friction_law, dem::CundallStrack{});  // the field's: friction that holds at rest,
  EXPECT_FALSE(recipe.contact.attractive_dashpot);               // contacts that do not pull,
  EXPECT_EQ(recipe.contact.restitution, 0.5);                    // moderate damping
  EXPECT_EQ(recipe.seed, 1u);
}

TEST(Recipe, EveryKindOfValueIsUnderstood) {
  const Recipe recipe = parsed(R"(
title = "all kinds"
seed = 42
[container]
width = "0.35 m"
height = "35 cm"
thickness = "60 mm"
periodic_x = true
[materials.A]
density = "1.41 g/cm^3"
stiffness = "27.35 kN/mm"
thermoelastic_factor = "0.0150 K/MPa"
[materials."B 2"]
density = "950 kg/m^3"
stiffness = "6430 N/mm"
[[populations]]
material = "A"
ratio = 1
size = { law = "uniform", min = "8 mm", max = "16 mm" }
[[populations]]
material = "B 2"
ratio = 2.5
size = { law = "normal", mean = "12 mm", deviation = "2 mm", min = "8 mm", max = "16 mm" }
[[populations]]
material = "A"
count = 3
size = { law = "list", values = ["1 mm", "2 mm", "4 mm"] }
[packing]
method = "lattice"
grains = 1e3
[contact]
friction_law = "cundall_strack"
restitution = "20 %"
wall_friction = 0
adhesion = "geometrical_breaking"
surface_energy = "1.06 kN/mm"
glued_pairs = [[0, 1], [4, 2]]
[integration]
integrator = "gear5"
time_step = "0.5 us"
kernel = "portable"
[glued]
x = "175 mm"
y = "100 mm"
radius = "20 mm"
[[stages]]
name = "shear"
top = { velocity = "-1 mm/s" }
duration = "2 s"
snapshots = 20
drag = "3 1/s"
[[stages]]
name = "load"
gravity = true
glue = true
bottom = { force = "6 kN" }
top = { pressure = "10 kPa" }
cycles = { side = "bottom", min = "6 kN", max = "60 kN", count = 3 }
equilibrium = { unbalanced = 1e-3, mobilisation = 0.01, max_steps = 1e6 }
friction = 0
)");
  EXPECT_EQ(recipe.seed, 42u);
  EXPECT_EQ(recipe.container.height, 0.35);
  EXPECT_TRUE(recipe.container.periodic[0]);
  EXPECT_FALSE(recipe.container.periodic[1]);
  EXPECT_EQ(recipe.materials.at(1).name, "B 2");
  EXPECT_EQ(recipe.materials[1].stiffness, 6.43e6);
  EXPECT_EQ(recipe.materials[0].thermoelastic_factor, 0.015e-6);
  EXPECT_TRUE(std::holds_alternative<packing::UniformSizes>(recipe.populations.at(0).size));
  EXPECT_EQ(std::get<packing::NormalSizes>(recipe.populations[1].size).deviation, 0.002);
  EXPECT_EQ(recipe.populations[1].ratio, 2.5);
  EXPECT_EQ(std::get<packing::SizeList>(recipe.populations[2].size).values, (std::vector<double>{0.001, 0.002, 0.004}));
  EXPECT_EQ(recipe.packing.method, PackingParameters::Method::lattice);
  EXPECT_EQ(recipe.packing.grains, 1000);
  EXPECT_EQ(recipe.contact.restitution, 0.2);
  EXPECT_EQ(recipe.contact.wall_friction, 0.0);
  EXPECT_EQ(recipe.contact.adhesion, dem::BreakingAdhesion{});
  EXPECT_EQ(recipe.contact.glued_pairs.at(1), (std::pair<std::int32_t, std::int32_t>(4, 2)));
  EXPECT_EQ(recipe.integration.integrator, dem::IntegratorKind::gear5);
  EXPECT_EQ(recipe.integration.time_step, 0.5e-6);
  EXPECT_EQ(recipe.integration.kernel, "portable");
  ASSERT_TRUE(recipe.glued);
  EXPECT_EQ(recipe.glued->radius, 0.02);
  const Stage& shear = recipe.stages.at(0);
  EXPECT_EQ(shear.side[top], (SideDrive{SideDrive::Kind::velocity, -1e-3}));
  EXPECT_EQ(shear.duration, 2.0);
  EXPECT_EQ(shear.drag, 3.0);
  const Stage& load = recipe.stages.at(1);
  EXPECT_EQ(load.side[top], (SideDrive{SideDrive::Kind::pressure, 10e3}));
  ASSERT_TRUE(load.cycles);
  EXPECT_EQ(*load.cycles, (Cycles{bottom, 6e3, 60e3, 3, 5, {}}));
  EXPECT_EQ(load.equilibrium.mobilisation, 0.01);
  EXPECT_EQ(load.equilibrium.max_steps, 1'000'000);
  EXPECT_EQ(load.friction, 0.0);
}

TEST(Recipe, ByteOrderMarkAndWindowsLineEndsChangeNothing) {
  std::string windows = "\xef\xbb\xbf";
  for (const char c : smallest) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_EQ(parsed(windows), parsed(smallest));
}

TEST(Recipe, OrderOfMaterialsInTheTextDoesNotMatter) {
  const std::string a = "[materials.A]\ndensity = \"1 g/cm^3\"\nstiffness = \"1 kN/mm\"\n";
  EXPECT_EQ(parsed(a + smallest), parsed(smallest + a));
}

// Bad input: each with its exact place.

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
            Lines{"r.toml:7:1: populations.0.ratio: give either count or ratio"});
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

TEST(RecipeOverride, ChangesKeysOfTheTopOfSectionsAndOfLists) {
  const Recipe recipe =
      parsed(smallest, {"seed=7", "container.width=\"400 mm\"", "stages.0.bottom.force=60 kN", "contact.friction=0.5",
                        "populations.0.count = 12", "stages.0.top={pressure = \"1 kPa\"}", "title=two words"});
  EXPECT_EQ(recipe.seed, 7u);
  EXPECT_EQ(recipe.container.width, 0.4);
  EXPECT_EQ(recipe.stages[0].side[bottom].value, 60e3);
  EXPECT_EQ(recipe.contact.friction, 0.5);
  EXPECT_EQ(recipe.populations[0].count, 12);
  EXPECT_EQ(recipe.stages[0].side[top], (SideDrive{SideDrive::Kind::pressure, 1e3}));
  EXPECT_EQ(recipe.title, "two words");
}

TEST(RecipeOverride, ReplacesTheDriveOfASideWhateverItWas) {
  EXPECT_EQ(parsed(smallest, {"stages.0.bottom.pressure=5 kPa"}).stages[0].side[bottom],
            (SideDrive{SideDrive::Kind::pressure, 5e3}));
  EXPECT_EQ(parsed(smallest, {"stages.0.bottom=fixed"}).stages[0].side[bottom], SideDrive{});
  EXPECT_EQ(parsed(smallest + "top = \"fixed\"\n", {"stages.0.top.force=5 kN"}).stages[0].side[top],
            (SideDrive{SideDrive::Kind::force, 5e3}));
}

TEST(RecipeOverride, ProblemsNameTheOverride) {
  EXPECT_EQ(problems(smallest, {"container.width=350"}), Lines{"--set container.width=350: container.width: 350 has no "
                                                               "unit; write it with its unit, for example \"350 mm\""});
  EXPECT_EQ(problems(smallest, {"frme.width=3", "stages.1.name=x", "nothing", "a..b=1"}).size(), 4u);
  EXPECT_EQ(problems(smallest, {"stages.1.name=x"}),
            Lines{"--set stages.1.name=x: \"1\" is not one of the 1 items, counted from 0, nor the name of one: load"});
}

TEST(RecipeFile, WhatCannotBeReadIsOneSentence) {
  const auto folder = std::filesystem::path(::testing::TempDir()) / "arenite_recipe_test";
  std::filesystem::create_directories(folder);
  EXPECT_THROW(read_recipe((folder / "none.toml").string()), InputError);
  EXPECT_THROW(read_recipe(folder.string()), InputError);
  const auto file = folder / "from_file.toml";
  std::string text =
      smallest.substr(0, smallest.find("[[populations]]")) + smallest.substr(smallest.find("[[stages]]"));
  text += "[packing]\nmethod = \"file\"\nfile = \"grains.csv\"\n";
  text = replaced(text, "[container]\n", "[container]\nheight = \"350 mm\"\n");
  std::ofstream(file) << text;
  std::filesystem::remove(folder / "grains.csv");
  try {
    read_recipe(file.string());
    FAIL() << "the grains' file is missing";
  } catch (const InputError& error) {
    ASSERT_EQ(error.problems().size(), 1u);
    EXPECT_EQ(error.problems()[0].line, 13);
    EXPECT_EQ(error.problems()[0].message,
              "packing.file: there is no file \"grains.csv\"; paths are relative to the folder of the recipe");
  }
  std::ofstream(folder / "grains.csv") << "id,x,y,radius\n";
  EXPECT_EQ(read_recipe(file.string()).packing.file, "grains.csv");
}

}  // namespace
}  // namespace arenite::recipe
