#include "core/units.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>

#include "campaign/study.hpp"
#include "campaign/study_folder.hpp"
#include "campaign/sweep.hpp"
#include "core/error.hpp"
#include "core/unit_names.hpp"
#include "support/small_study.hpp"
#include "support/temporary_folder.hpp"

namespace arenite::campaign {
namespace {

using test::small_cemented_recipe;

/// The study that a sweep makes of the small recipe.
Study study_of(const test::TemporaryFolder& folder, const std::string& sweep,
               const std::vector<std::string>& overrides = {}) {
  const std::string file = folder / "r.toml";
  std::ofstream(file) << small_cemented_recipe << sweep;
  return read_study(file, overrides);
}

std::vector<std::string> problems(const std::string& sweep) {
  const test::TemporaryFolder folder;
  std::vector<std::string> lines;
  try {
    study_of(folder, sweep);
  } catch (const InputError& error) {
    for (auto problem : error.problems()) {
      problem.file = std::filesystem::path(problem.file).filename().string();
      lines.push_back(to_string(problem));
    }
  }
  return lines;
}

std::vector<std::string> descriptions(const Study& study) {
  std::vector<std::string> lines;
  for (const auto& run : study.runs) lines.push_back(describe(run));
  return lines;
}

std::set<std::string> names(const Study& study) {
  std::set<std::string> all;
  for (const auto& run : study.runs) all.insert(run.name);
  return all;
}

using Lines = std::vector<std::string>;

TEST(Sweep, GridAndReplicatesAreAllCombinationsTheLastVaryingFastest) {
  const test::TemporaryFolder folder;
  const Study study = study_of(folder,
                               "[sweep]\nreplicates = 2\n[sweep.grid]\n\"container.width\" = [\"100 mm\", \"0.12 "
                               "m\"]\ncement.width = [0.1, 0.25]\n");
  EXPECT_EQ(descriptions(study), (Lines{"container.width = \"100 mm\", cement.width = 0.1, seed = 3",
                                        "container.width = \"100 mm\", cement.width = 0.1, seed = 4",
                                        "container.width = \"100 mm\", cement.width = 0.25, seed = 3",
                                        "container.width = \"100 mm\", cement.width = 0.25, seed = 4",
                                        "container.width = \"0.12 m\", cement.width = 0.1, seed = 3",
                                        "container.width = \"0.12 m\", cement.width = 0.1, seed = 4",
                                        "container.width = \"0.12 m\", cement.width = 0.25, seed = 3",
                                        "container.width = \"0.12 m\", cement.width = 0.25, seed = 4"}));
  const recipe::Recipe recipe = recipe_of(study, study.runs[7]);
  EXPECT_EQ(recipe.container.width, 0.12);
  EXPECT_EQ(recipe.cement->width, 0.25);
  EXPECT_EQ(recipe.seed, 4u);
  EXPECT_EQ(study.keys, (Lines{"container.width", "cement.width", "seed"}));
}

TEST(Sweep, AListGivesEachRunItsOwnKeysAndGoesWithAGrid) {
  const test::TemporaryFolder folder;
  const Study study =
      study_of(folder,
               "[[sweep.list]]\ngrid.nodes = 32\n[[sweep.list]]\n\"stages.0.top\" = { pressure = \"2 kPa\" }\n"
               "[sweep.grid]\n\"cement.width\" = [0.1, 0.2]\n");
  EXPECT_EQ(descriptions(study), (Lines{"grid.nodes = 32, cement.width = 0.1", "grid.nodes = 32, cement.width = 0.2",
                                        "stages.0.top.pressure = \"2 kPa\", cement.width = 0.1",
                                        "stages.0.top.pressure = \"2 kPa\", cement.width = 0.2"}));
  EXPECT_EQ(to_toml(recipe_of(study, study.runs[2])).find("100 N"), std::string::npos)
      << "of two forms the swept one counts";
}

TEST(Sweep, LoadsOnAMapAreSweptAndShareItsSample) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "map.png") << "any bytes: names follow from them";
  std::ofstream(folder / "map.toml") << R"([map]
file = "map.png"
dx = "1 um"
[[loads]]
name = "tension"
[sweep.grid]
"loads.0.strain" = [0.0001, 0.001]
"map.crop" = ["0,0,40,40", "0,0,60,60"]
)";
  const Study study = read_study(folder / "map.toml");
  EXPECT_EQ(
      descriptions(study),
      (Lines{"loads.0.strain = 0.0001, map.crop = \"0,0,40,40\"", "loads.0.strain = 0.0001, map.crop = \"0,0,60,60\"",
             "loads.0.strain = 0.001, map.crop = \"0,0,40,40\"", "loads.0.strain = 0.001, map.crop = \"0,0,60,60\""}));
  EXPECT_EQ(recipe_of(study, study.runs[3]).loads.at(0).strain, 0.001);
  EXPECT_EQ(study.runs[0].stages.at(0), study.runs[2].stages.at(0)) << "one crop, one sample";
  EXPECT_NE(study.runs[0].stages.at(0), study.runs[1].stages.at(0));
  EXPECT_EQ(names(study).size(), 4u);
}

TEST(Sweep, ATableGivesARunARowWithUnitsInItsHeadOrItsCells) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "runs.csv")
      << "container.width [mm],materials.POM.stiffness,cement.width\n100,27 kN/mm,0.1\n120,,0.2\n";
  const Study study = study_of(folder, "[sweep]\ntable = \"runs.csv\"\n");
  EXPECT_EQ(descriptions(study),
            (Lines{"container.width = \"100 mm\", materials.POM.stiffness = \"27 kN/mm\", cement.width = 0.1",
                   "container.width = \"120 mm\", cement.width = 0.2"}));
}

TEST(Sweep, WhatIsWrongInATableIsSaidAtItsRow) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "runs.csv") << "container.widht,cement.width\n100 mm,0.1\n";
  try {
    study_of(folder, "[sweep]\ntable = \"runs.csv\"\n");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_TRUE(std::string(error.what()).find("runs.csv:2: container.widht: unknown key; did you mean width?") !=
                std::string::npos)
        << error.what();
  }
}

/// The written numbers of a key in all runs.
std::vector<double> numbers(const Study& study, const std::string& key) {
  std::vector<double> all;
  for (const auto& run : study.runs)
    for (const auto& [name, value] : run.values)
      if (name == key)
        all.push_back(parse_quantity(value.front() == '"' ? value.substr(1, value.size() - 2) : value).value);
  return all;
}

TEST(Sweep, ALatinHypercubeHasOneRunInEveryStratumOfEveryKey) {
  const test::TemporaryFolder folder;
  const std::string ranges =
      "\"contact.friction\" = \"0.1 .. 0.5\"\n"
      "\"materials.POM.stiffness\" = { range = \"1 kN/mm .. 100 kN/mm\", scale = \"log\" }\n"
      "\"grid.nodes\" = { range = \"32..95\", whole = true }\n";
  const Study study = study_of(folder, "[sweep.latin_hypercube]\nruns = 50\n" + ranges);
  ASSERT_EQ(study.runs.size(), 50u);
  const auto strata = [](std::vector<double> values, double low, double high, bool log) {
    std::set<int> found;
    for (const double v : values)
      found.insert(static_cast<int>(50 * (log ? std::log(v / low) / std::log(high / low) : (v - low) / (high - low))));
    return found.size();
  };
  EXPECT_EQ(strata(numbers(study, "contact.friction"), 0.1, 0.5, false), 50u);
  EXPECT_EQ(strata(numbers(study, "materials.POM.stiffness"), 1e6, 1e8, true), 50u);
  for (const double nodes : numbers(study, "grid.nodes")) EXPECT_EQ(nodes, std::round(nodes));
  EXPECT_NE(numbers(study, "contact.friction"), [&] {
    auto v = numbers(study, "contact.friction");
    std::sort(v.begin(), v.end());
    return v;
  }());
  const Study fewer = study_of(folder, "[sweep.latin_hypercube]\nruns = 50\n\"contact.friction\" = \"0.1 .. 0.5\"\n");
  EXPECT_EQ(numbers(fewer, "contact.friction"), numbers(study, "contact.friction"))
      << "a key more changes nothing for the others";
  const Study other =
      study_of(folder, "[sweep.latin_hypercube]\nruns = 50\n\"contact.friction\" = \"0.1 .. 0.5\"\n", {"seed=4"});
  EXPECT_NE(numbers(other, "contact.friction"), numbers(study, "contact.friction"));
}

TEST(Sweep, HashedSeedsBelongToThePackingWhateverIsDoneWithIt) {
  const test::TemporaryFolder folder;
  const Study study = study_of(folder,
                               "[sweep]\nreplicates = 2\nseeds = \"hashed\"\n[sweep.grid]\n\"container.width\" = "
                               "[\"100 mm\", \"120 mm\"]\n\"cement.width\" = [0.1, 0.2]\n");
  ASSERT_EQ(study.runs.size(), 8u);
  const auto seed = [&](std::size_t run) { return study.runs[run].values.back().second; };
  EXPECT_EQ(seed(0), seed(2));
  EXPECT_EQ(seed(1), seed(3));
  EXPECT_EQ(study.runs[0].stages[1], study.runs[2].stages[1]) << "so packings are shared";
  EXPECT_EQ((std::set{seed(0), seed(1), seed(4), seed(5)}).size(), 4u);
}

TEST(Sweep, NamesFollowFromWhatARunDependsOnAndFromNothingElse) {
  const test::TemporaryFolder folder;
  const Study few = study_of(folder, "[sweep.grid]\n\"cement.width\" = [0.1, 0.2]\n");
  const Study more = study_of(folder, "[sweep.grid]\n\"cement.width\" = [0.3, 0.1, 0.2]\n", {"title=another"});
  EXPECT_EQ(more.runs[1].name, few.runs[0].name);
  EXPECT_EQ(more.runs[2].name, few.runs[1].name);
  EXPECT_EQ(names(more).size(), 3u);
  const Study swapped = study_of(folder, "[sweep.grid]\n\"contact.friction\" = [0.3, 0.4]\n\"cement.width\" = [0.1]\n");
  const Study order = study_of(folder, "[sweep.grid]\n\"cement.width\" = [0.1]\n\"contact.friction\" = [0.4, 0.3]\n");
  EXPECT_EQ(names(swapped), names(order));
}

TEST(Sweep, EveryProblemIsFoundInOnePassWithItsPlace) {
  EXPECT_EQ(problems("[sweep]\nreplicate = 2\n[sweep.grid]\n\"cement.width\" = 0.1\n[[sweep.list]]\nseed = "
                     "1\n[sweep.latin_hypercube]\nruns = 5\n\"contact.friction\" = \"0.5 .. 0.1\"\n"),
            (Lines{"r.toml:29:1: sweep.replicate: unknown key; did you mean replicates?",
                   "r.toml:31:18: sweep.grid.cement.width: must be a list of the values that the key takes, for "
                   "example [1, 1.25, 1.67]",
                   "r.toml:36:22: sweep.latin_hypercube.contact.friction: \"0.5\" is not below \"0.1\"; begin with the "
                   "smaller end"}));
  EXPECT_EQ(problems("[sweep]\nreplicates = 2\n[sweep.grid]\nseed = [1, 2]\n\"cement.width\" = "
                     "[0.1]\n[[sweep.list]]\ncement.width = 0.2\n"),
            (Lines{"r.toml:31:9: sweep: seed: replicates give each run its seed; leave out one of the two",
                   "r.toml:34:16: sweep: cement.width: is swept twice; keep one"}));
  EXPECT_EQ(problems("[sweep]\n").size(), 1u);
  const auto many = problems("[sweep]\nreplicates = 1000000000\n");
  EXPECT_NE(many.at(0).find("must be a whole number from 1 to 1000000"), std::string::npos) << many[0];
}

TEST(Sweep, AnInvalidRunIsNamedWithItsValuesAndEachProblemIsToldOnce) {
  EXPECT_EQ(problems("[sweep.grid]\n\"cement.width\" = [0.1, -1]\n\"container.widht\" = [\"100 "
                     "mm\"]\n\"contact.friction\" = [0.1, 0.2]\n"),
            (Lines{"r.toml:29:24: cement.width: -1 is out of range; it must be above 0, up to 2 (run with cement.width "
                   "= -1, container.widht = \"100 mm\", contact.friction = 0.1, and 1 more)",
                   "r.toml:30:22: container.widht: unknown key; did you mean width?"}));
}

TEST(Sweep, RunsThatAreOneAreRefusedWithBothNamed) {
  EXPECT_EQ(problems("[sweep.grid]\n\"contact.friction\" = [0.3, 0.3]\n\"cement.width\" = [0.1, 0.2]\n"),
            (Lines{"r.toml:29:28: sweep: two runs are the same, both with contact.friction = 0.3, cement.width = 0.1; "
                   "leave out one, or give runs other seeds by sweep.replicates"}));
  EXPECT_EQ(problems("[sweep.grid]\n\"container.width\" = [\"100 mm\", \"0.1 m\"]\n").size(), 1u);
  const auto by_name = problems("[sweep.grid]\n\"container.width\" = [\"100 mm\", \"0.1 m\"]\n").at(0);
  EXPECT_NE(by_name.find("that with container.width = \"100 mm\" and that with container.width = \"0.1 m\""),
            by_name.npos)
      << by_name;
  EXPECT_EQ(problems("[[sweep.list]]\n\"cement.width\" = 0.2\n[[sweep.list]]\n\"cement.width\" = 0.2\n").size(), 1u);
  EXPECT_TRUE(problems("[sweep]\nreplicates = 2\n[sweep.grid]\n\"cement.width\" = [0.1, 0.2]\n").empty());
}

TEST(Sweep, KeysThatReachOnePlaceAreRefused) {
  const std::string name_and_number =
      "[sweep.grid]\n\"stages.prepare.friction\" = [0.1]\n\"stages.0.friction\" = [0.2, 0.3]\n";
  EXPECT_EQ(
      problems(name_and_number),
      (Lines{"r.toml:28:1: sweep: stages.prepare.friction and stages.0.friction set the same place of the recipe; "
             "keep one of them"}));
  for (const char* keys : {"\"contact.friction\" = [0.1, 0.2]\ncontact = [{ friction = 0.3 }]\n",
                           "contact = [{ friction = 0.3 }]\n\"contact.friction\" = [0.1, 0.2]\n"}) {
    const auto found = problems(std::string("[sweep.grid]\n") + keys);
    ASSERT_EQ(found.size(), 1u) << keys;
    EXPECT_NE(found[0].find("set the same place"), std::string::npos) << found[0];
  }
  const auto drives =
      problems("[sweep.grid]\n\"stages.0.top.force\" = [\"1 kN\"]\n\"stages.0.top.pressure\" = [\"1 kPa\"]\n");
  ASSERT_EQ(drives.size(), 1u);
  EXPECT_NE(drives[0].find("stages.0.top: is given as force and pressure"), std::string::npos) << drives[0];
  EXPECT_TRUE(problems("[sweep.grid]\ncement = [{ kind = \"bridges\" }]\n\"cement.width\" = [0.1, 0.2]\n").empty())
      << "a key of a table that leaves it open";
}

TEST(Sweep, RunsAreReadBackFromTheirTableUntilAnInputChanges) {
  const test::TemporaryFolder folder;
  const std::string sweep =
      "[sweep.grid]\ntitle = [\"a\\tb, c = \\\"d\\\"\"]\n\"cement.width\" = [0.1, 0.2, 0.3, 0.4]\n";
  const Study study = study_of(folder, sweep);
  const Study made = read_study(study.file, {}, folder.path());
  Study read;
  read.file = study.file;
  ASSERT_TRUE(read_runs(folder / "runs.tsv", read));
  ASSERT_EQ(read.runs.size(), 4u);
  EXPECT_EQ(descriptions(read), descriptions(study));
  EXPECT_EQ(names(read), names(made));
  EXPECT_EQ(read.runs[3].stages, study.runs[3].stages);
  EXPECT_EQ(read.keys, study.keys);
  EXPECT_EQ(to_toml(recipe_of(read_study(study.file, {}, folder.path()), read.runs[3])),
            to_toml(recipe_of(study, study.runs[3])));
  Study other;
  other.file = study.file;
  other.overrides = {"seed=5"};
  EXPECT_FALSE(read_runs(folder / "runs.tsv", other));
  study_of(folder, "[sweep.grid]\n\"cement.width\" = [0.1]\n");
  Study changed;
  changed.file = study.file;
  EXPECT_FALSE(read_runs(folder / "runs.tsv", changed));
}

TEST(TomlLiteral, ReadsBackAsTheSameValue) {
  for (const std::string text : {"1", "-0.25", "1e+30", "true", "\"a \\\"b\\\" \\u0009\"", "[1, [2.5, \"x\"]]",
                                 "{ force = \"60 kN\", \"odd key\" = [1] }"}) {
    const std::string once = toml_literal(recipe::parse_value(text));
    EXPECT_EQ(toml_literal(recipe::parse_value(once)), once) << text;
    EXPECT_EQ(recipe::parse_value(once).kind, recipe::parse_value(text).kind) << text;
  }
}

}  // namespace
}  // namespace arenite::campaign
