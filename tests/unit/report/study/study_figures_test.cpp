#include "report/study/study_figures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "core/error.hpp"
#include "report/study/study_page.hpp"
#include "support/numbers_of.hpp"
#include "support/study_table.hpp"

namespace arenite::report {
namespace {

using test::figures_of, test::no_numbers, test::study_table;

TEST(StudyFigures, PointsAreMeansOverSeedsWithTheirErrors) {
  const auto curves = curves_of(figures_of("x = \"gamma\"\ny = [\"z\"]\nwhere = { cement = \"full\" }").front(),
                                study_table(), no_numbers);
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_EQ(curves[0].points.x, (std::vector<double>{1, 2}));
  EXPECT_EQ(curves[0].points.y, (std::vector<double>{12, 22}));
  EXPECT_DOUBLE_EQ(curves[0].points.error[0], 1);
}

TEST(StudyFigures, ACurveForEachValueOfAKeyNumbersOfXAndInverses) {
  const auto curves = curves_of(
      figures_of("x = \"1/s\"\ny = [\"z\"]\nby = \"gamma\"\nby_label = \"g\"\nwhere = { cement = \"\" }").front(),
      study_table(), no_numbers);
  ASSERT_EQ(curves.size(), 2u);
  EXPECT_EQ(curves[0].name, "g = 1");
  EXPECT_EQ(curves[1].points.x, (std::vector<double>{2}));
}

TEST(StudyFigures, ANumberOverAKeyAndUnitsOfCurves) {
  auto t = study_table();
  t.keys[0].unit = "m";
  const auto curves = curves_of(
      figures_of("x = \"6/s\"\ny = [\"z\"]\nby = \"gamma\"\nby_label = \"g\"\nwhere = { cement = \"\" }").front(), t,
      no_numbers);
  ASSERT_EQ(curves.size(), 2u);
  EXPECT_EQ(curves[0].name, "g = 1 m");
  EXPECT_EQ(curves[0].points.x, (std::vector<double>{24}));
  EXPECT_EQ(curves[1].group, 1u);
}

TEST(StudyFigures, KindsSayWhatTheyNeed) {
  EXPECT_EQ(figures_of("kind = \"forces\"").front().kind, FigureKind::forces);
  EXPECT_THROW(figures_of("kind = \"rose\""), InputError);
  EXPECT_THROW(figures_of("kind = \"map\"\nx = \"gamma\"\ny = [\"z\"]"), InputError);
  EXPECT_THROW(figures_of("kind = \"cake\""), InputError);
}

TEST(StudyFigures, FilmsAreWantedOfAllRunsThatAFigureOfThemWants) {
  const auto wanted = figures_of("kind = \"film\"\nwhere = { gamma = 1, cement = \"\" }");
  EXPECT_EQ(filmed_runs(wanted, study_table()), (std::vector<std::string>{"4", "5"}));
  EXPECT_TRUE(filmed_runs(figures_of("kind = \"forces\""), study_table()).empty());
}

TEST(StudyFigures, WhatAFilmGivesIsMarked) {
  const auto curves = curves_of(figures_of("kind = \"rose\"\ncurves = [\"s\", \"film.s\"]").front(), study_table(),
                                [](const std::string&, const std::string&, const Figure&) {
                                  return test::numbers_of(R"({"s":[1,2],"film":{"s":[2,1]}})");
                                });
  ASSERT_EQ(curves.size(), 2u);
  EXPECT_FALSE(curves[0].film);
  EXPECT_TRUE(curves[1].film);
}

TEST(StudyFigures, DeviationsStandWhereTheFigureAsksForThem) {
  const auto of = [](const std::string& spread) {
    return curves_of(figures_of("x = \"gamma\"\ny = [\"z\"]\n" + spread + "where = { cement = \"full\" }").front(),
                     study_table(), no_numbers)
        .front();
  };
  EXPECT_DOUBLE_EQ(of("").points.error[0], 1);
  EXPECT_DOUBLE_EQ(of("spread = \"deviation\"\n").points.error[0], std::sqrt(2.0));
  EXPECT_EQ(of("").most, 2u);
  EXPECT_THROW(figures_of("x = \"gamma\"\ny = [\"z\"]\nspread = \"range\""), InputError);
  const NumbersOf numbers = [](const std::string& run, const std::string&, const Figure&) {
    return test::numbers_of("{\"s\":[" + std::string(run == "6" ? "1" : "3") + ",2]}");
  };
  const auto rose =
      curves_of(figures_of("kind = \"rose\"\ncurves = [\"s\"]\ncounts = true\nspread = \"deviation\"\nwhere "
                           "= { gamma = 1, cement = \"full\" }")
                    .front(),
                study_table(), numbers)
          .front();
  EXPECT_EQ(rose.points.y, (std::vector<double>{2, 2}));
  EXPECT_DOUBLE_EQ(rose.points.error[0], std::sqrt(2.0));
}

TEST(StudyFigures, WhatBarsAreAndOverHowManySamplesIsSaid) {
  const auto said = [](const std::string& keys) {
    const Figure figure = figures_of(keys).front();
    return spread_text(
        figure, curves_of(figure, study_table(), [](const std::string& run, const std::string& path, const Figure&) {
          return test::numbers_of(path == "s" || run == "6" ? R"({"s":[1,2],"film":{"s":[2,1]}})" : "");
        }));
  };
  EXPECT_EQ(said("x = \"gamma\"\ny = [\"z\"]\nwhere = { cement = \"full\" }"), "Bars: standard error over 2 samples");
  EXPECT_EQ(said("x = \"gamma\"\ny = [\"z\"]\nspread = \"deviation\"\nwhere = { cement = \"full\" }"),
            "Bars: standard deviation over 2 samples");
  EXPECT_EQ(said("kind = \"rose\"\ncurves = [\"s\", \"film.s\"]\nwhere = { gamma = 1, cement = \"full\" }"),
            "Ticks: standard error over 2 samples; of the film: one sample");
  EXPECT_EQ(said("kind = \"rose\"\ncurves = [\"s\"]\nwhere = { seed = 1, gamma = 1, cement = \"full\" }"),
            "One sample");
  EXPECT_EQ(said("kind = \"grains\""), "");
}

TEST(StudyFigures, OtherRunsAndTheSourcesPointsStandBeside) {
  const auto curves =
      curves_of(figures_of("x = \"gamma\"\ny = [\"z\"]\nwhere = { cement = \"\" }\n"
                           "beside = [{ name = \"full\", x = \"0\", y = \"z\", where = { cement = \"full\" } }]\n"
                           "source_points = [{ name = \"T\", film = true, x = [1, 2], y = [3, 4] }]")
                    .front(),
                study_table(), no_numbers);
  ASSERT_EQ(curves.size(), 3u);
  EXPECT_FALSE(curves[0].beside || curves[0].source);
  EXPECT_TRUE(curves[1].beside);
  EXPECT_EQ(curves[1].name, "full");
  EXPECT_EQ(curves[1].points.x, (std::vector<double>{0, 0}));
  EXPECT_EQ(curves[1].points.y, (std::vector<double>{22, 12}));
  EXPECT_TRUE(curves[2].source && curves[2].film);
  EXPECT_EQ(curves[2].points.y, (std::vector<double>{3, 4}));
  EXPECT_THROW(figures_of("x = \"gamma\"\ny = [\"z\"]\nsource_points = [{ name = \"T\", x = [1], y = [3, 4] }]"),
               InputError);
  EXPECT_THROW(figures_of("x = \"gamma\"\ny = [\"z\"]\nbeside = [{ name = \"T\" }]"), InputError);
}

TEST(StudyFigures, FormerNamesAreReadWithANotice) {
  std::vector<std::string> notices;
  const auto read = read_figures(
      "[[figures]]\nid = \"f\"\ntitle = \"F\"\ncurves = [\"stress.sets.all.even_pdf\", "
      "\"film.directions.film.sectors\", \"stress.sets.small.even_pdf\"]\n"
      "share_above = true\nbeside = [{ name = \"b\", x = \"raster.dx\", y = \"raster\" }]",
      "figures.toml", &notices);
  EXPECT_EQ(read.front().curves,
            (std::vector<std::string>{"stress.sets.all.histogram", "film.contact_orientations.film.sectors",
                                      "stress.sets.small.histogram"}));
  EXPECT_EQ(read.front().beside.front().x, "grid.dx");
  EXPECT_EQ(read.front().beside.front().y, "grid");
  EXPECT_TRUE(read.front().survival);
  EXPECT_EQ(notices,
            (std::vector<std::string>{"figures.*.share_above is now called survival; the former name is still read",
                                      "even_pdf is now called histogram; the former name is still read",
                                      "directions is now called contact_orientations; the former name is still read",
                                      "raster is now called grid; the former name is still read"}));
}

TEST(StudyFigures, KeysThatAreUnknownWrongOrMissingAreToldAtTheirPlaces) {
  try {
    read_figures("[[figures]]\ntitle = 3\nx = \"gamma\"\ny = [\"z\"]\nfigure = 1\nkind = \"plott\"\n", "figures.toml");
    FAIL();
  } catch (const InputError& error) {
    const auto& problems = error.problems();
    ASSERT_EQ(problems.size(), 4u);
    EXPECT_EQ(problems[0].line, 1);
    EXPECT_NE(problems[0].message.find("figures.0.id: is missing"), std::string::npos) << problems[0].message;
    EXPECT_EQ(problems[1].line, 2);
    EXPECT_EQ(problems[2].line, 5);
    EXPECT_NE(problems[3].message.find("did you mean \"plot\"?"), std::string::npos) << problems[3].message;
  }
}

TEST(StudyFigures, ReferencePageIsUpToDate) {
  std::ifstream file(ARENITE_SOURCE_DIR "/docs/figures.md");
  std::ostringstream page;
  page << file.rdbuf();
  EXPECT_EQ(page.str(), figure_key_reference()) << "write it anew: build/arenite man --figure-keys > docs/figures.md";
}

TEST(StudyFigures, SectorsAndWindowsAreWithinReason) {
  EXPECT_THROW(figures_of("kind = \"rose\"\ncurves = [\"s\"]\nsectors = 12.5"), InputError);
  EXPECT_THROW(figures_of("curves = [\"window.solid_fraction\"]\ncurve_x = \"window.place\"\nwindow = 72"), InputError);
}

TEST(StudyFigures, ARegressionOfASharePassesThroughAnExponentialOne) {
  std::string density;  // of P = 0.4 exp(2 (1 - x)) above 1
  for (int k = 0; k < 60; ++k)
    density += (k ? "," : "") +
               std::to_string(k < 10 ? 0.6 : 4 * (std::exp(2 * (1 - 0.1 * k)) - std::exp(2 * (1 - 0.1 * (k + 1)))));
  const std::string text =
      R"({"d":{"pdf":{"low":0,"width":0.1,"density":[)" + density + R"(]},"beta_line":{"value":2,"error":0.1}}})";
  const auto curves = curves_of(
      figures_of(
          "curves = [\"d.pdf\"]\nfits = [\"d\"]\nshare_above = true\nwhere = { gamma = 1, cement = \"\", seed = 1 }")
          .front(),
      study_table(), [&](const std::string&, const std::string&, const Figure&) { return test::numbers_of(text); });
  ASSERT_EQ(curves.size(), 2u);
  ASSERT_TRUE(curves[1].fit);
  EXPECT_DOUBLE_EQ(curves[1].points.x.front(), 1);
  EXPECT_NEAR(curves[1].points.y.front(), 0.4, 2e-3);
  EXPECT_NEAR(curves[1].points.y[10] / curves[1].points.y[0], std::exp(-2 * (curves[1].points.x[10] - 1)), 1e-9);
}

TEST(StudyFigures, ATailIsALineThroughItsDensityBetweenTheEndsOfTheFit) {
  std::string density;
  for (int k = 0; k < 40; ++k) density += (k ? "," : "") + std::to_string(5 * std::exp(-2 * (0.05 + 0.1 * k)));
  const std::string text = R"({"pdf":{"low":0,"width":0.1,"density":[)" + density +
                           R"(]},"tail":{"slope":{"value":2,"error":0.1},"low":1,"high":3}})";
  const auto curves = curves_of(
      figures_of("curves = [\"pdf\"]\nfits = [\"tail\"]\nwhere = { gamma = 1, cement = \"\", seed = 1 }").front(),
      study_table(), [&](const std::string&, const std::string&, const Figure&) { return test::numbers_of(text); });
  ASSERT_EQ(curves.size(), 2u);
  EXPECT_FALSE(curves[0].fit);
  ASSERT_TRUE(curves[1].fit);
  EXPECT_EQ(curves[1].points.x, (std::vector<double>{1, 3}));
  EXPECT_NEAR(curves[1].points.y[0], 5 * std::exp(-2), 1e-4);
  EXPECT_NEAR(curves[1].points.y[1], 5 * std::exp(-6), 1e-5);
  EXPECT_THROW(figures_of("curves = [\"a\", \"b\"]\nfits = [\"tail\"]"), InputError);
}

TEST(StudyFigures, AWrongKeyAndAMissingOneAreToldWithTheirLines) {
  try {
    figures_of("xx = 1\nx = \"gamma\"");
    FAIL();
  } catch (const InputError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("figures.toml:4"), std::string::npos) << text;
    EXPECT_NE(text.find("figures.0.xx: unknown key"), std::string::npos) << text;
    EXPECT_NE(text.find("curves, are needed"), std::string::npos) << text;
  }
  EXPECT_THROW(curves_of(figures_of("x = \"gamma\"\ny = [\"z\"]\nby = \"theta\"").front(), study_table(), no_numbers),
               InputError);
}

}  // namespace
}  // namespace arenite::report
