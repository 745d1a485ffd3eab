#include "thermal/imaging/circles.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "io/image/image.hpp"
#include "support/found_grains.hpp"
#include "support/pictures.hpp"

namespace {
using namespace arenite;
using namespace arenite::test;

TEST(Circles, AreBrightOrDarkAsThePictureSays) {
  const std::vector<DrawnDisk> disks{
      {30.2, 31.6, 9, 1, 0}, {48.2, 31.6, 9, 1, 0}, {39.2, 47.2, 9, 1, 0}, {75.4, 60.1, 9, 1, 0}};
  for (const double background : {0.0, 3.0}) {
    const imaging::FoundCircles found =
        imaging::find_circles(draw(disks, {.width = 110, .height = 90, .background = background, .noise = 0.01}));
    ASSERT_EQ(found.grains.size(), 4u) << background;
    EXPECT_EQ(found.report.bright, background < 1);
    EXPECT_LT(compare(disks, found.grains).rms, 0.02);
    EXPECT_NEAR(found.report.sizes.mean.at(0), 9, 0.05);
    EXPECT_EQ(found.report.materials.mean.size(), 1u);
  }
}

TEST(Circles, OfAKnownSizeAreFoundWithIt) {
  const std::vector<DrawnDisk> disks{{30.2, 31.6, 9, 1, 0}, {60.7, 40.3, 5, 1, 0}};  // listed by y
  const imaging::FoundCircles found =
      imaging::find_circles(draw(disks, {.width = 90, .height = 70, .noise = 0.01}),
                            {.radii = {5, 9}, .contrast = imaging::GrainContrast::bright});
  ASSERT_EQ(found.grains.size(), 2u);
  EXPECT_EQ(found.grains.size_class, (std::vector<std::int32_t>{1, 0}));
  EXPECT_EQ(found.report.sizes.members, (std::vector<std::size_t>{1, 1}));
}

TEST(Circles, MayBeBlackAndWhiteOnGreyAndTouch) {
  std::vector<DrawnDisk> disks;  // the brighter class is material 0
  for (int row = 0; row < 5; ++row)
    for (int column = 0; column < 6; ++column) {
      const int material = (3 * row + 2 * column) % 5 < 2 ? 1 : 0;
      disks.push_back(
          {30.3 + 16 * column + 8 * (row % 2), 28.6 + 13.8564 * row, 8, material == 0 ? 0.9 : 0.1, material});
    }
  disks.push_back({150.2, 40.4, 17, 0.1, 1});
  disks.push_back({155.1, 100.3, 17, 0.9, 0});
  const imaging::FoundCircles found =
      imaging::find_circles(draw(disks, {.width = 190, .height = 140, .background = 0.5, .noise = 0.01}));
  const Score score = compare(disks, found.grains);
  EXPECT_EQ(score.missed, 0);
  EXPECT_EQ(score.invented, 0);
  EXPECT_EQ(score.wrong_material, 0);
  EXPECT_LT(score.rms, 0.05);
  ASSERT_TRUE(found.report.between.has_value());
  EXPECT_NEAR(*found.report.between, 0.5, 0.02);
  ASSERT_EQ(found.report.sizes.mean.size(), 2u);
  EXPECT_NEAR(found.report.sizes.mean[0], 8, 0.05);
  EXPECT_NEAR(found.report.sizes.mean[1], 17, 0.05);
}

TEST(Circles, AreNotFoundInNoise) {
  EXPECT_EQ(imaging::find_circles(draw({}, {.width = 80, .height = 60, .noise = 0.1})).grains.size(), 0u);
}

TEST(Circles, RefusesPicturesThatShowNothing) {
  EXPECT_EQ(complaint([] { imaging::find_circles({}); }), "the picture is empty; give one that shows grains");
  EXPECT_NE(complaint([] {
              imaging::find_circles({2, 1, {1, 1}});
            }).find("all pixels of the picture are equal"),
            std::string::npos);
  EXPECT_NE(complaint([] {
              imaging::find_circles({2, 1, {1, std::numeric_limits<float>::quiet_NaN()}});
            }).find("not numbers"),
            std::string::npos);
}

}  // namespace
