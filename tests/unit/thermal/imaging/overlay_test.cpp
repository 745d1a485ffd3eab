#include "thermal/imaging/registration.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/drawn_picture.hpp"
#include "support/pictures.hpp"
#include "thermal/imaging/overlay.hpp"

namespace {
using namespace arenite;
using namespace arenite::test;

/// Equal disks that touch in rows, as in a crystal; one place in the last row is empty.
PictureGrains crystal(double radius, double left, double top) {
  PictureGrains grains;
  for (int row = 0; row < 9; ++row)
    for (int column = 0; column < 10; ++column) {
      if (row == 8 && column == 3) continue;
      grains.centre.push_back({left + radius * (2 * column + row % 2), top + radius * std::sqrt(3.0) * row});
      grains.radius.push_back(radius);
      grains.position_error.push_back(0.01);
    }
  return grains;
}

std::vector<DrawnDisk> disks_of(const PictureGrains& grains) {
  std::vector<DrawnDisk> disks;
  for (std::size_t i = 0; i < grains.size(); ++i)
    disks.push_back({grains.centre[i].x, grains.centre[i].y, grains.radius[i], 1, 0});
  return disks;
}

TEST(Overlay, FindsWhereACrystalLiesThatOnlyItsPoresShow) {
  const PictureGrains fine = crystal(13, 60, 70);
  const imaging::Similarity given{0.25, 0, {20, 15}, false};
  for (const double level : {0.0, 2.0}) {
    const imaging::Similarity truth{0.251, 0.012, {22.3, 13.6}, false};
    const FloatImage film =
        draw(disks_of(imaging::apply(truth, fine)), {.width = 120, .height = 100, .background = level, .noise = 0.01});
    const auto found = imaging::lay_over(fine, given, film);
    EXPECT_EQ(found.correlation > 0, level < 1);
    EXPECT_LT(found.rms, 0.15);
    EXPECT_GT(found.shift_error, 0);
    const PictureGrains there = imaging::apply(found.transform, fine), right = imaging::apply(truth, fine);
    double square = 0;
    for (std::size_t i = 0; i < there.size(); ++i)
      square +=
          (std::pow(there.centre[i].x - right.centre[i].x, 2) + std::pow(there.centre[i].y - right.centre[i].y, 2)) /
          2 / static_cast<double>(there.size());
    EXPECT_LT(std::sqrt(square), 0.03);
  }
}

TEST(Overlay, TellsThatAPictureIsOfSomethingElse) {
  const PictureGrains fine = crystal(13, 60, 70);
  const std::vector<DrawnDisk> other{{30, 30, 9, 1, 0}, {70, 55, 12, 1, 0}, {95, 20, 8, 1, 0}};
  const auto found =
      imaging::lay_over(fine, {0.25, 0, {20, 15}, false}, draw(other, {.width = 120, .height = 100, .noise = 0.01}));
  EXPECT_TRUE(std::abs(found.correlation) < 0.3 || found.rms > 0.5) << found.correlation << " " << found.rms;
}

TEST(Overlay, NeedsThreeCircles) {
  EXPECT_NE(complaint([] { imaging::lay_over({}, {}, {2, 1, {0, 1}}); }).find("three are needed"), std::string::npos);
}

}  // namespace
