#include "study/film_numbers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <rapidcheck/gtest.h>

#include "support/film_page_sample.hpp"

namespace arenite::study {
namespace {

const std::vector<std::uint8_t> all{1, 1, 1, 1};

TEST(FilmNumbers, AgreementOfAStressWithItself) {
  const std::vector<double> stress{-1e6, -2e6, -4e6, -5e6};
  const Agreement a = agreement(stress, stress, all);
  EXPECT_EQ(a.grains, 4u);
  EXPECT_NEAR(a.correlation, 1, 1e-15);
  EXPECT_EQ(a.rms_sigma_norm, 0);
  EXPECT_NEAR(a.slope, 1, 1e-15);
}

TEST(FilmNumbers, AgreementByHand) {
  // Over their means 3 and 2: {1/3, 5/3} and {1/2, 3/2}, off by 1/6 each; slope (1 + 15)/(1 + 9).
  const Agreement a = agreement({-1, -5}, {-1, -3}, {1, 1});
  EXPECT_NEAR(a.rms_sigma_norm, 1.0 / 6, 1e-15);
  EXPECT_NEAR(a.slope, 1.6, 1e-15);
  EXPECT_NEAR(a.correlation, 1, 1e-15);
  EXPECT_NEAR(agreement({1, 2, 3, 2}, {3, 2, 1, 2}, all).correlation, -1, 1e-15);
}

TEST(FilmNumbers, AgreementLeavesOutWhatDoesNotCountOrIsUnknown) {
  const Agreement a = agreement({-1, -5, -100, NAN}, {-1, -3, 7, -2}, {1, 1, 0, 1});
  EXPECT_EQ(a.grains, 2u);
  EXPECT_NEAR(a.slope, 1.6, 1e-15);
  EXPECT_EQ(agreement({-1}, {-1}, {1}).correlation, 0);
}

RC_GTEST_PROP(FilmNumbers, AgreementInSigmaNormKnowsNoScale, (int seed)) {
  RandomStream random(static_cast<std::uint64_t>(seed), Purpose::test, 3);
  std::vector<double> one, other, scaled;
  for (int i = 0; i < 4; ++i) {
    one.push_back(-1 - random.uniform());
    other.push_back(-1 - random.uniform());
    scaled.push_back(7 * other.back());
  }
  const Agreement a = agreement(one, other, all), b = agreement(one, scaled, all);
  RC_ASSERT(std::abs(a.rms_sigma_norm - b.rms_sigma_norm) < 1e-12);
  RC_ASSERT(std::abs(a.correlation - b.correlation) < 1e-9);
  RC_ASSERT(std::abs(a.slope - 7 * b.slope) < 1e-12);
}

TEST(FilmNumbers, TellWhatTheResultHolds) {
  const test::FilmPageSample sample(60, 4e-3);
  const FilmResult& film = sample.film;
  const auto j = nlohmann::json::parse(film_numbers(film));
  EXPECT_EQ(j["film"]["bad_pixels"], 2);
  EXPECT_EQ(j["lockin"]["swing"], "half");
  EXPECT_EQ(j["grains"]["all"], 60);
  EXPECT_NEAR(j["grains"]["position_error_pixels"].get<double>(), 0.06, 1e-12);
  double largest = 0;
  for (std::size_t i = 0; i < film.motion.size(); ++i) largest = std::max(largest, 2 * std::hypot(film.motion.cos_x[i], film.motion.cos_y[i]));
  EXPECT_NEAR(j["motion"]["largest_travel_pixels"].get<double>(), largest, 1e-9);
  EXPECT_EQ(j["forces"]["proposed"], film.packing.contacts.size());
  EXPECT_EQ(j["forces"]["absent"].get<std::size_t>(), static_cast<std::size_t>(std::count(film.absent.begin(), film.absent.end(), 1)));
  FilmResult maps = film;
  maps.swing = {};
  EXPECT_FALSE(nlohmann::json::parse(film_numbers(maps)).contains("texture"));
}

}  // namespace
}  // namespace arenite::study
