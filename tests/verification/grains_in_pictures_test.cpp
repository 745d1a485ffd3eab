#include <gtest/gtest.h>

#include <string>

#include "io/image/image.hpp"
#include "support/found_grains.hpp"
#include "thermal/imaging/circles.hpp"

namespace {
using namespace arenite;
using namespace arenite::test;

class ThesisSample : public ::testing::TestWithParam<std::string> {};

TEST_P(ThesisSample, IsFoundToATenthOfAPixelAtTheThesisPixel) {
  std::vector<DrawnDisk> disks = packing_in_pixels(GetParam(), 1.6e-3, 50, 228);
  for (DrawnDisk& d : disks) d.level = d.material == 0 ? 1.0 : 0.7;
  const imaging::FoundCircles found =
      imaging::find_circles(draw(disks, {.noise = 0.02}), {.contrast = imaging::GrainContrast::bright});
  const Score score = compare(disks, found.grains);
  EXPECT_EQ(score.missed, 0);
  EXPECT_EQ(score.invented, 0);
  EXPECT_EQ(score.wrong_material, 0);
  EXPECT_LT(score.rms, 0.03);
  EXPECT_GT(score.errors, 0.7);
  EXPECT_LT(score.errors, 1.5);
  EXPECT_EQ(found.report.materials.mean.size(), 2u);
}

INSTANTIATE_TEST_SUITE_P(Of, ThesisSample, ::testing::Values("sample-02", "sample-02-other", "sample-08", "sample-12"),
                         [](const auto& one) {
                           return one.param == "sample-02-other" ? std::string("02_other") : one.param.substr(7);
                         });

/// examples/data/photoelastic-disks/README.md counts them by eye.
TEST(PhotoelasticDisks, AreAllFoundInTheirTwoSizesAndNoneInvented) {
  const Image image =
      io::read_image(std::string(ARENITE_SOURCE_DIR) + "/examples/data/photoelastic-disks/Step09-0001.jpg",
                     {.channel = io::Channel::red});
  const imaging::FoundCircles found =
      imaging::find_circles(to_float(image), {.contrast = imaging::GrainContrast::bright});
  ASSERT_EQ(found.report.sizes.members, (std::vector<std::size_t>{15, 14}));
  EXPECT_NEAR(found.report.sizes.mean[0], 50, 3);
  EXPECT_NEAR(found.report.sizes.mean[1], 73, 2);
  EXPECT_EQ(found.report.overlapping, 0u);
}

}  // namespace
