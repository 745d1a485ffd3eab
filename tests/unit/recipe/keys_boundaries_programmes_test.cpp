#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "core/error.hpp"
#include "recipe/recipe.hpp"
#include "unit/recipe/glass_grains.hpp"

namespace arenite::recipe {
namespace {

const std::string start = R"(
[container]
width = "100 mm"
height = "100 mm"
thickness = "10 mm"
)" + testing::glass_grains +
                          R"([[stages]]
name = "load"
gravity = true
)";

const std::string tables = R"(duration = "1 s"
[[stages.programmes]]
of = "top.force"
table = [["0 s", "1 kN"], ["500 ms", "20 N"]]
repeat = true
[[stages.programmes]]
of = "slide.bottom"
table = [["0 s", "1 m/s"]]
[[stages.programmes]]
of = "gravity_angle"
table = [["0 s", "0 deg"], ["1 s", "90 deg"]]
)";

std::string refused_programme(const std::string& text) {
  try {
    parse_recipe(text, "r.toml");
    return "none";
  } catch (const InputError& error) { return error.what(); }
}

TEST(Programmes, AreReadWithTheirUnitsAndSetWhatTheStageBeginsWith) {
  const Recipe recipe = parse_recipe(start + tables, "r.toml");
  const dem::Stage& stage = recipe.stages.at(0);
  ASSERT_EQ(stage.programmes.size(), 3u);
  EXPECT_EQ(stage.programmes[0].table, (std::vector<Vec2>{{0, 1000}, {0.5, 20}}));
  EXPECT_TRUE(stage.programmes[0].repeat);
  EXPECT_EQ(stage.side[top], (dem::SideDrive{dem::SideDrive::Kind::force, 1000}));
  EXPECT_EQ(stage.slide[bottom], 1);
  EXPECT_DOUBLE_EQ(stage.programmes[2].table[1].y, 1.5707963267948966);
  EXPECT_EQ(parse_recipe(to_toml(recipe), "r.toml"), recipe);
}

TEST(Programmes, ComeFromACsvFileBesideTheRecipe) {
  const auto folder = std::filesystem::temp_directory_path() / "arenite-programmes";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "load.csv") << "time [ms],force [kN]\n0,1\n500,0.02\n";
  std::string text = start + tables;
  const std::string inline_table = R"([["0 s", "1 kN"], ["500 ms", "20 N"]])";
  text.replace(text.find(inline_table), inline_table.size(), "\"load.csv\"");
  std::ofstream(folder / "r.toml") << text;
  const Recipe read = read_recipe((folder / "r.toml").string());
  EXPECT_EQ(read.stages, parse_recipe(start + tables, "r.toml").stages);
  // What is resolved needs the file no more.
  EXPECT_EQ(parse_recipe(to_toml(read), "elsewhere.toml").stages, read.stages);

  std::ofstream(folder / "load.csv") << "time [s],force [m]\n0,1\n";
  EXPECT_THROW(read_recipe((folder / "r.toml").string()), InputError);
  std::ofstream(folder / "load.csv") << "time [s],force [N],more\n0,1,2\n";
  EXPECT_THROW(read_recipe((folder / "r.toml").string()), InputError);
  std::filesystem::remove(folder / "load.csv");
  EXPECT_THROW(read_recipe((folder / "r.toml").string()), InputError);
  std::filesystem::remove_all(folder);
}

TEST(Programmes, AreRefusedWhereTheyMakeNoSense) {
  const std::string time = "duration = \"1 s\"\n", one = "[[stages.programmes]]\n";
  for (const auto& [text, because] : std::initializer_list<std::pair<std::string, std::string>>{
           {one + "of = \"top.force\"\ntable = [[\"0 s\", \"1 kN\"]]\n", "needs its duration"},
           {time + one + "of = \"top.force\"\ntable = [[\"0 s\", \"1 mm\"]]\n", "mm"},
           {time + one + "of = \"top.force\"\ntable = [[\"0 s\", 1]]\n", "no unit"},
           {time + one + "of = \"top.force\"\ntable = [[\"0 s\", \"-1 kN\"]]\n", "below 0"},
           {time + one + "of = \"top.force\"\ntable = [[\"1 s\", \"1 kN\"], [\"0 s\", \"1 kN\"]]\n", "never decrease"},
           {time + one + "of = \"top.force\"\ntable = [[\"0 s\", \"1 kN\"]]\nrepeat = true\n",
            "with a duration can repeat"},
           {time + one + "of = \"top.force\"\ntable = []\n", "needs at least one row"},
           {time + one + "of = \"shear_rate\"\ntable = [[\"0 s\", \"1 1/s\"]]\n", "periodic in both directions"},
           {time + "top = { pressure = \"1 kPa\" }\n" + one + "of = \"top.force\"\ntable = [[\"0 s\", \"1 kN\"]]\n",
            "is already driven in this stage"},
           {time + one + "of = \"top.force\"\ntable = [[\"0 s\", \"1 kN\"]]\n" + one +
                "of = \"top.velocity\"\ntable = [[\"0 s\", \"1 mm/s\"]]\n",
            "two of them"},
           {time + "top = { force = \"2 kN\" }\n" + one + "of = \"top.force\"\ntable = [[\"0 s\", \"1 kN\"]]\n",
            "leave the constant out"},
           {time + "slide = { top = \"2 mm/s\" }\n" + one + "of = \"slide.top\"\ntable = [[\"0 s\", \"1 mm/s\"]]\n",
            "slide.top has a constant of its own"},
           {time + "open = { top = true }\n" + one +
                "of = \"slide.top\"\ntable = [[\"0 s\", \"0 mm/s\"], [\"1 s\", \"1 mm/s\"]]\n",
            "cannot be open and move"}})
    EXPECT_NE(refused_programme(start + text).find(because), std::string::npos)
        << text << refused_programme(start + text);
}

TEST(StrainCycles, AreReadAndRefused) {
  const std::string cycles =
      "strain_cycles = { of = \"top\", max = 0.01, rate = \"0.1 1/s\", count = 2000, store_every = 100 }\n";
  const Recipe recipe = parse_recipe(start + cycles, "r.toml");
  EXPECT_EQ(*recipe.stages[0].strain_cycles, (dem::StrainCycles{top, 0, 0.01, 0.1, 2000, 100}));
  EXPECT_EQ(parse_recipe(to_toml(recipe), "r.toml"), recipe);
  EXPECT_NE(refused_programme(start + cycles + "duration = \"1 s\"\n").find("leave out its duration"),
            std::string::npos);
  EXPECT_NE(refused_programme(start + cycles + "top = { force = \"1 kN\" }\n").find("is already driven in this stage"),
            std::string::npos);
  EXPECT_NE(refused_programme(start + "strain_cycles = { of = \"shear\", max = 0.01, rate = \"0.1 1/s\", count = 2 }\n")
                .find("periodic in both directions"),
            std::string::npos);
  EXPECT_NE(refused_programme(
                start + "strain_cycles = { of = \"top\", min = 0.1, max = 0.01, rate = \"0.1 1/s\", count = 2 }\n")
                .find("above min"),
            std::string::npos);
}

TEST(Programmes, TwoOfOneQuantityAreRefusedOnce) {
  const std::string slide = "[[stages.programmes]]\nof = \"slide.bottom\"\ntable = [[\"0 s\", \"1 m/s\"]]\n";
  const std::string told = refused_programme(start + "duration = \"1 s\"\n" + slide + slide);
  const auto first = told.find("slide.bottom is driven by two of them");
  ASSERT_NE(first, std::string::npos) << told;
  EXPECT_EQ(told.find("driven by two", first + 20), std::string::npos) << told;
}

}  // namespace
}  // namespace arenite::recipe
