#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>

#include "report/field_codes.hpp"
#include "report/film_stresses.hpp"
#include "report/page_document.hpp"
#include "support/film_page_sample.hpp"

using namespace arenite;
using Json = nlohmann::json;

namespace {

const test::FilmPageSample& sample() {
  static const test::FilmPageSample made(120, 3e-3);
  return made;
}

Json document_of(const FilmResult& film) { return Json::parse(report::page_document({"film", {}, {}, {}, {{&film, {}}}}).json)["films"][0]; }

/// A film of four grains in a row, all of one material and away from each other.
FilmResult four(const std::vector<double>& film, const std::vector<double>& twin) {
  FilmResult r;
  r.pixel = 1e-3;
  r.packing.materials = {{"POM", 1400, 1e7, 0}};
  r.packing.domain.wall[right].position = r.packing.domain.wall[top].position = 0.1;
  r.packing.grains.resize(4);
  for (std::size_t g = 0; g < 4; ++g) {
    r.packing.grains.x[g] = 0.02 * static_cast<double>(g + 1);
    r.packing.grains.y[g] = 0.05;
    r.packing.grains.radius[g] = 0.005;
  }
  r.swing.sigma_hyd = film;
  r.twin.swing = twin;
  return r;
}

}  // namespace

TEST(FilmDocument, HoldsEveryMapThatTheResultHas) {
  const Json film = document_of(sample().film);
  const std::size_t pixels = sample().film.film.pixels();
  for (const char* name : {"picture", "amplitude", "phase", "in_phase", "second_harmonic", "standard_error", "residual"})
    EXPECT_EQ(film["maps"][name]["residual"]["n"], pixels) << name;
  EXPECT_EQ(film["bad"]["n"], 2);
  FilmResult bare = sample().film;
  bare.maps.second_harmonic.clear();
  bare.picture.clear();
  EXPECT_FALSE(document_of(bare)["maps"].contains("second_harmonic"));
  EXPECT_FALSE(document_of(bare)["maps"].contains("picture"));
}

TEST(FilmDocument, ListsPixelsWithoutAValue) {
  FilmResult holed = sample().film;
  holed.maps.in_phase[7] = holed.maps.in_phase[11] = std::nanf("");
  const Json film = document_of(holed);
  EXPECT_EQ(film["maps"]["in_phase"]["holes"]["n"], 2);
  EXPECT_FALSE(film["maps"]["amplitude"].contains("holes"));
}

TEST(FilmDocument, PutsGrainsWithoutCirclesWhereTheirPlacesInMetresAre) {
  FilmResult handmade = sample().film;
  handmade.grains = {};
  const Json grains = document_of(handmade)["grains"];
  EXPECT_EQ(grains["x"]["n"], 120);
  EXPECT_FALSE(grains.contains("position_error"));
  handmade.pixel = 0;
  EXPECT_EQ(document_of(handmade)["grains"]["count"], 0);
}

TEST(FilmDocument, NumbersWallsAfterTheGrains) {
  const Json film = document_of(sample().film);
  EXPECT_EQ(film["contacts"]["count"], sample().film.packing.contacts.size());
  for (const char* name : {"fn", "ft", "fn_error", "ft_error", "presence", "nx", "ny"}) EXPECT_TRUE(film["contacts"].contains(name)) << name;
}

TEST(FilmDocument, OfMapsAloneHasNeitherGrainsNorStresses) {
  FilmResult maps;
  maps.film = sample().film.film;
  maps.maps = sample().film.maps;
  const Json film = document_of(maps);
  EXPECT_EQ(film["grains"]["count"], 0);
  EXPECT_EQ(film["contacts"]["count"], 0);
  EXPECT_TRUE(film["stresses"].empty());
  EXPECT_TRUE(film["agreement"].empty());
  EXPECT_TRUE(film["frame"].is_null());
}

TEST(FilmDocument, PutsTheFrameWhereItsWallsAre) {
  const Json frame = document_of(sample().film)["frame"];
  const FilmResult& film = sample().film;
  EXPECT_NEAR(frame[0], 5.5, 1e-9);
  EXPECT_NEAR(frame[1], 5.5 + film.packing.domain.width() / film.pixel, 1e-9);
  EXPECT_NEAR(frame[3], 5.5, 1e-9);
  EXPECT_GT(frame[2], frame[3]);
}

TEST(FilmDocument, StaysSmallForALargeCamera) {
  FilmResult large;
  large.film.width = large.maps.width = 640;
  large.film.height = large.maps.height = 512;
  RandomStream random(3, Purpose::test);
  const auto noise = [&](double mean) {
    std::vector<float> values(large.film.pixels());
    for (float& v : values) v = static_cast<float>(mean + 1e-3 * random.normal());
    return values;
  };
  large.picture = noise(296);
  for (auto* map : {&large.maps.amplitude, &large.maps.phase, &large.maps.in_phase, &large.maps.second_harmonic, &large.maps.standard_error, &large.maps.residual})
    *map = noise(0);
  EXPECT_LT(report::page_document({"film", {}, {}, {}, {{&large, {}}}}).numbers.size(), 4'000'000u);
}

TEST(FilmStresses, AreTakenOverTheMeanOfTheGrainsThatCount) {
  texture::Options options;
  options.border = 0;
  const auto stresses = report::film_stresses(four({-1e5, -2e5, -3e5, -2e5}, {-1e5, -1e5, -4e5, -2e5}), options);
  ASSERT_EQ(stresses.sources.size(), 2u);
  EXPECT_NEAR(stresses.sources[0].mean, -2e5, 1e-6);
  EXPECT_NEAR(stresses.sources[0].sigma_norm[2], 1.5, 1e-12);
  EXPECT_NEAR(stresses.sources[1].sigma_norm[2], 2.0, 1e-12);
}

TEST(FilmStresses, LeaveOutGrainsThatOneSourceDoesNotKnow) {
  texture::Options options;
  options.border = 0;
  const auto stresses = report::film_stresses(four({-1e5, NAN, -3e5, -2e5}, {-1e5, -9e5, -4e5, -4e5}), options);
  EXPECT_TRUE(std::isnan(stresses.sources[1].sigma_hyd[1]));
  EXPECT_NEAR(stresses.sources[1].mean, -3e5, 1e-6);
  EXPECT_EQ(stresses.considered, (std::vector<std::uint8_t>{1, 0, 1, 1}));
}

TEST(FilmStresses, KeepTheBorderOutWhereSomethingIsLeft) {
  texture::Options options;
  options.border = 2.5;  // mean diameters of 10 mm: 25 mm along each side of a box of 100 mm
  EXPECT_EQ(report::film_stresses(four({-1, -2, -3, -4}, {}), options).considered, (std::vector<std::uint8_t>{0, 1, 1, 0}));
  options.border = 6;
  EXPECT_EQ(report::film_stresses(four({-1, -2, -3, -4}, {}), options).considered, (std::vector<std::uint8_t>{1, 1, 1, 1}));
}

TEST(FilmStresses, OfAFilmThatIsTwiceItsTwinAgreeWithSlopeTwo) {
  const FilmResult r = four({-2e5, -4e5, -6e5, -8e5}, {-1e5, -2e5, -3e5, -4e5});
  texture::Options options;
  options.border = 0;
  const auto stresses = report::film_stresses(r, options);
  const auto all = report::agreement(r.packing, stresses.sources[0], stresses.sources[1]);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].relation.count, 4u);
  EXPECT_NEAR(all[0].relation.pearson.value, 1, 1e-12);
  EXPECT_NEAR(all[0].relation.line.slope, 2, 1e-12);
  EXPECT_NEAR(all[0].rms, std::sqrt(30.0 / 4) * 1e5, 1e-4);
  EXPECT_NEAR(all[0].rms_norm, 0, 1e-12);
}
