#include "thermal/inference/force_certainty.hpp"

#include <gtest/gtest.h>

namespace arenite::inference {
namespace {

TEST(ForceCertainty, ContactsBelowNinetyFivePerCentAreDoubtful) {
  FilmResult film;
  for (int c = 0; c < 3; ++c) film.packing.contacts.add(0, 1, {1, 0}, 1, 0, 1, 1);
  EXPECT_EQ(doubtful_contacts(film), (std::vector<std::uint8_t>{0, 0, 0}));
  film.presence = {0.94, 0.95, 1};
  EXPECT_EQ(doubtful_contacts(film), (std::vector<std::uint8_t>{1, 0, 0}));
}

TEST(ForceCertainty, EveryRatioIsInABinAndThoseOutsideAreTold) {
  FilmResult film;
  const double forces[] = {1000, 60, 3, 0.2, -20};
  for (const double force : forces) film.packing.contacts.add(0, 1, {1, 0}, force, 0, 1, 1);
  film.fn_error = {2, 2, 2, 2, 2};
  film.presence = {1, 1, 0.5, 1, 1};
  const auto found = force_certainty(film);  // ratios 500, 30, 1.5, 0.1 and -10
  ASSERT_TRUE(found);
  EXPECT_EQ(statistics::total(found->there_and_doubtful[0]), 4);
  EXPECT_EQ(statistics::total(found->there_and_doubtful[1]), 1);
  EXPECT_EQ(found->below, 1u);
  EXPECT_EQ(found->beyond, 1u);
  EXPECT_GE(found->there_and_doubtful[0].front(), 1);
  EXPECT_GE(found->there_and_doubtful[0].back(), 1);
  for (std::size_t b = 0; b < found->bins.count; ++b) {
    const bool here = found->bins.edge(b) <= 1.5 && 1.5 < found->bins.edge(b + 1);
    EXPECT_EQ(found->there_and_doubtful[1][b], here ? 1 : 0);
  }
  film.fn_error.clear();
  EXPECT_FALSE(force_certainty(film));
}

TEST(ForceCertainty, BinsAreFewWhateverTheNumbers) {
  for (const double far : {30.0, 1e4, 1e9, 1e300}) {
    const statistics::Bins bins = certainty_bins({-3.0, 0.0, far, far});
    EXPECT_TRUE(bins.count > 2 && bins.count < 50) << bins.count;
    EXPECT_GE(bins.edge(bins.count), far * (1 - 1e-12));
  }
}

}  // namespace
}  // namespace arenite::inference
