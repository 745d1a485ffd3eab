#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>

#include "commands/rows_of_text.hpp"
#include "io/film/film.hpp"
#include "support/films.hpp"
#include "support/oscillating_film.hpp"
#include "support/program.hpp"

namespace {

using namespace arenite;
using test::arenite;
using test::TemporaryFolder;
using Json = nlohmann::json;

TEST(StepCommand, MeasuresTheJumpAndWritesMaps) {
  const TemporaryFolder folder;
  test::OscillatingFilm still;
  still.amplitude = 0;
  still.drift = 0.2;
  still.noise = 0.05;
  Film film = still.draw();
  for (std::size_t i = 400 * 45; i < film.value.size(); ++i) film.value[i] += 0.75F;
  io::write_film(folder / "film.npy", film);
  const std::string step = "step " + (folder / "film.npy").string() + " --frame-rate 148Hz --json";
  const auto found = arenite(step + " --out " + (folder / "maps").string()),
             given = arenite(step + " --time 2.7s --rise 0.02s --window 1s");
  ASSERT_EQ(found.status, 0) << found.err;
  EXPECT_NEAR(Json::parse(found.out)["time_s"].get<double>(), 399.5 / 148, 1e-6);
  EXPECT_NEAR(Json::parse(found.out)["median"]["jump"].get<double>(), 0.75, 0.01);
  EXPECT_TRUE(std::filesystem::exists(folder / "maps" / "jump.tif"));
  ASSERT_EQ(given.status, 0) << given.err;
  EXPECT_EQ(Json::parse(given.out)["time"], "given");
  const auto refused = arenite(step + " --time 9s --out " + (folder / "none").string());
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("film.npy: the step at 9 s is not within the film"), std::string::npos) << refused.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "none"));
}

TEST(StepCommand, SaysThatAJumpRelaxes) {
  const TemporaryFolder folder;
  test::OscillatingFilm still;
  still.amplitude = 0;
  still.noise = 0.02;
  still.frames = 1480;
  Film film = still.draw();
  for (std::size_t i = 740 * 45; i < film.value.size(); ++i)
    film.value[i] += static_cast<float>(0.75 * std::exp(-(static_cast<double>(i / 45) - 740) / 148 / 1.5));
  io::write_film(folder / "film.npy", film);
  const std::string step = "step " + (folder / "film.npy").string() + " --frame-rate 148Hz --time 4.997s";
  const auto found = arenite(step + " --json"), text = arenite(step);
  ASSERT_EQ(found.status, 0) << found.err;
  EXPECT_NEAR(Json::parse(found.out)["relaxation_after_s"].get<double>(), 1.5, 0.05);
  EXPECT_TRUE(Json::parse(found.out)["relaxation_before_s"].is_null());
  EXPECT_NEAR(Json::parse(found.out)["median"]["jump"].get<double>(), 0.75, 0.01);
  EXPECT_EQ(test::rows_without_meaning(text.out, Json::parse(found.out)), "") << text.out;
}

}  // namespace
