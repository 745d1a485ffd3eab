#include "model/film_place.hpp"

#include <gtest/gtest.h>

namespace arenite {
namespace {

TEST(FilmPlace, AContainerIsInTheMiddleOfThePictureUnlessItsEdgesAreGiven) {
  // 71 x 41 pixels of 2 mm, middle in column 35 of row 20; a container of 100 x 60 mm is 50 x 30 of them.
  const FilmPlace middle = place_of_container(71, 41, 2e-3, {0.1, 0.06});
  EXPECT_NEAR(norm(middle.metres({35, 20}) - Vec2{0.05, 0.03}), 0, 1e-15);
  EXPECT_NEAR(norm(middle.metres({10, 35})), 0, 1e-15);
  const FilmPlace given = place_of_container(71, 41, 2e-3, {0.1, 0.06}, 3, 4);
  EXPECT_NEAR(norm(given.metres({3, 4}) - Vec2{0, 0.06}), 0, 1e-15);
  const FilmPlace one = place_of_container(71, 41, 2e-3, {0.1, 0.06}, {}, 4);
  EXPECT_NEAR(norm(one.metres({10, 4}) - Vec2{0, 0.06}), 0, 1e-15);
}

}  // namespace
}  // namespace arenite
