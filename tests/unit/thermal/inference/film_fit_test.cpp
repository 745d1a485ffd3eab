#include "thermal/inference/film_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace arenite::inference {
namespace {

const float none = std::nanf("");

FilmResult film_of(AmplitudeConvention convention) {
  FilmResult film;
  film.maps.convention = convention;
  film.maps.in_phase = {1, 2, none, 4};
  film.fit.picture = {3, 3, 1, none};
  return film;
}

TEST(FilmFit, IsComparedPeakToPeakInPixelsThatHaveBoth) {
  const FitMaps half = fit_maps(film_of(AmplitudeConvention::amplitude)),
                full = fit_maps(film_of(AmplitudeConvention::peak_to_peak));
  EXPECT_EQ(half.measured[1], 4);
  EXPECT_EQ(full.measured[1], 2);
  EXPECT_EQ(half.residual[0], -1);
  EXPECT_EQ(half.residual[1], 1);
  for (const auto& map : {half.measured, half.fitted, half.residual})
    EXPECT_TRUE(std::isnan(map[2]) && std::isnan(map[3]));
  EXPECT_DOUBLE_EQ(root_mean_square(half.residual), 1);
  EXPECT_DOUBLE_EQ(root_mean_square(half.fitted), 3);
  EXPECT_DOUBLE_EQ(root_mean_square(half.measured), std::sqrt(10));
}

TEST(FilmFit, IsEmptyWithoutForces) {
  FilmResult film = film_of(AmplitudeConvention::amplitude);
  film.fit.picture.clear();
  EXPECT_TRUE(fit_maps(film).residual.empty());
  EXPECT_TRUE(std::isnan(root_mean_square({})));
}

}  // namespace
}  // namespace arenite::inference
