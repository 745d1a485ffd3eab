#include <gtest/gtest.h>

#include "report/page.hpp"
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

TEST(Page, PartsWriteNumbersAndPlacesAsTheirTestsSay) {
  const auto outcome = test::shell("node --test " ARENITE_SOURCE_DIR "/web/test/parts.test.mjs");
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
}
