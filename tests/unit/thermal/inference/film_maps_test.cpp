#include "thermal/inference/film_maps.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>

namespace arenite::inference {
namespace {

const FilmMap& map_named(std::string_view id) { return *std::ranges::find(film_maps(), id, &FilmMap::id); }

FilmResult two_pixels() {
  FilmResult film;
  film.film.width = 2, film.film.height = 1;
  film.picture = {300, 301};
  film.maps.in_phase = {0.1F, -0.1F};
  film.bad = {0, 0};
  return film;
}

TEST(FilmMaps, AreThereWhereTheFilmHasThem) {
  FilmResult film = two_pixels();
  EXPECT_EQ(values_of(map_named("picture"), film), film.picture);
  EXPECT_EQ(values_of(map_named("in_phase"), film), film.maps.in_phase);
  for (const char* none : {"amplitude", "phase", "fitted", "fit_residual", "bad"})
    EXPECT_TRUE(values_of(map_named(none), film).empty()) << none;
  film.bad[1] = 1;
  EXPECT_EQ(values_of(map_named("bad"), film), film.picture);
}

TEST(FilmMaps, SayTheirUnitByTheFilmAndTheirConvention) {
  FilmResult film = two_pixels();
  EXPECT_EQ(words_of(map_named("in_phase"), film)["unit"], Numbers("K"));
  EXPECT_EQ(title_of(map_named("in_phase"), film), "Warming with the load (half of peak to peak)");
  film.maps.convention = AmplitudeConvention::peak_to_peak;
  film.film.quantity = FilmQuantity::digital_level;
  EXPECT_EQ(title_of(map_named("amplitude"), film), "Amplitude (peak to peak)");
  EXPECT_EQ(words_of(map_named("in_phase"), film)["unit"], Numbers("DL"));
  EXPECT_EQ(words_of(map_named("phase"), film)["unit"], Numbers(""));
  EXPECT_EQ(words_of(map_named("phase"), film)["cyclic"], Numbers(true));
}

}  // namespace
}  // namespace arenite::inference
