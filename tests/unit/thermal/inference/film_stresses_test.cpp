#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "core/random.hpp"
#include "thermal/inference/film_stresses.hpp"
#include "workflow/film/film_numbers.hpp"

using namespace arenite;
using namespace arenite::inference;
using workflow::film_numbers;
using workflow::texture_of;

namespace {

const std::vector<std::uint8_t> all_four{1, 1, 1, 1};

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
  r.peak_to_peak.sigma_hyd = r.peak_to_peak.temperature = r.peak_to_peak.error = film;
  r.simulation.peak_to_peak = simulation;
  return r;
}

}  // namespace

TEST(FilmStresses, AreTakenOverTheMeanOfTheGrainsThatCount) {
  const auto stresses = film_stresses(four({-1e5, -2e5, -3e5, -2e5}, {-1e5, -1e5, -4e5, -2e5}), all_four);
  ASSERT_EQ(stresses.sources.size(), 2u);
  EXPECT_NEAR(stresses.sources[0].mean, -2e5, 1e-6);
  EXPECT_NEAR(stresses.sources[0].sigma_norm[2], 1.5, 1e-12);
  EXPECT_NEAR(stresses.sources[1].sigma_norm[2], 2.0, 1e-12);
}

TEST(FilmStresses, LeaveOutGrainsThatOneSourceDoesNotKnow) {
  const auto stresses = film_stresses(four({-1e5, NAN, -3e5, -2e5}, {-1e5, -9e5, -4e5, -4e5}), all_four);
  EXPECT_TRUE(std::isnan(stresses.sources[1].sigma_hyd[1]));
  EXPECT_NEAR(stresses.sources[1].mean, -3e5, 1e-6);
  EXPECT_EQ(stresses.considered, (std::vector<std::uint8_t>{1, 0, 1, 1}));
}

TEST(FilmStresses, CountWhereTheTextureDoesUnlessThatLeavesTooFewToCompare) {
  const std::vector<std::uint8_t> inner{0, 1, 1, 1};
  EXPECT_EQ(film_stresses(four({-1, -2, -3, -4}, {}), inner).considered, inner);
  EXPECT_EQ(film_stresses(four({-1, NAN, -3, -4}, {}), inner).considered, (std::vector<std::uint8_t>{1, 0, 1, 1}));
}

TEST(FilmStresses, HaveTheTexturesStatisticsWhereNoSourceKnowsLess) {
  auto whole = four({-1e5, -2e5, -3e5, -2e5}, {-1e5, -1e5, -4e5, -2e5}),
       less = four({-1e5, -2e5, -3e5, -2e5}, {-1e5, NAN, -4e5, -2e5});
  for (FilmResult* film : {&whole, &less})
    film->packing.domain.wall[left].position = -0.1, film->packing.domain.wall[right].position = 0.2;
  const texture::Texture texture = texture_of(whole);
  const Numbers numbers = film_numbers(whole, texture);
  EXPECT_EQ(numbers["stresses"]["film"], texture.numbers["sigma_norm"]);
  EXPECT_EQ(numbers["stresses"]["film"], texture::stress_distribution(whole.packing, whole.peak_to_peak.sigma_hyd));
  EXPECT_EQ(film_numbers(less, texture)["stresses"]["film"]["count"].get<int>(), 3);
  EXPECT_NEAR(numbers["agreement"]["simulation_peak_to_peak"]["all"]["rms_Pa"].get<double>(), std::sqrt(2.0 / 4) * 1e5,
              1e-4);
}

TEST(FilmStresses, OfAFilmThatIsTwiceItsSimulationAgreeWithSlopeTwo) {
  const FilmResult r = four({-2e5, -4e5, -6e5, -8e5}, {-1e5, -2e5, -3e5, -4e5});
  const auto stresses = film_stresses(r, all_four);
  const Numbers sets = agreement_of(r.packing, stresses, stresses.sources[1]);
  ASSERT_EQ(sets.size(), 1u);
  EXPECT_EQ(sets["all"]["count"].get<int>(), 4);
  EXPECT_NEAR(sets["all"]["correlation"]["value"].get<double>(), 1, 1e-12);
  EXPECT_NEAR(sets["all"]["slope"]["value"].get<double>(), 2, 1e-12);
  EXPECT_NEAR(sets["all"]["rms_Pa"].get<double>(), std::sqrt(30.0 / 4) * 1e5, 1e-4);
  EXPECT_NEAR(sets["all"]["rms_sigma_norm"].get<double>(), 0, 1e-12);
}

TEST(FilmAgreement, OfAStressWithItself) {
  const std::vector<double> stress{-1e6, -2e6, -4e6, -5e6};
  const Agreement a = agreement(stress, stress, all_four);
  EXPECT_EQ(a.relation.count, 4u);
  EXPECT_NEAR(a.relation.pearson.value, 1, 1e-15);
  EXPECT_EQ(a.rms, 0);
  EXPECT_EQ(a.rms_sigma_norm, 0);
  EXPECT_NEAR(a.relation.line.slope, 1, 1e-15);
}

TEST(FilmAgreement, ByHand) {
  // Over their means 3 and 2: {1/3, 5/3} and {1/2, 3/2}, off by 1/6 each.
  const Agreement two = agreement({-1, -5}, {-1, -3}, {1, 1});
  EXPECT_NEAR(two.rms_sigma_norm, 1.0 / 6, 1e-15);
  EXPECT_NEAR(two.rms, std::sqrt(2.0), 1e-15);
  EXPECT_NEAR(two.relation.pearson.value, 1, 1e-15);
  // About their means (2, 4): products 2 + 0 + 1 over squares 1 + 0 + 1.
  EXPECT_NEAR(agreement({2, 4, 5}, {1, 2, 3}, {1, 1, 1}).relation.line.slope, 1.5, 1e-15);
  EXPECT_NEAR(agreement({1, 2, 3, 2}, {3, 2, 1, 2}, all_four).relation.pearson.value, -1, 1e-15);
}

TEST(FilmAgreement, LeavesOutWhatDoesNotCountOrIsUnknown) {
  const Agreement a = agreement({-1, -5, -100, NAN}, {-1, -3, 7, -2}, {1, 1, 0, 1});
  EXPECT_EQ(a.relation.count, 2u);
  EXPECT_NEAR(a.rms_sigma_norm, 1.0 / 6, 1e-15);
  EXPECT_TRUE(std::isnan(agreement({-1}, {-1}, {1}).rms));
}

RC_GTEST_PROP(FilmAgreement, InSigmaNormKnowsNoScale, (int seed)) {
  RandomStream random(static_cast<std::uint64_t>(seed), Purpose::test, 3);
  std::vector<double> one, other, scaled;
  for (int i = 0; i < 4; ++i) {
    one.push_back(-1 - random.uniform());
    other.push_back(-1 - random.uniform());
    scaled.push_back(7 * other.back());
  }
  const Agreement a = agreement(one, other, all_four), b = agreement(one, scaled, all_four);
  RC_ASSERT(std::abs(a.rms_sigma_norm - b.rms_sigma_norm) < 1e-12);
  RC_ASSERT(std::abs(a.relation.pearson.value - b.relation.pearson.value) < 1e-9);
  RC_ASSERT(std::abs(a.relation.line.slope - 7 * b.relation.line.slope) < 1e-9 * std::abs(a.relation.line.slope));
}
