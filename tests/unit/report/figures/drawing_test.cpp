#include "report/figures/drawing.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <set>
#include <vector>

#include "report/figure_heads.hpp"
#include "report/figures/figure_document.hpp"
#include "report/figures/roses.hpp"

using namespace arenite;
using namespace arenite::report::figures;

TEST(Drawing, WritesANumberAndItsErrorToTheErrorsSecondDigit) {
  EXPECT_EQ(in_words(said("z", {0.123456, 0.02891})), "z = 0.123 \u00b1 0.029");
  EXPECT_EQ(in_words(said("z", {98.63, 6.72})), "z = 98.6 \u00b1 6.7");
  EXPECT_EQ(in_words(said("z", {1281.4, 50.2})), "z = 1281 \u00b1 50");
  EXPECT_EQ(in_words(said("a", {-1.2345, 0.01})), "a = \u22121.234 \u00b1 0.010");
  EXPECT_EQ(in_words(said("a", {3.14159})), "a = 3.142");
  EXPECT_EQ(in_words(said("a", {1, 7e-16})), "a = 1.000");
  EXPECT_EQ(rounded(1.5e-7, 2), "1.5\u00b710\u207b\u2077");
  EXPECT_EQ(rounded(2.5e6, 2), "2.5\u00b710\u2076");
  EXPECT_EQ(counted(1234567), "1\u202f234\u202f567");
}

TEST(Drawing, QuantitiesTakeThePrefixThatSuitsThem) {
  EXPECT_EQ(scale_of(50000, "N").unit, "kN");
  EXPECT_EQ(scale_of({-1.876e6, 2e5}, "Pa").factor, 1e6);
  EXPECT_EQ(scale_of(0.02, "m").unit, "mm");
  EXPECT_EQ(scale_of(0, "N").unit, "N");
  EXPECT_EQ(scale_of(999.9, "N").unit, "kN");
  EXPECT_EQ(scale_of(3, "kg/m^3").unit, "kg/m\u00b3");
  EXPECT_EQ(scale_of(3, "1").unit, "");
}

TEST(Drawing, EveryFigureHasItsNamesTitleAndCaption) {
  for (const auto& heads : {packing_heads(), field_heads(), voxel_heads(), sphere_heads(), film_heads()}) {
    std::set<std::string> ids, names;
    for (const Head& head : heads) {
      EXPECT_TRUE(ids.insert(head.id).second) << head.id;
      EXPECT_TRUE(names.insert(head.name).second) << head.name;
      EXPECT_FALSE(head.title.empty()) << head.id;
      EXPECT_TRUE(head.caption.whole().ends_with(".")) << head.id;
    }
  }
}

TEST(Drawing, TheLineOfARoseIsTheDistributionOfSecondOrder) {
  const Numbers set{{"contacts", 80},
                    {"a_c", {{"value", 0.3}, {"error", 0.01}}},
                    {"theta_c_deg", {{"value", 30}, {"error", 1}}},
                    {"a_c_noise", 0.1},
                    {"sectors", {20, 20, 20, 20}}};
  const std::vector<double> line = rose_of("all", "line 0", set, nullptr).line;
  const auto at = [&](int degrees) { return line.at(line.size() * static_cast<std::size_t>(degrees) / 180); };
  EXPECT_NEAR(at(30), 1.3, 1e-12);
  EXPECT_NEAR(at(120), 0.7, 1e-12);
  EXPECT_NEAR(at(75), 1, 1e-12);
  EXPECT_NEAR(at(0), 1.15, 1e-12);
}

TEST(Drawing, SectorsOfARoseAreOverTheIsotropicNumberOfAll) {
  const Numbers all{{"contacts", 80}, {"sectors", {35, 15, 10, 20}}},
      strong{{"contacts", 20}, {"sectors", {10, 5, 0, 5}}};
  const Rose rose = rose_of("all", "line 0", all, &strong);
  EXPECT_EQ(rose.sectors, (std::vector<double>{1.75, 0.75, 0.5, 1}));
  EXPECT_EQ(rose.inner, (std::vector<double>{0.5, 0.25, 0, 0.25}));
  EXPECT_EQ(rose.reach, 1.75);
}

TEST(Drawing, EqualListsStandInAPageOnce) {
  report::NumberBlock block;
  PageLists lists(block);
  const std::vector<double> values{1, 2, 3, 4, 5, 6, 7, 8}, others{1, 2, 3, 4, 5, 6, 7, 9};
  EXPECT_EQ(lists(values), lists(values));
  EXPECT_NE(lists(values), lists(others));
  EXPECT_EQ(block.size(), 16 * sizeof(float));
  EXPECT_EQ(lists({1, 2}), Numbers::list({1, 2}));
}
