#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/films.hpp"
#include "support/program.hpp"

namespace {
using namespace arenite;
using test::arenite;
using test::TemporaryFolder;
using Json = nlohmann::json;

TEST(ShowFilm, JsonOfARealFilm) {
  const auto shown = arenite("show " + test::infrared("PyradiSampleMWIR.ptw").string() + " --json");
  ASSERT_EQ(shown.status, 0) << shown.err;
  const Json j = Json::parse(shown.out);
  EXPECT_EQ(j["width"], 69);
  EXPECT_EQ(j["height"], 64);
  EXPECT_EQ(j["frames"], 100);
  EXPECT_EQ(j["frame_rate_Hz"], 100.0);
  EXPECT_EQ(j["integration_s"], 0.0005);
  EXPECT_EQ(j["camera"], "Jade");
  EXPECT_EQ(j["bits"], 14);
  EXPECT_EQ(j["format"], "ptw");
  EXPECT_EQ(j["quantity"], "digital_level");
  EXPECT_NEAR(j["duration_s"].get<double>(), 2.969785, 1e-6);
  EXPECT_EQ(j["dropped_frames"], 0);
  EXPECT_EQ(j["remarks"].size(), 1U);  // stamps of 30 ms, where the header has 10 ms
  EXPECT_EQ(j["pixels"]["saturated"], 0);
}

TEST(ShowFilm, TextNamesWhatIsMissingAndDoubtful) {
  const TemporaryFolder folder;
  Film film = test::counted(6, 4, 9);
  for (std::size_t i = 0; i < film.level.size(); ++i)
    film.level[i] = i % 24 == 3 ? 16383 : static_cast<std::uint16_t>(i % 24 == 4 ? 7 : i);
  test::spill(folder / "a.ptw", test::ptw(film, 0.02));
  const auto shown = arenite("show " + (folder / "a.ptw").string());
  ASSERT_EQ(shown.status, 0) << shown.err;
  for (const char* words : {"format                           ptw", "frames                           9 ",
                            "width                            6 ", "100 Hz", "0.02 s",
                            "stamped                          yes", "dropped_frames                   0 ",
                            "pixels.constant                  2 ", "pixels.saturated                 1 "})
    EXPECT_NE(shown.out.find(words), std::string::npos) << words << "\n" << shown.out;
}

TEST(ShowFilm, WhatFilesOfOthersStateIsShown) {
  const auto data = [](const char* name) {
    return (std::filesystem::path(ARENITE_SOURCE_DIR) / "tests/data/films" / name).string();
  };
  const auto json = [](const std::string& of) {
    return Json::parse(arenite("show " + of + " --frame-rate 30Hz --json").out);
  };
  EXPECT_EQ(json(data("imagej-one-directory.tif"))["frames"], 120);
  const auto channels = arenite("show " + data("imagej-two-channels.tif"));
  EXPECT_EQ(channels.status, 2);
  EXPECT_NE(channels.err.find("120 frames of 2 channels"), std::string::npos) << channels.err;
  EXPECT_EQ(json(data("imagej-two-channels.tif") + " --dataset \"channel 2\"")["frames"], 120);
  const Json matlab = json(data("matlab.mat"));
  EXPECT_EQ(matlab["width"], 10);
  EXPECT_EQ(matlab["height"], 6);
  EXPECT_EQ(json(data("nan-frame.tif"))["pixels"]["blank_frames"], Json::array({40}));
}

TEST(ShowFilm, ADamagedFilmIsOneSentenceAndStatusTwo) {
  const TemporaryFolder folder;
  test::spill(folder / "a.ptw", test::ptw(test::counted()).substr(0, 5000));
  const auto shown = arenite("show " + (folder / "a.ptw").string() + " --json");
  EXPECT_EQ(shown.status, 2);
  EXPECT_EQ(shown.out, "");
  EXPECT_NE(shown.err.find("a.ptw: is cut short: it declares 3 frames of 5 x 4 pixels and holds 1; copy it again"),
            std::string::npos)
      << shown.err;
}

TEST(ShowFilm, WhatIsNoFilmIsNamedForWhatItIs) {
  const TemporaryFolder folder;
  test::spill(folder / "a.seq", std::string("FFF\0\0\0\1\2 recorded", 17));
  test::spill(folder / "b.mp4", std::string("\0\0\0\x18"
                                            "ftypmp42",
                                            12));
  const std::string seq = (folder / "a.seq").string(), mp4 = (folder / "b.mp4").string();
  for (const std::string& run : {"show " + seq, "lockin " + seq + " --frequency 3Hz", "step " + seq, "grains " + seq}) {
    const auto refused = arenite(run);
    EXPECT_EQ(refused.status, 2) << run;
    EXPECT_NE(refused.err.find("a.seq: is a FLIR sequence (.seq)"), std::string::npos) << run << "\n" << refused.err;
    EXPECT_NE(refused.err.find("export"), std::string::npos) << refused.err;
  }
  EXPECT_NE(arenite("show " + mp4).err.find("is a video (MPEG-4)"), std::string::npos);
}

TEST(ShowFilm, FoldersOfFramesAreFilms) {
  const TemporaryFolder folder;
  for (int f = 0; f < 3; ++f)
    test::spill(folder / ("f" + std::to_string(f) + ".csv"), "1,2\n3," + std::to_string(f) + "\n");
  EXPECT_EQ(Json::parse(arenite("show --json " + folder.path().string()).out)["frames"], 3);
  EXPECT_EQ(Json::parse(arenite("show --json '" + (folder / "f*.csv").string() + "'").out)["frames"], 3);
}

}  // namespace
