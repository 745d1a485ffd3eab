#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/film/film.hpp"
#include "support/films.hpp"
#include "support/virtual_film.hpp"
#include "thermal/inference/film_stresses.hpp"
#include "thermal/radiometry/band.hpp"
#include "thermal/thermography/correction.hpp"
#include "thermal/thermography/frame_statistics.hpp"

namespace {

using namespace arenite;
using test::VirtualFilm;
using Json = nlohmann::json;

/// One sentence that holds `words`, exit 2, and no folder of results.
void expect_refused(const VirtualFilm& of, const test::Outcome& outcome, const std::string& words) {
  EXPECT_EQ(outcome.status, 2) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  std::vector<std::string> sentences;
  std::istringstream lines(outcome.err);
  for (std::string line; std::getline(lines, line);)
    if (line.find(words) != std::string::npos) sentences.push_back(line);
  ASSERT_EQ(sentences.size(), 1u) << outcome.err;
  EXPECT_TRUE(outcome.err.ends_with(sentences.front() + "\n")) << outcome.err;
  for (const char* name : {"result", "none"}) EXPECT_FALSE(std::filesystem::exists(of.at(name))) << name;
}

TEST(FilmCommand, RefusesWhatTheFilmDoesNotShow) {
  const VirtualFilm of("--set camera.high='\"low\"'");
  ASSERT_EQ(of.filmed.status, 0) << of.filmed.err;
  expect_refused(of, of.film(), "film.ptw: the film shows only noise at 3 Hz");
  expect_refused(of, of.film("--set lockin.frequency='\"80 Hz\"'"),
                 "film.ptw: the load frequency of 80 Hz is at or above the Nyquist frequency");
  expect_refused(of, of.film("--set lockin.frequency='\"0.2 Hz\"'"),
                 "film.ptw: the film of 2.027 s holds 0.404 cycles");
  const auto cold = [&](const std::string& to) { std::filesystem::copy_file(of.at("film/cold.ptw"), of.at(to)); };
  std::filesystem::create_directory(of.at("plate"));
  cold("plate/film.ptw");
  expect_refused(of, of.film("--set lockin.frequency='\"30 Hz\"'", "plate"),
                 "film.ptw: the film shows only noise at 30 Hz");
  ASSERT_EQ(of.camera("wide", "--set camera.width=80").status, 0);
  expect_refused(of, of.film("--set correction.warm='\"../wide/warm.ptw\"'"),
                 "warm.ptw: has frames of 80 x 96 pixels, and the film of 96 x 96");
}

/// The film's frames with every level made another, in a folder of its own under the same name.
void change_levels(const VirtualFilm& of, const std::string& name, const std::string& to,
                   std::uint16_t (*change)(std::uint16_t)) {
  const auto source = io::open_film(of.at("film/" + name));
  Film film;
  film.about = source->info();
  film.level = test::all_of(*source).level;
  for (auto& level : film.level) level = change(level);
  std::filesystem::create_directory(of.at(to));
  io::write_film(of.at(to + "/" + name), film);
}

TEST(FilmCommand, RefusesPixelsThatTellNothing) {
  const VirtualFilm of;
  ASSERT_EQ(of.filmed.status, 0) << of.filmed.err;
  change_levels(of, "film.ptw", "saturated", [](std::uint16_t) { return std::uint16_t{16383}; });
  expect_refused(of, of.film("", "saturated"),
                 "film.ptw: 9216 of 9216 pixels reach the top of the camera's range (16383)");
  change_levels(of, "film.ptw", "constant", [](std::uint16_t) { return std::uint16_t{5000}; });
  expect_refused(of, of.film("", "constant"), "film.ptw: 9216 of 9216 pixels are constant in the first 200 frames");
  change_levels(of, "warm.ptw", "saturated", [](std::uint16_t) { return std::uint16_t{16383}; });
  expect_refused(of, of.film("--set correction.warm='\"../saturated/warm.ptw\"'"),
                 "warm.ptw: 9216 of 9216 pixels reach the top");
  expect_refused(of, of.film("--set correction.warm='\"cold.ptw\"'"), "the two references show the same level");
}

TEST(FilmCommand, RefusesASixteenBitFilmAtItsCeiling) {
  const VirtualFilm of;
  ASSERT_EQ(of.filmed.status, 0) << of.filmed.err;
  Film film = test::counted(96, 96, 300);
  film.about.bits = 16;
  film.about.frame_rate = 148;
  for (auto& level : film.level) level = 65535;
  io::write_film(of.at("film/white.tif"), film);
  expect_refused(of,
                 test::arenite("film " + of.at("film/white.tif").string() + " --recipe " +
                               of.at("film/film.toml").string() + " --quiet --out " + of.at("result").string()),
                 "white.tif: 9216 of 9216 pixels reach the top of the camera's range (65535)");
}

TEST(FilmCommand, RefusesAListWithOverlappingCircles) {
  const VirtualFilm of;
  ASSERT_EQ(of.filmed.status, 0) << of.filmed.err;
  std::ofstream(of.at("film/list.csv"))
      << "id,x [mm],y [mm],radius [mm],material\n1,20,20,5,POM\n7,26,20,5,HDPE\n3,60,20,5,POM\n4,69,20,5,POM\n";
  expect_refused(of, of.film("--set picture.grains='\"list.csv\"'"), "list.csv: grains 1 and 7 overlap by 4 mm");
}

TEST(FilmCommand, RefusesRecipesThatDoNotFit) {
  const VirtualFilm of;
  ASSERT_EQ(of.filmed.status, 0) << of.filmed.err;
  of.edit("no-factor.toml", "thermoelastic_factor = \"0.015 K/MPa\"\n", "");
  expect_refused(of, of.film("", "film", "no-factor.toml"), "materials.POM.thermoelastic_factor: is missing");
  of.edit("companion.toml", "[picture]",
          "[simulation]\nrecipe = \"" + VirtualFilm::example("sample.toml") +
              "\"\nlow = \"none\"\nhigh = \"high\"\n\n[picture]");
  expect_refused(of, of.film("", "film", "companion.toml"),
                 "sample.toml: has no stage \"none\", which [simulation] of ");
  std::ofstream(of.at("film/none.csv")) << "id,x [mm],y [mm],radius [mm],material\n";
  expect_refused(of, of.film("--set picture.grains='\"none.csv\"'"), "none.csv: lists no grains");
  of.edit("empty.toml", "[container]", "[container]\nleft = 200.0");
  expect_refused(of, of.film("", "film", "empty.toml"), "film.ptw: the film shows no grains inside the container");
}

TEST(FilmCommand, RefusesLevelsThatNothingTurnsIntoTemperatures) {
  const VirtualFilm of;
  ASSERT_EQ(of.filmed.status, 0) << of.filmed.err;
  expect_refused(of,
                 test::arenite("film " + of.at("film/film.ptw").string() + " --recipe " +
                               VirtualFilm::example("camera.toml") + " --quiet --out " + of.at("none").string()),
                 "camera.toml: temperature: from is \"references\" unless given, and needs correction.cold");
  std::string text = test::slurp(of.at("film/film.toml"));
  const auto section = text.find("[temperature]");
  text.erase(section, text.find("\n[", section) - section);
  std::ofstream(of.at("film/kelvin.toml")) << text << "\n[temperature]\nfrom = \"film\"\nassumed_emissivity = 1\n";
  expect_refused(of, of.film("", "film", "kelvin.toml"),
                 "film.ptw: states that it holds digital levels, and temperature.from = \"film\" of ");
}

TEST(CameraCommand, RefusesInOneSentence) {
  const VirtualFilm of;
  const auto none = [&](const std::string& overrides) { return of.camera("none", overrides); };
  expect_refused(of, none("--set camera.high='\"nowhere\"'"),
                 "states: has no stage \"nowhere\"; those there are: compact, high, low, packing, prepare");
  std::string text = test::slurp(VirtualFilm::example("camera.toml"));
  const auto pom = text.find("[materials.POM]");
  std::ofstream(of.at("no-pom.toml")) << text.erase(pom, text.find("[container]") - pom);
  const std::string tail = " --quiet --out " + of.at("none").string();
  expect_refused(of, test::arenite("camera " + of.states() + " --recipe " + of.at("no-pom.toml").string() + tail),
                 "there is no section [materials.POM]");
  expect_refused(of, test::arenite("camera " + of.states() + " --recipe " + of.at("film/film.toml").string() + tail),
                 "there is no section [camera]");
  expect_refused(
      of, test::arenite("camera " + of.at("film").string() + " --recipe " + VirtualFilm::example("camera.toml") + tail),
      "film: holds no stage file");
}

}  // namespace
