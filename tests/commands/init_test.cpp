#include <gtest/gtest.h>

#include <ostream>
#include <string>

#include "support/program.hpp"

namespace {
using arenite::test::arenite;
using arenite::test::contains;
using arenite::test::slurp;
using arenite::test::TemporaryFolder;

struct Template {
  const char *name, *smaller, *tells;  ///< what makes it a small one, and what its numbers must hold
};

void PrintTo(const Template& t, std::ostream* out) { *out << t.name; }

class Init : public ::testing::TestWithParam<Template> {};

TEST_P(Init, WritesARecipeThatRunsAsItIs) {
  const Template& t = GetParam();
  const TemporaryFolder folder;
  const std::string recipe = (folder / "r.toml").string(), out = (folder / "out").string();
  ASSERT_EQ(arenite("init " + std::string(t.name) + " " + recipe).status, 0);
  const auto checked = arenite("check " + recipe);
  ASSERT_EQ(checked.status, 0) << checked.err;
  EXPECT_FALSE(contains(checked.err, "warning") || contains(checked.err, "stages.")) << checked.err;
  const auto ran = arenite("run " + recipe + " --quiet --out " + out + " " + t.smaller);
  ASSERT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(ran.err, "");
  const auto shown = arenite("show " + out + " --numbers");
  EXPECT_TRUE(contains(shown.out, t.tells)) << shown.out;
  EXPECT_TRUE(contains(slurp(folder / "out/report.html"), "</html>"));
}

INSTANTIATE_TEST_SUITE_P(
    Templates, Init,
    ::testing::Values(
        Template{"biaxial", "--set packing.grains=80 --set variables.W='\"30 mm\"' --set variables.rate='\"400 mm/s\"'",
                 "peak.q_over_p"},
        Template{"shear", "--set populations.glass.count=80 --set container.width='\"9*d\"' --set variables.I=0.1",
                 "loads.top.asked_Pa"},
        Template{"silo", "--set populations.acrylic.count=250 --set stages.discharge.duration='\"0.3 s\"'",
                 "discharge.rate_kg_s"},
        Template{"collapse",
                 "--set populations.acrylic.count=120 --set variables.L='\"40 mm\"' --set "
                 "stages.collapse.duration='\"0.3 s\"'",
                 "surface.runout_m"},
        Template{
            "drum",
            "--set populations.acrylic.count=60 --set variables.D='\"70 mm\"' --set stages.turn.duration='\"0.5 s\"'",
            "surface.top_m"},
        Template{"rock",
                 "--set populations.granite.count=100 --set container.width='\"13 mm\"' --set "
                 "stages.press.duration='\"0.4 ms\"'",
                 "uniaxial.strength_Pa"},
        Template{"cycles",
                 "--set populations.sand.count=100 --set container.width='\"75 mm\"' --set stages.cycle.cycles.count=2",
                 "cycles.strain_amplitude"},
        Template{
            "deposit",
            "--set populations.glass.count=60 --set container.width='\"40 mm\"' --set container.height='\"150 mm\"'",
            "surface.top_m"},
        Template{"spheres", "--set packing.grains=120 --set variables.W='\"19 mm\"' --set variables.rate='\"10 1/s\"'",
                 "peak.q_over_p"}),
    [](const auto& of) { return std::string(of.param.name); });

TEST(Templates, OfADrumTakesTheShapesThatItNames) {
  const TemporaryFolder folder;
  const std::string recipe = (folder / "r.toml").string();
  ASSERT_EQ(arenite("init drum " + recipe).status, 0);
  for (const char* shape : {"triangle", "square", "pentagon", "hexagon", "clump"}) {
    const auto checked =
        arenite("check " + recipe + " --set populations.acrylic.count=300 --set populations.acrylic.shape=" + shape);
    EXPECT_EQ(checked.status, 0) << checked.err;
    EXPECT_FALSE(contains(checked.err, "refuse")) << shape << ": " << checked.err;
  }
  // Circles about them on 1.02 times the area that is allowed: the mend is more than nothing.
  const auto full =
      arenite("check " + recipe + " --set populations.acrylic.count=600 --set populations.acrylic.shape=pentagon");
  EXPECT_TRUE(contains(full.err, "give it 1.0") && !contains(full.err, "1.00")) << full.err;
}

TEST(Templates, AreListed) {
  const auto listed = arenite("init");
  EXPECT_EQ(listed.status, 0);
  for (const char* name : {"biaxial", "shear", "silo", "collapse", "drum", "rock", "cycles", "deposit", "spheres",
                           "composite", "film", "study"})
    EXPECT_TRUE(contains(listed.out, name)) << name;
}

}  // namespace
