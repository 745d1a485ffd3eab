#include "workflow/run_film.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace arenite;

namespace {

/// A film of four grains in a row, all of one material and away from each other.
FilmResult four(const std::vector<double>& film, const std::vector<double>& simulation) {
  FilmResult r;
  r.pixel = 1e-3;
  r.packing.materials = {{"POM", 1400, 1e7, 0}};
  r.packing.domain.wall[right].position = r.packing.domain.wall[top].position = 0.1;
  r.packing.grains.resize(4);
  for (std::size_t g = 0; g < 4; ++g) {
    r.packing.grains.position[g] = {0.02 * static_cast<double>(g + 1), 0.05};
    r.packing.grains.radius[g] = 0.005;
  }
  r.peak_to_peak.sigma_hyd = film;
  r.simulation.peak_to_peak = simulation;
  return r;
}

}  // namespace

TEST(FilmStresses, AreTakenOverTheMeanOfTheGrainsThatCount) {
  texture::Options options;
  options.border = 0;
  const auto stresses = workflow::film_stresses(four({-1e5, -2e5, -3e5, -2e5}, {-1e5, -1e5, -4e5, -2e5}), options);
  ASSERT_EQ(stresses.sources.size(), 2u);
  EXPECT_NEAR(stresses.sources[0].mean, -2e5, 1e-6);
  EXPECT_NEAR(stresses.sources[0].sigma_norm[2], 1.5, 1e-12);
  EXPECT_NEAR(stresses.sources[1].sigma_norm[2], 2.0, 1e-12);
}

TEST(FilmStresses, LeaveOutGrainsThatOneSourceDoesNotKnow) {
  texture::Options options;
  options.border = 0;
  const auto stresses = workflow::film_stresses(four({-1e5, NAN, -3e5, -2e5}, {-1e5, -9e5, -4e5, -4e5}), options);
  EXPECT_TRUE(std::isnan(stresses.sources[1].sigma_hyd[1]));
  EXPECT_NEAR(stresses.sources[1].mean, -3e5, 1e-6);
  EXPECT_EQ(stresses.considered, (std::vector<std::uint8_t>{1, 0, 1, 1}));
}

TEST(FilmStresses, KeepTheBorderOutWhereSomethingIsLeft) {
  texture::Options options;
  options.border = 2.5;  // mean diameters of 10 mm: 25 mm along each side of a box of 100 mm
  EXPECT_EQ(workflow::film_stresses(four({-1, -2, -3, -4}, {}), options).considered, (std::vector<std::uint8_t>{0, 1, 1, 0}));
  options.border = 6;
  EXPECT_EQ(workflow::film_stresses(four({-1, -2, -3, -4}, {}), options).considered, (std::vector<std::uint8_t>{1, 1, 1, 1}));
}

TEST(FilmStresses, OfAFilmThatIsTwiceItsSimulationAgreeWithSlopeTwo) {
  const FilmResult r = four({-2e5, -4e5, -6e5, -8e5}, {-1e5, -2e5, -3e5, -4e5});
  texture::Options options;
  options.border = 0;
  const auto stresses = workflow::film_stresses(r, options);
  const auto all = workflow::stress_relations(r.packing, stresses.sources[0], stresses.sources[1]);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].relation.count, 4u);
  EXPECT_NEAR(all[0].relation.pearson.value, 1, 1e-12);
  EXPECT_NEAR(all[0].relation.line.slope, 2, 1e-12);
  EXPECT_NEAR(all[0].rms, std::sqrt(30.0 / 4) * 1e5, 1e-4);
  EXPECT_NEAR(all[0].rms_norm, 0, 1e-12);
}
