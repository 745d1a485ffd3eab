#include "report/page.hpp"

#include <gtest/gtest.h>

#include "support/page_sample.hpp"
#include "support/program.hpp"

using namespace arenite;

TEST(Page, ATitleMayBeAMarkOfTheTemplate) {
  const test::PageSample sample(60);
  report::PageData data = sample.data;
  data.title = "__DOCUMENT__ and __NUMBERS__";
  const std::string page = report::page(data), usual = report::page(sample.data);
  EXPECT_NE(page.find("<title>__DOCUMENT__ and __NUMBERS__</title>"), std::string::npos);
  EXPECT_GT(page.size(), usual.size() - 200);
  EXPECT_LT(page.size(), usual.size() + 200);
}

TEST(Page, IsOneFileThatAsksNobodyForAnything) {
  const test::PageSample sample(60);
  const std::string html = report::page(sample.data);
  for (const char* outside : {"src=\"http", "href=\"http", "@import", "url(http", "<link rel=\"stylesheet\""})
    EXPECT_EQ(html.find(outside), std::string::npos) << outside;
}

TEST(Page, QuotesItsTitle) {
  const test::PageSample sample(60);
  EXPECT_NE(report::page(sample.data).find("<title>Two materials &lt;in> a container</title>"), std::string::npos);
}

TEST(Page, IsTheSameBytesForTheSameData) {
  const test::PageSample one(60), two(60);
  EXPECT_EQ(report::page(one.data), report::page(two.data));
}

TEST(Page, StaysSmallForASampleOfAThesis) {
  const test::PageSample sample(705);
  EXPECT_LT(report::page(sample.data).size(), 1'500'000u);
}

TEST(Page, IsWrittenWhole) {
  const test::TemporaryFolder folder;
  const test::PageSample sample(60);
  report::write_page(folder / "page.html", sample.data);
  EXPECT_EQ(test::slurp(folder / "page.html"), report::page(sample.data));
}
