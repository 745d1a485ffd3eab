#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
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

std::string film_in(const TemporaryFolder& folder, double noise = 0.1) {
  test::OscillatingFilm oscillating;
  oscillating.noise = noise;
  Film film = oscillating.draw();
  io::write_film(folder / "film.h5", film);
  return (folder / "film.h5").string() + " --frame-rate 148Hz";
}

std::string film_of_others(const char* name) {
  return (std::filesystem::path(ARENITE_SOURCE_DIR) / "tests/data/films" / name).string() + " --frame-rate 30Hz";
}

/// The film as it is without the frame that is NaN gives the same numbers, and the frame is named.
TEST(LockInCommand, AFrameOfNaNIsLeftOutAndNamed) {
  const auto done = arenite("lockin " + film_of_others("nan-frame.tif") + " --frequency 3Hz --json");
  ASSERT_EQ(done.status, 0) << done.err;
  EXPECT_NE(done.err.find("frame 40 holds no whole picture"), std::string::npos) << done.err;
  const Json j = Json::parse(done.out);
  EXPECT_EQ(j["blank_frames"], Json::array({40}));
  EXPECT_EQ(j["frames"], 119);
  EXPECT_EQ(j["shows_load"], true);
  EXPECT_TRUE(j["median"]["amplitude"].is_number());
  EXPECT_NEAR(j["frequency_Hz"]["value"].get<double>(), 3, 0.01);
  const auto step = arenite("step " + film_of_others("nan-frame.tif") + " --time 2s");
  EXPECT_NE(step.err.find("frame 40 holds no whole picture"), std::string::npos) << step.err;
}

/// A pixel that is NaN in some frames is left out, as one that is dead, and told; its frames stay.
TEST(LockInCommand, APixelThatFailsLeavesItsFrames) {
  const TemporaryFolder folder;
  test::OscillatingFilm oscillating;
  oscillating.noise = 0.1;
  Film film = oscillating.draw();
  for (const std::size_t frame : {40, 41, 300})
    film.value[frame * film.about.pixels() + 3] = std::numeric_limits<float>::quiet_NaN();
  io::write_film(folder / "film.h5", film);
  const auto done = arenite("lockin " + (folder / "film.h5").string() + " --frame-rate 148Hz --frequency 3Hz --json");
  ASSERT_EQ(done.status, 0) << done.err;
  EXPECT_NE(done.err.find("1 of 45 pixels are no numbers in some of the frames"), std::string::npos) << done.err;
  const Json j = Json::parse(done.out);
  EXPECT_EQ(j["blank_frames"], Json::array());
  EXPECT_EQ(j["frames"], 800);
}

TEST(LockInCommand, FilesWithoutEveryTenthNumberKeepTheFrequency) {
  const TemporaryFolder folder;
  test::OscillatingFilm oscillating;
  oscillating.frames = 200, oscillating.rate = 30, oscillating.noise = 0.1;
  const Film film = oscillating.draw();
  std::filesystem::create_directory(folder / "film");
  for (std::size_t n = 0; n < 200; ++n) {
    if (n % 10 == 5) continue;
    Film one;
    one.about = film.about;
    one.about.frames = 1;
    one.about.frame_rate = 0;
    const auto first = film.value.begin() + static_cast<std::ptrdiff_t>(n * film.about.pixels());
    one.value.assign(first, first + static_cast<std::ptrdiff_t>(film.about.pixels()));
    io::write_film(folder / ("film/frame_" + std::to_string(n) + ".tif"), one);
  }
  const auto done = arenite("lockin " + (folder / "film").string() + " --frame-rate 30Hz --frequency 3Hz --json");
  ASSERT_EQ(done.status, 0) << done.err;
  EXPECT_NE(done.err.find("By their numbers 20 frames are missing"), std::string::npos) << done.err;
  EXPECT_NEAR(Json::parse(done.out)["frequency_Hz"]["value"].get<double>(), 3, 0.01);
}

TEST(LockInCommand, TextAndJsonHaveTheSameNumbersEachWithItsMeaning) {
  const TemporaryFolder folder;
  const std::string lockin = "lockin " + film_in(folder) + " --frequency 3Hz --pixel 1.6mm";
  const auto json = arenite(lockin + " --json"), text = arenite(lockin);
  ASSERT_EQ(json.status, 0) << json.err;
  const Json numbers = Json::parse(json.out);
  EXPECT_EQ(test::rows_without_meaning(text.out, numbers), "") << text.out;
  EXPECT_NE(text.out.find("median.drift"), std::string::npos);
  EXPECT_TRUE(std::regex_search(text.out, std::regex(" frequency_Hz +[0-9.]+ \\+- [0-9.e-]+ Hz "))) << text.out;
  EXPECT_NE(text.out.find(" level/s "), std::string::npos) << text.out;
  EXPECT_NE(text.out.find(" deg "), std::string::npos) << text.out;
}

TEST(LockInCommand, PrintsNumbersAndWritesMaps) {
  const TemporaryFolder folder;
  const auto done =
      arenite("lockin " + film_in(folder) + " --frequency 3.001Hz --json --out " + (folder / "maps").string());
  ASSERT_EQ(done.status, 0) << done.err;
  const Json j = Json::parse(done.out);
  EXPECT_NEAR(j["frequency_Hz"]["value"].get<double>(), 3, 5 * j["frequency_Hz"]["error"].get<double>());
  EXPECT_EQ(j["convention"], "amplitude");
  EXPECT_NEAR(j["median"]["amplitude"].get<double>(), 1.22, 0.01);
  for (const char* name : {"in_phase.tif", "residual.tif", "second_harmonic.tif", "noise_floor.tif"})
    EXPECT_TRUE(std::filesystem::exists(folder / "maps" / name)) << name;
  const auto full = arenite("lockin " + film_in(folder) + " --frequency 3Hz --json --convention full --nearest-bin");
  ASSERT_EQ(full.status, 0) << full.err;
  EXPECT_EQ(Json::parse(full.out)["method"], "nearest_bin");
  EXPECT_EQ(Json::parse(full.out)["convention"], "peak_to_peak");
}

TEST(LockInCommand, SaysWhereTheFilmShowsNoLoad) {
  const TemporaryFolder folder;
  test::OscillatingFilm still;
  still.amplitude = 0;
  still.noise = 0.1;
  still.width = still.height = 40;
  Film film = still.draw();
  io::write_film(folder / "still.h5", film);
  const auto noise = arenite("lockin " + (folder / "still.h5").string() + " --frame-rate 148Hz --frequency 3Hz --json");
  EXPECT_EQ(noise.status, 0) << noise.err;
  EXPECT_NE(noise.err.find("still.h5: the film shows only noise at "), std::string::npos) << noise.err;
  EXPECT_EQ(Json::parse(noise.out)["shows_load"], false);
  const auto loaded = arenite("lockin " + film_in(folder) + " --frequency 3Hz --json"),
             elsewhere = arenite("lockin " + film_in(folder) + " --frequency 30Hz --json");
  EXPECT_EQ(loaded.err, "");
  EXPECT_EQ(Json::parse(loaded.out)["shows_load"], true);
  EXPECT_EQ(elsewhere.status, 2);
  EXPECT_NE(elsewhere.err.find("film.h5: the film shows only noise at 30 Hz, but an oscillation at 3 Hz"),
            std::string::npos)
      << elsewhere.err;
  const auto kept = arenite("lockin " + film_in(folder) + " --frequency 30Hz --no-refinement --json");
  EXPECT_EQ(kept.status, 0);
  EXPECT_NE(kept.err.find("but an oscillation at 3"), std::string::npos) << kept.err;
  EXPECT_EQ(Json::parse(kept.out)["shows_load"], false);
  EXPECT_NEAR(Json::parse(kept.out)["other_frequency_Hz"].get<double>(), 3, 0.02);
}

TEST(LockInCommand, ShowsNoLoadInAFilmOfACameraAtRest) {
  const auto still =
      arenite("lockin " + test::infrared("PyradiSampleMWIR.ptw").string() + " --frequency 4.67Hz --json");
  EXPECT_EQ(still.status, 0) << still.err;  // a line of the electronics is there
  EXPECT_EQ(Json::parse(still.out)["shows_load"], false);
  EXPECT_LT(Json::parse(still.out)["share_in_one_phase"].get<double>(), 0.5);
  EXPECT_NE(still.err.find(" only noise at 4.6"), std::string::npos) << still.err;
}

TEST(LockInCommand, RefusesACycleThatDriftCouldBe) {
  const TemporaryFolder folder;
  test::OscillatingFilm oscillating;
  oscillating.frames = 50;
  Film film = oscillating.draw();
  io::write_film(folder / "film.h5", film);
  const auto refused = arenite("lockin " + (folder / "film.h5").string() +
                               " --frame-rate 148Hz --frequency 3Hz --out " + (folder / "none").string());
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(
      refused.err.find(
          "holds 1.01 cycles of 3 Hz, too few to separate the load from a drift of order 4; use a lower drift order"),
      std::string::npos)
      << refused.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "none"));
}

TEST(LockInCommand, PhasesAreAnglesInDegrees) {
  const TemporaryFolder folder;
  const std::string lockin = "lockin " + film_in(folder) + " --frequency 3Hz --json --reference-phase ";
  const auto degrees = arenite(lockin + "90deg"), radians = arenite(lockin + "1.5707963267948966rad"),
             bare = arenite(lockin + "1.5707963267948966");
  ASSERT_EQ(degrees.status, 0) << degrees.err;
  EXPECT_EQ(degrees.err, "");
  EXPECT_NEAR(Json::parse(degrees.out)["reference_phase_deg"].get<double>(), 90, 1e-9);
  EXPECT_FALSE(Json::parse(degrees.out).contains("reference_phase_rad"));
  EXPECT_EQ(degrees.out, radians.out);
  EXPECT_EQ(degrees.out, bare.out);
  EXPECT_NE(bare.err.find("is taken to be in radians"), std::string::npos) << bare.err;
}

TEST(LockInCommand, IsLedByTheLockInLineOfAFilm) {
  const TemporaryFolder folder;
  test::OscillatingFilm oscillating;
  oscillating.noise = 0.1;
  Film film = oscillating.draw();
  // The same film as levels, with a line above it that holds the mark and the load: its frequency, a quarter of a cycle
  // ahead.
  Film with_line;
  with_line.about = film.about;
  with_line.about.floating = false;
  with_line.about.height += 1;
  const std::size_t width = static_cast<std::size_t>(film.about.width), pixels = film.about.pixels();
  const std::uint16_t mark[] = {1220, 3907, 1204, 2382};
  for (std::int64_t f = 0; f < film.about.frames; ++f) {
    const double angle = 2 * 3.14159265358979 * 3 * static_cast<double>(f) / 148;
    for (std::size_t x = 0; x < width; ++x)
      with_line.level.push_back(x < 4 ? mark[x]
                                      : static_cast<std::uint16_t>(std::lround(8000 + 1000 * std::cos(angle - 0.7))));
    for (std::size_t p = 0; p < pixels; ++p)
      with_line.level.push_back(
          static_cast<std::uint16_t>(std::lround(5000 + 100 * film.value[static_cast<std::size_t>(f) * pixels + p])));
  }
  test::spill(folder / "a.ptw", test::ptw(with_line, 1 / 148.0));
  const auto led = arenite("lockin " + (folder / "a.ptw").string() + " --frequency 3.3Hz --frame-rate 148Hz --json");
  ASSERT_EQ(led.status, 0) << led.err;
  const Json j = Json::parse(led.out);
  EXPECT_NEAR(j["frequency_Hz"]["value"].get<double>(), 3, 0.001);
  EXPECT_NEAR(j["reference_phase_deg"].get<double>(), 0.7 * 180 / 3.14159265358979, 0.2);
  EXPECT_EQ(j["height"], film.about.height);
  EXPECT_NE(led.err.find("lock-in line cycles at 3"), std::string::npos) << led.err;
}

TEST(LockInCommand, TakesAStackOfTiffThatIsToldItsFrameRateAndScale) {
  const TemporaryFolder folder;
  test::OscillatingFilm oscillating;
  Film film = oscillating.draw();
  film.about.frame_rate = 0;
  film.about.time.clear();
  io::write_film(folder / "stack.tif", film);
  const auto bare = arenite("lockin " + (folder / "stack.tif").string() + " --frequency 3Hz");
  EXPECT_EQ(bare.status, 2);
  EXPECT_NE(bare.err.find("does not state its frame rate"), std::string::npos) << bare.err;
  const auto plain =
      arenite("lockin " + (folder / "stack.tif").string() + " --frequency 3Hz --frame-rate 148Hz --json");
  ASSERT_EQ(plain.status, 0) << plain.err;
  const auto scaled = arenite("lockin " + (folder / "stack.tif").string() +
                              " --frequency 3Hz --frame-rate 148Hz --scale 10mK --offset 273K --json");
  ASSERT_EQ(scaled.status, 0) << scaled.err;
  EXPECT_EQ(Json::parse(scaled.out)["unit"], "K");
  EXPECT_NEAR(Json::parse(scaled.out)["median"]["amplitude"].get<double>(),
              0.01 * Json::parse(plain.out)["median"]["amplitude"].get<double>(), 1e-5);
}

TEST(LockInCommand, NamesTheOptionOfAValueThatHasNoUnit) {
  const auto refused = arenite("lockin film.ptw --frequency 3");
  EXPECT_EQ(refused.status, 2);
  EXPECT_EQ(refused.err,
            "arenite lockin: --frequency: \"3\" has no unit; write it with its unit, for example \"3 Hz\"\n");
}

TEST(LockInCommand, SaysWhetherTheSignalIsAdiabatic) {
  const TemporaryFolder folder;
  const std::string lockin =
      "lockin " + film_in(folder) + " --frequency 3Hz --no-refinement --json --diffusivity '0.1 mm^2/s' --pixel ";
  const auto coarse = arenite(lockin + "1.6mm"), fine = arenite(lockin + "0.3mm");
  ASSERT_EQ(coarse.status, 0) << coarse.err;
  EXPECT_EQ(coarse.err, "");
  EXPECT_NEAR(Json::parse(coarse.out)["diffusion_length_m"].get<double>(), 0.103006e-3, 1e-9);
  EXPECT_EQ(Json::parse(coarse.out)["adiabatic"], true);
  EXPECT_NE(fine.err.find("over 0.343 pixels within a cycle"), std::string::npos) << fine.err;
  EXPECT_EQ(fine.status, 0);
  EXPECT_EQ(Json::parse(fine.out)["adiabatic"], false);
  EXPECT_NEAR(Json::parse(fine.out)["amplitude_lost_in_finest_detail"].get<double>(),
              1 - 1 / std::sqrt(1 + std::pow(0.5818, 2)), 1e-3);
}

TEST(LockInCommand, RefusesInOneSentence) {
  const TemporaryFolder folder;
  const std::string film = film_in(folder);
  for (const char* frequency : {"80Hz", "0.05Hz", "0Hz", "3K"}) {
    const auto refused =
        arenite("lockin " + film + " --frequency " + frequency + " --out " + (folder / "none").string());
    EXPECT_EQ(refused.status, 2) << frequency;
    EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "none"));
  }
  for (const char* slip : {" --pixel 0mm", " --diffusivity 1mm", " --reference-phase x"})
    EXPECT_EQ(arenite("lockin " + film + " --frequency 3Hz" + slip).status, 2) << slip;
  test::OscillatingFilm tiny;
  Film of_one = tiny.draw();
  std::fill(of_one.value.begin(), of_one.value.end(), 1.f);
  io::write_film(folder / "still.npy", of_one);
  const auto still = arenite("lockin " + (folder / "still.npy").string() + " --frame-rate 148Hz --frequency 3Hz");
  EXPECT_EQ(still.status, 2);
  EXPECT_NE(still.err.find("still.npy: every pixel of the film is constant"), std::string::npos) << still.err;
}

}  // namespace
