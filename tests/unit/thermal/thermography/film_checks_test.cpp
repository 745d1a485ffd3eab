#include <gtest/gtest.h>

#include <numbers>
#include <optional>

#include "core/error.hpp"
#include "support/pictures.hpp"
#include "thermal/thermography/film_checks.hpp"

namespace arenite::thermography {
namespace {

LockinMaps judged(double chance, double one_phase, double other_frequency = 0) {
  LockinMaps maps;
  maps.chance = chance;
  maps.one_phase = one_phase;
  maps.other_frequency = other_frequency;
  return maps;
}

LockinMaps oscillating(double phase) {
  LockinMaps maps;
  maps.width = maps.height = 4;
  maps.mean.assign(16, 296);
  maps.amplitude.assign(16, 0.05f), maps.phase.assign(16, static_cast<float>(phase)),
      maps.standard_error.assign(16, 1e-4f);
  return maps;
}

TEST(FilmChecks, RefusesAFilmWithoutALoadAndSaysWhy) {
  EXPECT_NO_THROW(refuse_without_load(judged(1e-6, 0.9), 3));
  EXPECT_NE(test::complaint([] {
              refuse_without_load(judged(0.3, 0.9), 3);
            }).find("the film shows only noise at 3 Hz; give the frequency"),
            std::string::npos);
  EXPECT_NE(test::complaint([] { refuse_without_load(judged(1e-6, 0.1), 3); }).find("does not have a common phase"),
            std::string::npos);
  EXPECT_NE(test::complaint([] { refuse_without_load(judged(0.3, 0, 3.5), 3); }).find("oscillation at 3.5 Hz"),
            std::string::npos);
}

TEST(FilmChecks, PhaseIsHeldAgainstTheFilmsOwn) {
  const double turn = 2 * std::numbers::pi;
  EXPECT_NEAR(phase_off(oscillating(0.4 * turn), 0.3), 0.1, 1e-6);
  EXPECT_NEAR(phase_off(oscillating(0.45 * turn), -0.5), -0.05, 1e-6);
  const double given = 0.25 * turn;
  EXPECT_THROW(refuse_wrong_phase(oscillating(0.5 * turn), given), InputError);
  EXPECT_THROW(refuse_wrong_phase(oscillating(0.75 * turn), given), InputError);
  EXPECT_NO_THROW(refuse_wrong_phase(oscillating(0.3 * turn), given));
  EXPECT_NO_THROW(refuse_wrong_phase(oscillating(0.5 * turn), std::nullopt));
}

TEST(FilmChecks, LevelsAreNoKelvin) {
  LockinMaps levels = oscillating(0);
  levels.mean.assign(16, 7800);
  EXPECT_THROW(refuse_impossible(levels), InputError);
  levels = oscillating(0);
  levels.amplitude.assign(16, 30);
  EXPECT_THROW(refuse_impossible(levels), InputError);
}

}  // namespace
}  // namespace arenite::thermography
