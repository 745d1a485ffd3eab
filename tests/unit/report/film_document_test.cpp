#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>

#include "report/number_block.hpp"
#include "report/page_document.hpp"
#include "support/film_page_sample.hpp"
#include "workflow/film/film_numbers.hpp"

using namespace arenite;
using Json = nlohmann::json;

namespace {

const test::FilmPageSample& film_sample() {
  static const test::FilmPageSample made(120, 3e-3);
  return made;
}

Json document_of(const FilmResult& film) {
  return Json::parse(report::page_document({.title = "film", .films = {&film, 1}}).json)["films"][0];
}

}  // namespace

TEST(FilmDocument, HoldsEveryMapThatTheResultHas) {
  const Json film = document_of(film_sample().film);
  const std::size_t pixels = film_sample().film.film.pixels();
  for (const char* name :
       {"picture", "amplitude", "phase", "in_phase", "second_harmonic", "standard_error", "residual"})
    EXPECT_EQ(film["maps"][name]["residual"]["n"], pixels) << name;
  EXPECT_EQ(film["bad"]["n"], 2);
  FilmResult bare = film_sample().film;
  bare.maps.second_harmonic.clear();
  bare.picture.clear();
  EXPECT_FALSE(document_of(bare)["maps"].contains("second_harmonic"));
  EXPECT_FALSE(document_of(bare)["maps"].contains("picture"));
}

TEST(FilmDocument, SaysHowFilmAndForcesCompare) {
  const FilmResult& result = film_sample().film;
  const Json film = document_of(result);
  const Json& pictures = film["fit"]["pictures"];
  ASSERT_EQ(pictures.size(), 3u);
  EXPECT_EQ(film["fit"]["title"], "Warming with the load");
  EXPECT_EQ(pictures[0]["label"], "Measured");
  EXPECT_EQ(pictures[0]["factor"], to_peak_to_peak(result.maps.convention));
  for (const int k : {1, 2}) EXPECT_EQ(pictures[k]["label"], film["maps"][pictures[k]["map"]]["label"]);
  const double measured = pictures[0]["rms"], fitted = pictures[1]["rms"], residual = pictures[2]["rms"];
  EXPECT_GT(measured, 0);
  EXPECT_GT(fitted, 0);
  EXPECT_LT(residual, measured);
  EXPECT_EQ(film["maps"]["fit_residual"]["residual"]["n"], result.film.pixels());
  EXPECT_EQ(film["contacts"]["may_be_absent"]["n"], result.packing.contacts.size());
  EXPECT_DOUBLE_EQ(film["force_scale"]["mean"], result.numbers["forces"]["mean_N"]["value"].get<double>());
}

TEST(FilmDocument, SaysWhatItsSourcesOfStressesAreCalledAndWhatStandsBesideTheirTables) {
  FilmResult film = film_sample().film;
  const Json beside = document_of(film);
  EXPECT_EQ(beside["stresses"]["film"]["name"], "film");
  EXPECT_EQ(beside["stresses"]["simulation_peak_to_peak"]["name"], "simulation, peak to peak");
  EXPECT_EQ(beside["stresses"]["simulation_state"]["name"], "simulation, largest load");
  EXPECT_EQ(beside["comparison"]["title"], "Experiment and simulation");
  film.simulation = {};
  EXPECT_EQ(document_of(film)["comparison"]["title"], "Stress of grains");
}

TEST(FilmDocument, ListsPixelsWithoutAValue) {
  FilmResult holed = film_sample().film;
  holed.maps.in_phase[7] = holed.maps.in_phase[11] = std::nanf("");
  const Json film = document_of(holed);
  EXPECT_EQ(film["maps"]["in_phase"]["holes"]["n"], 2);
  EXPECT_FALSE(film["maps"]["amplitude"].contains("holes"));
}

TEST(FilmDocument, PutsGrainsWithoutCirclesWhereTheirPlacesInMetresAre) {
  FilmResult handmade = film_sample().film;
  handmade.grains = {};
  const Json grains = document_of(handmade)["grains"];
  EXPECT_EQ(grains["x"]["n"], 120);
  EXPECT_FALSE(grains.contains("position_error"));
  handmade.pixel = 0;
  EXPECT_EQ(document_of(handmade)["grains"]["count"], 0);
}

TEST(FilmDocument, NumbersWallsAfterTheGrains) {
  const Json film = document_of(film_sample().film);
  EXPECT_EQ(film["contacts"]["count"], film_sample().film.packing.contacts.size());
  for (const char* name : {"fn", "ft", "fn_error", "ft_error", "presence", "nx", "ny"})
    EXPECT_TRUE(film["contacts"].contains(name)) << name;
}

TEST(FilmDocument, OfMapsAloneHasNeitherGrainsNorStresses) {
  FilmResult maps;
  maps.film = film_sample().film.film;
  maps.maps = film_sample().film.maps;
  const Json film = document_of(maps);
  EXPECT_EQ(film["grains"]["count"], 0);
  EXPECT_EQ(film["contacts"]["count"], 0);
  EXPECT_TRUE(film["stresses"].empty());
  EXPECT_TRUE(film["fit"].empty());
  EXPECT_FALSE(film["numbers"].contains("agreement"));
  EXPECT_TRUE(film["container"].is_null());
}

TEST(FilmDocument, SaysUnitsAndMeaningsAsTheyAreDeclaredAndLevelsWhereTheFilmHasThese) {
  const Json film = document_of(film_sample().film);
  EXPECT_EQ(film["maps"]["amplitude"]["unit"], "K");
  EXPECT_EQ(film["contacts"]["fn"]["unit"], "N");
  EXPECT_EQ(film["meanings"]["lockin.frequency_Hz"], Json({"Hz", "Frequency of the load"}));
  EXPECT_EQ(film["meanings"]["texture.force.mean_N"][0], "N");
  EXPECT_EQ(film["meanings"]["stresses.film.mean_Pa"][0], "Pa");
  EXPECT_EQ(film["meanings"]["agreement.simulation_peak_to_peak.all.rms_Pa"][0], "Pa");
  FilmResult levels = film_sample().film;
  levels.film.quantity = FilmQuantity::digital_level;
  EXPECT_EQ(document_of(levels)["maps"]["amplitude"]["unit"], "DL");
  EXPECT_EQ(document_of(levels)["maps"]["phase"]["unit"], "");
  EXPECT_EQ(document_of(levels)["meanings"]["lockin.standard_error_K"][0], "DL");
}

TEST(FilmDocument, PutsTheContainerWhereItsWallsAre) {
  const Json container = document_of(film_sample().film)["container"];
  const FilmResult& film = film_sample().film;
  EXPECT_NEAR(container[0], 5.5, 1e-9);
  EXPECT_NEAR(container[1], 5.5 + film.packing.domain.width() / film.pixel, 1e-9);
  EXPECT_NEAR(container[3], 5.5, 1e-9);
  EXPECT_GT(container[2], container[3]);
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
  for (auto* map : {&large.maps.amplitude, &large.maps.phase, &large.maps.in_phase, &large.maps.second_harmonic,
                    &large.maps.standard_error, &large.maps.residual})
    *map = noise(0);
  EXPECT_LT(report::page_document({.title = "film", .films = {&large, 1}}).numbers.size(), 4'000'000u);
}

TEST(FilmDocument, TakesOverWhatTheRunMeasured) {
  const FilmResult& film = film_sample().film;
  workflow::KnownStatistics known{.films = {workflow::texture_of(film)}};
  const auto texture = [&](const workflow::KnownStatistics* measured) {
    return Json::parse(report::page_document({.title = "film", .films = {&film, 1}, .measured = measured})
                           .json)["snapshots"][0]["texture"];
  };
  EXPECT_EQ(texture(&known), texture(nullptr));
  known.films[0]->numbers["contacts"] = 1;  // which nobody would count
  EXPECT_EQ(texture(&known)["contacts"], 1);
}
