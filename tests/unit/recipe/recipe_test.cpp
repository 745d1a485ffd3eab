#include "recipe/recipe.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "model/packing.hpp"
#include "unit/recipe/glass_grains.hpp"
#include "unit/recipe/parsed.hpp"
#include "unit/recipe/smallest_recipe.hpp"

namespace arenite::recipe {
namespace {

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

TEST(Recipe, VoxelsOfSpheresAreAsManyAsGivenEvenWhereDisksWouldHaveAsManyAnyway) {
  const std::string spheres = "dimension = 3\n[container]\nwidth = \"20 mm\"\ndepth = \"20 mm\"\n" +
                              std::string(testing::glass_grains) +
                              "[[stages]]\nname = \"rest\"\n[[loads]]\nname = \"pull\"\n[grid]\n";
  EXPECT_EQ(parsed(spheres).packing.solid_fraction, 0.5) << "without a section [packing]";
  EXPECT_EQ(parsed(spheres).grid->voxels, 128);
  const Recipe fine = parsed(spheres + "nodes = 1024\n");
  EXPECT_EQ(fine.grid->voxels, 1024);
  EXPECT_EQ(parsed(to_toml(fine)).grid->voxels, 1024);
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
