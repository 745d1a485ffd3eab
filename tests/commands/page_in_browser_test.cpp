#include <gtest/gtest.h>

#include "report/page.hpp"
#include "report/study_page.hpp"
#include "support/field_page_sample.hpp"
#include "support/film_page_sample.hpp"
#include "support/page_sample.hpp"
#include "support/program.hpp"

using namespace arenite;

TEST(Page, IsPaintedAndAnswersInABrowserFromTheDisk) {
  const test::TemporaryFolder folder;
  const test::PageSample sample;
  report::write_page(folder / "page.html", sample.data);
  const auto outcome = test::shell("node " ARENITE_SOURCE_DIR "/web/test/page.test.mjs " + (folder / "page.html").string());
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
}

TEST(Page, OfACementedSampleIsPaintedAndAnswersInABrowser) {
  const test::TemporaryFolder folder;
  const test::FieldPageSample sample;
  report::write_page(folder / "page.html", sample.data);
  const auto outcome = test::shell("node " ARENITE_SOURCE_DIR "/web/test/field_page.test.mjs " + (folder / "page.html").string());
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
}

TEST(Page, OfAFilmIsPaintedAndAnswersInABrowser) {
  const test::TemporaryFolder folder;
  const test::FilmPageSample sample;
  report::write_page(folder / "page.html", sample.data);
  const auto outcome = test::shell("node " ARENITE_SOURCE_DIR "/web/test/film_page.test.mjs " + (folder / "page.html").string());
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
}

TEST(Page, OfAStudyIsPaintedInABrowser) {
  const test::TemporaryFolder folder;
  study::CollectedTable table;
  table.keys = {{"gamma", ""}, {"width", ""}, {"seed", ""}};
  table.names = {"z"};
  for (const char* gamma : {"1", "5"})
    for (const char* width : {"", "0.2"})
      for (const char* seed : {"1", "2"})
        table.rows.push_back({seed, "done", {gamma, width, seed}, 1, {study::Estimate{10 + std::stod(gamma) + std::stod(seed), {}}}});
  const auto figures = report::read_figures(
      "[[figures]]\nid = \"points\"\ntitle = \"Points\"\nx = \"gamma\"\ny = [\"z\"]\nby = \"width\"\nby_label = \"\u03b7\"\nby_empty = \"full\"\n"
      "x_label = \"gamma\"\nreferences = [ { y = 15, label = \"source: 15\" } ]\n"
      "[[figures]]\nid = \"density\"\ntitle = \"Density\"\ncurves = [\"pdf\"]\n",
      "figures.toml");
  report::write_study_page(folder / "study.html", {"A study", figures, table, [](const std::string&) { return R"({"pdf":{"low":0,"width":1,"density":[0.2,0.5,0.3]}})"; }});
  const auto outcome = test::shell("node " ARENITE_SOURCE_DIR "/web/test/study_page.test.mjs " + (folder / "study.html").string());
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
}

TEST(Page, PartsWriteNumbersAndPlacesAsTheirTestsSay) {
  const auto outcome = test::shell("node --test " ARENITE_SOURCE_DIR "/web/test/parts.test.mjs");
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
}
