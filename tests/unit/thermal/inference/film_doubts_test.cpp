#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "thermal/inference/film_doubts.hpp"

namespace arenite::inference {
namespace {

FilmGiven with_load() {
  FilmGiven given;
  given.load_peak_to_peak = 54e3;
  return given;
}

/// A result whose fit wants the factors so many times larger.
FilmResult wanting(double pom, double hdpe) {
  FilmResult r;
  r.pixel = 1.6e-3;
  r.maps.frequency = 3;
  r.packing.materials = {{"POM", 0, 0, 0.015e-6}, {"HDPE", 0, 0, 0.0258e-6}};
  r.packing.grains.resize(8);
  for (std::size_t g = 0; g < 8; ++g) r.packing.grains.material[g] = static_cast<std::int32_t>(g % 2);
  r.packing.contacts.add(0, 1, {1, 0}, 100, 0, 0.005, 0.005);
  r.fit.factor_scale = {pom, hdpe};
  r.fit.factor_scale_error = {0.01 * pom, 0.01 * hdpe};
  return r;
}

std::string all(const std::vector<std::string>& doubts) {
  std::string text;
  for (const auto& d : doubts) text += d + '\n';
  return text;
}

TEST(FilmDoubts, NothingIsSaidOfWhatAgrees) { EXPECT_EQ(all(film_doubts(with_load(), wanting(1.03, 0.98))), ""); }

TEST(FilmDoubts, MaterialsTakenForEachOtherAreNamed) {
  const double apart = 0.0258 / 0.015;
  EXPECT_NE(all(film_doubts(with_load(), wanting(apart, 1 / apart))).find("the two materials are probably swapped"),
            std::string::npos);
}

TEST(FilmDoubts, OneWrongFactorIsNamed) {
  const std::string said = all(film_doubts(with_load(), wanting(1, 0.7)));
  EXPECT_NE(said.find("ratio of the factors of POM and HDPE is 1.43 times"), std::string::npos) << said;
}

TEST(FilmDoubts, TheScaleOfForcesIsHeldAgainstTheLoad) {
  for (const double scale : {1 / 1.5, 0.5, 2.0})
    EXPECT_NE(all(film_doubts(with_load(), wanting(scale, scale))).find("the likely causes are load_peak_to_peak"),
              std::string::npos)
        << scale;
  EXPECT_THROW(film_doubts(with_load(), wanting(70, 70)), InputError);
  FilmGiven no_load = with_load();
  no_load.load_peak_to_peak = 0;
  EXPECT_EQ(all(film_doubts(no_load, wanting(2, 2))), "");
}

TEST(FilmDoubts, ADisagreementOfManyErrorsIsSaidHoweverSmall) {
  FilmGiven given = with_load();
  EXPECT_NE(all(film_doubts(given, wanting(0.91, 0.915))).find("given as 1.10 times"), std::string::npos);
  EXPECT_EQ(all(film_doubts(given, wanting(0.95, 0.955))),
            "");  // within three of the two per cent that factors are known to
  EXPECT_NE(all(film_doubts(given, wanting(0.94, 0.94))).find("given as 1.06 times"), std::string::npos)
      << "two materials that agree are known better than each";
  given.factor_error = 0.002;
  EXPECT_NE(all(film_doubts(given, wanting(0.95, 0.955))).find("given as 1.05 times"), std::string::npos);
  EXPECT_NE(all(film_doubts(given, wanting(0.95, 1.0))).find("ratio of the factors of HDPE and POM"),
            std::string::npos);
  given.fits_factors = true;  // they are those of the film
  EXPECT_EQ(all(film_doubts(given, wanting(0.95, 0.955))), "");
}

TEST(FilmDoubts, AContainerThatGrainsShowElsewhereIsNamedWithItsKey) {
  FilmGiven given = with_load();
  given.height = 0.1, given.travel = 1e-3;
  FilmResult r = wanting(1, 1);
  r.origin = {-0.01, 0.11}, r.walls.shift = {1.2e-3, -0.8e-3}, r.walls.shift_error = {1e-4, 1e-4};
  std::string said = all(film_doubts(given, r));
  // In the middle of the film: the left side was at (0 + 0.0088)/1.6e-3 = 5.50 and is at 6.25; the upper one was at
  // (0.1092 - 0.1)/1.6e-3 = 5.75, is at 6.25.
  EXPECT_NE(said.find("left side at column 6.25 (+- 0.06), not at 5.50 as in the middle of the film"),
            std::string::npos)
      << said;
  given.top = true;
  said = all(film_doubts(given, r));
  EXPECT_NE(said.find("upper side at row 6.25 (+- 0.06), not at 5.75 as container.top says"), std::string::npos)
      << said;
  r.walls = {};
  r.walls.smaller.x = 1e-3, r.walls.travel = 2e-3;
  said = all(film_doubts(given, r));
  EXPECT_NE(said.find("only if the container is 1 mm smaller than container.width says"), std::string::npos) << said;
  EXPECT_NE(said.find("the lower wall travels 2 mm, not 1 mm as container.travel says"), std::string::npos) << said;
  given.travel = 1.36e-3, r.walls.travel = 1.44e-3;
  EXPECT_NE(all(film_doubts(given, r)).find("travels 1.44 mm, not 1.36 mm"), std::string::npos);
}

TEST(FilmDoubts, AHaloAndUnevenEmissivitiesAreSaid) {
  FilmResult r = wanting(1, 1);
  r.halo = {0.1, 0.003, 4, 0.03}, r.fit.factor_scatter = 0.03;
  const std::string said = all(film_doubts(with_load(), r));
  EXPECT_NE(said.find("scatters 10 % (+- 0.3 %) of the light over about 4 pixels"), std::string::npos) << said;
  EXPECT_NE(said.find("differ by 3 %"), std::string::npos) << said;
  FilmGiven given = with_load();
  given.halo = true;
  EXPECT_EQ(all(film_doubts(given, r)).find("scatters"), std::string::npos);
}

TEST(FilmDoubts, AFitThatDoesNotAgreeIsNotMadeToAgreeInSilence) {
  FilmResult r = wanting(1, 1);
  r.fit.model_error = 0.3, r.fit.over_signal = 0.4, r.fit.over_noise = 12;
  EXPECT_NE(all(film_doubts(with_load(), r)).find("12 times the noise"), std::string::npos);
}

TEST(FilmDoubts, HeatThatDiffusesAndRimsOfAnotherBlurAreReported) {
  FilmResult r = wanting(1, 1);
  r.rim_blur = 0.8;
  r.maps.frequency = 0.05;
  const std::string said = all(film_doubts(with_load(), r));
  EXPECT_NE(said.find("not adiabatic"), std::string::npos);
  EXPECT_NE(said.find("forces.blur is 0.5"), std::string::npos);
}

}  // namespace
}  // namespace arenite::inference
