#include "workflow/measure_film.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "support/pictures.hpp"

namespace arenite::workflow {
namespace {

LockinMaps judged(double chance, double one_phase, double other_frequency = 0) {
  LockinMaps maps;
  maps.chance = chance;
  maps.one_phase = one_phase;
  maps.other_frequency = other_frequency;
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

}  // namespace
}  // namespace arenite::workflow
