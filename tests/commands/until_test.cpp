#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "support/program.hpp"
#include "support/small_study.hpp"
#include "support/temporary_folder.hpp"

namespace {
using arenite::test::arenite;
using arenite::test::contains;
using arenite::test::TemporaryFolder;

std::string write(const TemporaryFolder& folder, const std::string& contact, const std::string& stage) {
  const auto file = (folder / "recipe.toml").string();
  std::ofstream(file) << arenite::test::small_packing_recipe << "[contact]\n"
                      << contact << "[[stages]]\nname = \"load\"\n"
                      << stage;
  return file;
}

const std::string strained =
    "right = { pressure = \"20 kPa\" }\ntop = { velocity = \"100 mm/s\" }\nduration = \"200 ms\"\n";

TEST(Until, EndsARunWithTheConditionInItsOutcome) {
  const TemporaryFolder folder;
  const auto recipe = write(folder, "friction = 0.3\n", strained + "until = \"strain_y > 1 %\"\n");
  const auto out = (folder / "out").string();
  const auto run = arenite("run " + recipe + " --quiet --out " + out);
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "strain_y > 1 % (strain_y = 0.01")) << run.out;
  EXPECT_TRUE(contains(arenite("show " + out).out, "strain_y > 1 %"));
  const auto again = arenite("run " + recipe + " --threads 2 --out " + out);
  EXPECT_EQ(again.status, 0);
  EXPECT_TRUE(contains(again.err, "taken from an earlier run")) << again.err;
}

TEST(Until, CheckRefusesAnUnknownNumberWithTheKnownOnes) {
  const TemporaryFolder folder;
  const auto recipe = write(folder, "", strained + "until = \"axal_strain > 1 %\"\n");
  const auto refused = arenite("check " + recipe);
  EXPECT_EQ(refused.status, 2);
  for (const char* part : {"recipe.toml:", "until", "did you mean axial_strain?", "q_over_p", "top_force"})
    EXPECT_TRUE(contains(refused.err, part)) << part << ": " << refused.err;
  EXPECT_EQ(arenite("check " + recipe + " --set 'stages.0.until=axial_strain > 1 %'").status, 0);
  EXPECT_EQ(arenite("check " + recipe + " --set 'stages.0.until=axial_strain > 1 kPa'").status, 2);
}

TEST(Unrest, IsToldOnceWithTheKeysThatMendIt) {
  const TemporaryFolder folder;
  const auto recipe = write(folder, "restitution = 1\nfriction = 0\n",
                            "gravity = true\ngravity_size = \"1000 m/s^2\"\n"
                            "equilibrium = { unbalanced = 0.1, max_steps = 150000 }\n");
  const auto run = arenite("run " + recipe + " --quiet --out " + (folder / "out").string());
  EXPECT_EQ(run.status, 3) << run.out;
  const auto at = run.err.find("ten times as many as predicted");
  ASSERT_NE(at, std::string::npos) << run.err;
  EXPECT_EQ(run.err.find("ten times as many as predicted", at + 1), std::string::npos);
  for (const char* part : {"stage load", "unbalanced force ratio", "critical_drag", "equilibrium.max_steps"})
    EXPECT_TRUE(contains(run.err, part)) << part << ": " << run.err;
}

}  // namespace
