#include <gtest/gtest.h>

#include <limits>

#include "thermal/thermography/grains/follow_grains.hpp"

namespace arenite::thermography {
namespace {

GrainMotion with_errors(std::vector<double> errors) {
  GrainMotion motion;
  motion.error = std::move(errors);
  return motion;
}

TEST(LostGrains, AreThoseFarBeyondTheUsualError) {
  EXPECT_EQ(lost_grains(with_errors({0.01, 0.011, 0.009, 0.012, 0.08, 0.05})),
            (std::vector<std::uint8_t>{0, 0, 0, 0, 1, 0}));
}

TEST(LostGrains, ScaleWithTheNoiseOfTheFilm) {
  for (const double noise : {1.0, 10.0, 1000.0})
    EXPECT_EQ(lost_grains(with_errors({0.01 * noise, 0.01 * noise, 0.02 * noise, 0.07 * noise, 0.01 * noise})),
              (std::vector<std::uint8_t>{0, 0, 0, 1, 0}));
}

TEST(LostGrains, WithoutContrastMoveWithTheRest) {
  const double unseen = std::numeric_limits<double>::infinity();
  EXPECT_EQ(lost_grains(with_errors({unseen, unseen, 0.01, unseen})), (std::vector<std::uint8_t>(4, 0)));
  EXPECT_EQ(lost_grains(with_errors({unseen, unseen})), (std::vector<std::uint8_t>(2, 0)));
  EXPECT_TRUE(lost_grains({}).empty());
}

}  // namespace
}  // namespace arenite::thermography
