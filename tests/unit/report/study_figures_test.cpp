#include "report/study_page.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "core/error.hpp"
#include "io/disk/file.hpp"
#include "report/run_means.hpp"
#include "report/study_figures.hpp"
#include "support/numbers_of.hpp"
#include "support/temporary_folder.hpp"

namespace arenite::report {
namespace {

/// gamma 1 and 2, two seeds each, width 0.2 or full; z is 10 gamma + seed.
campaign::CollectedTable table() {
  campaign::CollectedTable t;
  t.keys = {{"gamma", ""}, {"cement", ""}, {"seed", ""}};
  t.names = {"z", "s"};
  int run = 0;
  for (const char* gamma : {"2", "1"})
    for (const char* cement : {"", "full"})
      for (const char* seed : {"1", "3"})
        t.rows.push_back(
            {std::to_string(run++),
             "done",
             {gamma, cement, seed},
             1,
             {campaign::Estimate{10 * std::stod(gamma) + std::stod(seed)}, campaign::Estimate{std::stod(gamma) / 4}}});
  return t;
}

const NumbersOf none = [](const std::string&, const std::string&, const Figure&) { return Numbers{}; };

std::vector<Figure> figures(const std::string& keys) {
  return read_figures("[[figures]]\nid = \"f\"\ntitle = \"F\"\n" + keys, "figures.toml");
}

std::string study_page(const StudyPage& page) {
  const test::TemporaryFolder folder;
  write_study_page(folder / "study.html", page);
  return io::read_file((folder / "study.html").string());
}

TEST(StudyFigures, PointsAreMeansOverSeedsWithTheirErrors) {
  const auto curves =
      curves_of(figures("x = \"gamma\"\ny = [\"z\"]\nwhere = { cement = \"full\" }").front(), table(), none);
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_EQ(curves[0].points.x, (std::vector<double>{1, 2}));
  EXPECT_EQ(curves[0].points.y, (std::vector<double>{12, 22}));
  EXPECT_DOUBLE_EQ(curves[0].points.error[0], 1);
}

TEST(StudyFigures, ACurveForEachValueOfAKeyNumbersOfXAndInverses) {
  const auto curves = curves_of(
      figures("x = \"1/s\"\ny = [\"z\"]\nby = \"gamma\"\nby_label = \"g\"\nwhere = { cement = \"\" }").front(), table(),
      none);
  ASSERT_EQ(curves.size(), 2u);
  EXPECT_EQ(curves[0].name, "g = 1");
  EXPECT_EQ(curves[1].points.x, (std::vector<double>{2}));
}

TEST(StudyFigures, DensitiesAreMeansOverRuns) {
  const auto even = mean_density(test::numbers_of({R"({"a":{"pdf":{"low":0,"width":0.5,"density":[1,3]}}})",
                                                   R"({"a":{"pdf":{"low":0,"width":0.5,"density":[2,4]}}})", "{}"}),
                                 "a.pdf");
  EXPECT_EQ(even.x, (std::vector<double>{0.25, 0.75}));
  EXPECT_EQ(even.y, (std::vector<double>{1.5, 3.5}));
  EXPECT_DOUBLE_EQ(even.error[0], 0.5);
  const auto own = mean_density(
      test::numbers_of({R"({"pdf":{"edge":[1,10,100],"density":[2,1]}})", R"({"pdf":{"edge":[1,100],"density":[4]}})"}),
      "pdf");
  ASSERT_EQ(own.x.size(), 40u);
  EXPECT_DOUBLE_EQ(own.y.front(), 3);
  EXPECT_DOUBLE_EQ(own.y.back(), 2.5);
  EXPECT_TRUE(mean_density(test::numbers_of({"", "{}"}), "pdf").x.empty());
}

TEST(StudyFigures, DensitiesByMiddlesOfBinsShareTheLongest) {
  const auto mean = mean_density(
      test::numbers_of({R"({"pdf":{"x":[0.05,0.15],"y":[4,2]}})", R"({"pdf":{"x":[0.05,0.15,0.25],"y":[2,2,6]}})"}),
      "pdf");
  ASSERT_EQ(mean.x.size(), 3u);
  EXPECT_NEAR(mean.x[2], 0.25, 1e-12);
  EXPECT_EQ(mean.y, (std::vector<double>{3, 2, 3}));
}

TEST(StudyFigures, ListsAreMeansAgainstAnotherListOrSharesOfSectors) {
  const std::vector<Numbers> runs =
      test::numbers_of({R"({"a":{"s":[0.1,0.2],"m":[1,2]}})", R"({"a":{"s":[0.1,0.2],"m":[3,6]}})", "{}"});
  const auto list = mean_list(runs, "a.s", "a.m");
  EXPECT_EQ(list.x, (std::vector<double>{0.1, 0.2}));
  EXPECT_EQ(list.y, (std::vector<double>{2, 4}));
  EXPECT_DOUBLE_EQ(list.error[0], 1);
  const auto sectors = mean_list(runs, "", "a.m");
  EXPECT_EQ(sectors.x, (std::vector<double>{45, 135}));
  EXPECT_NEAR(sectors.y[0], 2.0 / 3, 1e-12);
  EXPECT_NEAR(sectors.y[1], 4.0 / 3, 1e-12);
}

TEST(StudyFigures, ANumberOverAKeyAndUnitsOfCurves) {
  auto t = table();
  t.keys[0].unit = "m";
  const auto curves = curves_of(
      figures("x = \"6/s\"\ny = [\"z\"]\nby = \"gamma\"\nby_label = \"g\"\nwhere = { cement = \"\" }").front(), t,
      none);
  ASSERT_EQ(curves.size(), 2u);
  EXPECT_EQ(curves[0].name, "g = 1 m");
  EXPECT_EQ(curves[0].points.x, (std::vector<double>{24}));
  EXPECT_EQ(curves[1].group, 1u);
}

TEST(StudyFigures, KindsSayWhatTheyNeed) {
  EXPECT_EQ(figures("kind = \"forces\"").front().kind, FigureKind::forces);
  EXPECT_THROW(figures("kind = \"rose\""), InputError);
  EXPECT_THROW(figures("kind = \"map\"\nx = \"gamma\"\ny = [\"z\"]"), InputError);
  EXPECT_THROW(figures("kind = \"cake\""), InputError);
}

TEST(StudyPage, DrawsTheFirstRunThatAFigureWants) {
  StudyPage page{"S", figures("kind = \"stresses\"\nwhere = { gamma = 1, cement = \"full\" }"), table(), none};
  page.drawing = [](const std::string& run, const Figure& figure) {
    return Numbers{{"run", run + word_for(figure.kind)}};
  };
  EXPECT_NE(study_page(page).find("\"sample\":{\"run\":\"6stresses\"}"), std::string::npos);
}

TEST(StudyPage, LeavesItsFiguresAsNumbersBesideIt) {
  const test::TemporaryFolder folder;
  EXPECT_FALSE(figures_on(folder / "study.html").is_known());
  StudyPage page{"A <study>", figures("kind = \"zoom\""), table(), none};
  page.drawing = [](const std::string&, const Figure&) { return Numbers{{"stress", {0.1, nullptr, 3}}}; };
  write_study_page(folder / "study.html", page);
  const Numbers shown = figures_on(folder / "study.html");
  EXPECT_EQ(shown["title"], Numbers("A <study>"));
  ASSERT_EQ(shown["figures"].size(), 1u);
  EXPECT_NE(study_page(page).find("\"figures\":" + to_json(shown["figures"], -1)), std::string::npos);
}

TEST(StudyPage, SaysWhyARunIsNotDrawnAndWhichCurvesAreNotThereYet) {
  StudyPage page{"S", figures("kind = \"film\""), table(), none};
  page.drawing = [](const std::string&, const Figure&) -> Numbers {
    throw InputError("/a/folder", 0, "no film of this run was made");
  };
  EXPECT_NE(study_page(page).find("\"missing\":\"Not drawn: no film of this run was made.\""), std::string::npos);
  page.figures = figures("kind = \"film\"\nwhere = { gamma = 7 }");
  EXPECT_NE(study_page(page).find("\"missing\":\"No run of this kind has finished yet.\""), std::string::npos);
  page.figures = figures("kind = \"rose\"\ncurves = [\"s\", \"film.s\"]\nnames = [\"simulation\", \"film\"]");
  page.numbers = [](const std::string&, const std::string& path, const Figure&) {
    return test::numbers_of(path == "s" ? R"({"s":[1,2]})" : "");
  };
  EXPECT_NE(study_page(page).find("\"missing\":\"No finished run has its numbers yet: film.\""), std::string::npos);
}

TEST(StudyFigures, FilmsAreWantedOfAllRunsThatAFigureOfThemWants) {
  const auto wanted = figures("kind = \"film\"\nwhere = { gamma = 1, cement = \"\" }");
  EXPECT_EQ(filmed_runs(wanted, table()), (std::vector<std::string>{"4", "5"}));
  EXPECT_TRUE(filmed_runs(figures("kind = \"forces\""), table()).empty());
}

TEST(StudyFigures, WhatAFilmGivesIsMarked) {
  const auto curves = curves_of(figures("kind = \"rose\"\ncurves = [\"s\", \"film.s\"]").front(), table(),
                                [](const std::string&, const std::string&, const Figure&) {
                                  return test::numbers_of(R"({"s":[1,2],"film":{"s":[2,1]}})");
                                });
  ASSERT_EQ(curves.size(), 2u);
  EXPECT_FALSE(curves[0].film);
  EXPECT_TRUE(curves[1].film);
}

TEST(StudyFigures, TheShareAboveADensityStandsAtTheLowerEdgesWithTheErrorOfTheSharesOfTheSamples) {
  const auto above = mean_survival(test::numbers_of({R"({"pdf":{"low":0,"width":0.5,"density":[0.8,0.8,0.4]}})",
                                                     R"({"pdf":{"low":0,"width":0.5,"density":[1.2,0.8]}})"}),
                                   "pdf");
  EXPECT_EQ(above.x, (std::vector<double>{0, 0.5, 1}));
  EXPECT_EQ(above.samples, 2u);
  ASSERT_EQ(above.y.size(), 3u);
  EXPECT_DOUBLE_EQ(above.y[0], 1);
  EXPECT_DOUBLE_EQ(above.y[1], 0.5);
  EXPECT_DOUBLE_EQ(above.y[2], 0.1);
  EXPECT_NEAR(above.error[0], 0, 1e-15);
  EXPECT_DOUBLE_EQ(above.error[1], 0.1);
  EXPECT_DOUBLE_EQ(above.error[2], 0.1);
}

TEST(StudyFigures, RosesShowNumbersWithTheirErrorsAndShareSectorsOut) {
  const std::vector<Numbers> runs = test::numbers_of({R"({"s":[3,6,9]})", R"({"s":[5,6,7]})"});
  const auto counts = mean_list(runs, "", "s", {0, false});
  EXPECT_EQ(counts.y, (std::vector<double>{4, 6, 8}));
  EXPECT_DOUBLE_EQ(counts.error[0], 1);
  EXPECT_EQ(counts.samples, 2u);
  const auto two = mean_list(runs, "", "s", {2, false});
  EXPECT_EQ(two.x, (std::vector<double>{45, 135}));
  EXPECT_NEAR(two.y[0], 7, 1e-12);
  EXPECT_NEAR(two.y[1], 11, 1e-12);
  EXPECT_NEAR(two.error[0], 1, 1e-12);
  const auto four = mean_list(test::numbers_of({R"({"s":[3,6,9]})"}), "", "s", {4, false});
  EXPECT_NEAR(four.y[0] + four.y[1] + four.y[2] + four.y[3], 18, 1e-12);
  EXPECT_NEAR(four.y[1], 0.75 + 3, 1e-12);
}

TEST(StudyFigures, DeviationsStandWhereTheFigureAsksForThem) {
  const auto of = [](const std::string& spread) {
    return curves_of(figures("x = \"gamma\"\ny = [\"z\"]\n" + spread + "where = { cement = \"full\" }").front(),
                     table(), none)
        .front();
  };
  EXPECT_DOUBLE_EQ(of("").points.error[0], 1);
  EXPECT_DOUBLE_EQ(of("spread = \"deviation\"\n").points.error[0], std::sqrt(2.0));
  EXPECT_EQ(of("").most, 2u);
  EXPECT_THROW(figures("x = \"gamma\"\ny = [\"z\"]\nspread = \"range\""), InputError);
  const NumbersOf numbers = [](const std::string& run, const std::string&, const Figure&) {
    return test::numbers_of("{\"s\":[" + std::string(run == "6" ? "1" : "3") + ",2]}");
  };
  const auto rose = curves_of(figures("kind = \"rose\"\ncurves = [\"s\"]\ncounts = true\nspread = \"deviation\"\nwhere "
                                      "= { gamma = 1, cement = \"full\" }")
                                  .front(),
                              table(), numbers)
                        .front();
  EXPECT_EQ(rose.points.y, (std::vector<double>{2, 2}));
  EXPECT_DOUBLE_EQ(rose.points.error[0], std::sqrt(2.0));
}

TEST(StudyFigures, WhatBarsAreAndOverHowManySamplesIsSaid) {
  const auto said = [](const std::string& keys) {
    const Figure figure = figures(keys).front();
    return spread_text(figure,
                       curves_of(figure, table(), [](const std::string& run, const std::string& path, const Figure&) {
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
      curves_of(figures("x = \"gamma\"\ny = [\"z\"]\nwhere = { cement = \"\" }\n"
                        "beside = [{ name = \"full\", x = \"0\", y = \"z\", where = { cement = \"full\" } }]\n"
                        "source_points = [{ name = \"T\", film = true, x = [1, 2], y = [3, 4] }]")
                    .front(),
                table(), none);
  ASSERT_EQ(curves.size(), 3u);
  EXPECT_FALSE(curves[0].beside || curves[0].source);
  EXPECT_TRUE(curves[1].beside);
  EXPECT_EQ(curves[1].name, "full");
  EXPECT_EQ(curves[1].points.x, (std::vector<double>{0, 0}));
  EXPECT_EQ(curves[1].points.y, (std::vector<double>{22, 12}));
  EXPECT_TRUE(curves[2].source && curves[2].film);
  EXPECT_EQ(curves[2].points.y, (std::vector<double>{3, 4}));
  EXPECT_THROW(figures("x = \"gamma\"\ny = [\"z\"]\nsource_points = [{ name = \"T\", x = [1], y = [3, 4] }]"),
               InputError);
  EXPECT_THROW(figures("x = \"gamma\"\ny = [\"z\"]\nbeside = [{ name = \"T\" }]"), InputError);
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
  EXPECT_THROW(figures("kind = \"rose\"\ncurves = [\"s\"]\nsectors = 12.5"), InputError);
  EXPECT_THROW(figures("curves = [\"window.solid_fraction\"]\ncurve_x = \"window.place\"\nwindow = 72"), InputError);
}

TEST(StudyFigures, ARegressionOfASharePassesThroughAnExponentialOne) {
  std::string density;  // of P = 0.4 exp(2 (1 - x)) above 1
  for (int k = 0; k < 60; ++k)
    density += (k ? "," : "") +
               std::to_string(k < 10 ? 0.6 : 4 * (std::exp(2 * (1 - 0.1 * k)) - std::exp(2 * (1 - 0.1 * (k + 1)))));
  const std::string text =
      R"({"d":{"pdf":{"low":0,"width":0.1,"density":[)" + density + R"(]},"beta_line":{"value":2,"error":0.1}}})";
  const auto curves = curves_of(
      figures(
          "curves = [\"d.pdf\"]\nfits = [\"d\"]\nshare_above = true\nwhere = { gamma = 1, cement = \"\", seed = 1 }")
          .front(),
      table(), [&](const std::string&, const std::string&, const Figure&) { return test::numbers_of(text); });
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
      figures("curves = [\"pdf\"]\nfits = [\"tail\"]\nwhere = { gamma = 1, cement = \"\", seed = 1 }").front(), table(),
      [&](const std::string&, const std::string&, const Figure&) { return test::numbers_of(text); });
  ASSERT_EQ(curves.size(), 2u);
  EXPECT_FALSE(curves[0].fit);
  ASSERT_TRUE(curves[1].fit);
  EXPECT_EQ(curves[1].points.x, (std::vector<double>{1, 3}));
  EXPECT_NEAR(curves[1].points.y[0], 5 * std::exp(-2), 1e-4);
  EXPECT_NEAR(curves[1].points.y[1], 5 * std::exp(-6), 1e-5);
  EXPECT_THROW(figures("curves = [\"a\", \"b\"]\nfits = [\"tail\"]"), InputError);
}

TEST(StudyFigures, AWrongKeyAndAMissingOneAreToldWithTheirLines) {
  try {
    figures("xx = 1\nx = \"gamma\"");
    FAIL();
  } catch (const InputError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("figures.toml:4"), std::string::npos) << text;
    EXPECT_NE(text.find("figures.0.xx: unknown key"), std::string::npos) << text;
    EXPECT_NE(text.find("curves, are needed"), std::string::npos) << text;
  }
  EXPECT_THROW(curves_of(figures("x = \"gamma\"\ny = [\"z\"]\nby = \"theta\"").front(), table(), none), InputError);
}

TEST(StudyPage, HoldsEveryFigureAndNoReferenceToOtherFiles) {
  const std::string page =
      study_page({"A <study>", figures("x = \"gamma\"\ny = [\"z\"]\nsource = \"</script>\""), table(), none});
  EXPECT_NE(page.find("A &lt;study>"), std::string::npos);
  EXPECT_NE(page.find("\"id\":\"f\""), std::string::npos);
  EXPECT_EQ(page.find("\"source\":\"</script>"), std::string::npos);
  EXPECT_EQ(page.find("src=\"http"), std::string::npos);
  EXPECT_EQ(page.find("__FIGURES__"), std::string::npos);
}

}  // namespace
}  // namespace arenite::report
