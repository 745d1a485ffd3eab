#include "io/film/stated_times.hpp"

#include <gtest/gtest.h>
#include <tiffio.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "io/film/film.hpp"
#include "support/films.hpp"
#include "support/temporary_folder.hpp"
#include "unit/io/film/stated.hpp"

namespace arenite::io {
namespace {

using Numbers64 = std::vector<std::int64_t>;

TEST(StatedTimes, NamesOfTimesAndNumbers) {
  EXPECT_EQ(unit_of_time_name("Timestamps"), "");
  EXPECT_EQ(unit_of_time_name("time_ms"), "ms");
  EXPECT_EQ(unit_of_time_name("timestamp_s"), "s");
  EXPECT_EQ(unit_of_time_name("time_stamp"), "");
  for (const char* other : {"T", "T_s", "exposure_time", "time_zone", "frames", "timer"})
    EXPECT_FALSE(unit_of_time_name(other)) << other;
  for (const char* array : {"frame", "frames", "Frame", "index", "image_number", "frame_id"})
    EXPECT_TRUE(names_array_of_numbers(array)) << array;
  EXPECT_FALSE(names_array_of_numbers("frame_rate"));
  EXPECT_TRUE(names_frame_numbers("Frame-Number"));
  EXPECT_FALSE(names_frame_numbers("frame_rate"));
}

TEST(StatedTimes, WordsOfAFrame) {
  const auto time = [](const char* text) { return words_of_frame(text).time; };
  EXPECT_NEAR(time("time = 33.3 ms"), 0.0333, 1e-12);
  EXPECT_NEAR(time("# Time: 0.033 s"), 0.033, 1e-12);
  EXPECT_NEAR(time("# Frame #12, t=0.4000 s"), 0.4, 1e-12);
  EXPECT_NEAR(time("{\"frame\": 12, \"timestamp_ms\": 400}"), 0.4, 1e-12);
  EXPECT_NEAR(time("Time: 2024-05-01 01:00:03.25"), 3603.25, 1e-9);
  EXPECT_NEAR(time("t = 0,4 s"), 0.4, 1e-12);
  EXPECT_NEAR(time("Time [ms]: 33.33"), 0.03333, 1e-12);
  EXPECT_NEAR(time("time (s) = 0.4"), 0.4, 1e-12);
  for (const char* text : {"frame rate = 30 Hz", "Frame_Rate: 30", "fps: 30.0 fps"})
    EXPECT_DOUBLE_EQ(words_of_frame(text).rate, 30) << text;
  for (const char* text :
       {"frame rate = 0.1 kHz", "FrameRate: 100 HZ", "frame_rate_Hz = 100", "Frame rate (kHz): 0.1", "frame rate: 1e2",
        "fps=100,0", "frame rate = 6000 1/min", "frame interval = 10 ms", "Frame_interval_ms: 10",
        "{\"frame_rate\": 100, \"bits\": 14}", "Frame interval [ms]: 10", "frame rate: 100 Hz (nominal)"})
    EXPECT_DOUBLE_EQ(words_of_frame(text).rate, 100) << text;
  for (const char* none : {"frame rate", "frame rate:", "frame = 30"})
    EXPECT_FALSE(words_of_frame(none).rate > 0) << none;
  for (const char* unknown : {"frame rate = 30 mm", "frame rate = fast", "fps: -3", "frame rate: 0 Hz"}) {
    EXPECT_EQ(words_of_frame(unknown).rate, 0) << unknown;
    EXPECT_FALSE(words_of_frame(unknown).unknown_rate.empty()) << unknown;
  }
  EXPECT_NEAR(time("frame_rate = 30\ntime = 0.4\n"), 0.4, 1e-12);
  for (const char* none : {"Exposure time: 2 ms", "T = 300", "time", "lifetime = 3", "timer = 3"})
    EXPECT_TRUE(std::isnan(time(none))) << none;
  EXPECT_EQ(words_of_frame("time = 3 fortnights").not_understood, "3 fortnights");
  EXPECT_EQ(words_of_frame("# Frame #12, t=0.4000 s").number, 12);
  EXPECT_EQ(words_of_frame("{\"frame\": 12, \"timestamp_s\": 0.4}").number, 12);
  EXPECT_EQ(words_of_frame("frame_number = 7").number, 7);
  for (const char* none : {"frame_rate = 30", "frames=10", "120 frames of 3", "Frame"})
    EXPECT_EQ(words_of_frame(none).number, -1) << none;
}

TEST(StatedTimes, TextFramesStateTimesWithUnits) {
  const auto opened = [](const std::string& text) { return open_film(bytes_in_memory(text, "a.txt")); };
  for (const char* form : {"time = {} ms", "# Time: {} ms", "# Frame 3, t={} ms"}) {
    const auto line = [&](const char* value) {
      std::string text = form;
      return text.replace(text.find("{}"), 2, value) + "\n1 2\n";
    };
    const auto film = opened(line("10") + line("20") + line("40"));
    ASSERT_EQ(film->info().time.size(), 3U) << form;
    EXPECT_NEAR(film->info().time[2], 0.03, 1e-12) << form;
  }
  const auto unknown = opened("time = 1 beat\n1 2\ntime = 2 beat\n1 2\n");
  EXPECT_TRUE(unknown->info().time.empty());
  EXPECT_TRUE(tells(*unknown, "Frame 0 states the time \"1 beat\", which is not understood"));
  EXPECT_EQ(opened("frame rate = 0.1 kHz\n1 2\n\n1 2\n")->info().frame_rate, 100);
  EXPECT_TRUE(tells(*opened("frame rate = slow\n1 2\n\n1 2\n"), "frame rate = slow, which is not understood"));
  EXPECT_TRUE(tells(*opened("time = 1\n1 2\n\n1 2\n"), "Only 1 of 2 frames state a time"));
  EXPECT_TRUE(tells(*opened("Frame 1\n1 2\n\n1 2\n"), "Only 1 of 2 frames state a number"));
}

TEST(StatedTimes, WhatTextStatesBesideIsTold) {
  const auto opened = [](const std::string& text) { return open_film(bytes_in_memory(text, "a.txt")); };
  const auto film = opened(
      "# Date: 2026-11-27\nEmissivity = 0.95\nCamera: A655\nunit = K\nframe 1, time = 1 s\n1 2\n# Date: "
      "2026-11-28\nframe 2, time = 2 s\n1 2\n");
  EXPECT_EQ(film->info().camera, "A655");
  ASSERT_EQ(film->info().remarks.size(), 1U);
  EXPECT_TRUE(tells(*film, "state Date, Emissivity, which are not used"));
  EXPECT_TRUE(tells(*film, "temperature.assumed_emissivity"));
  EXPECT_TRUE(tells(*opened("Emissivity;0.95\n1;2;3\n\n4;5;6\n"), "state Emissivity, which is not used"));
  EXPECT_TRUE(opened("frame 1\n1 2\nframe 2\n3 4\n")->info().remarks.empty());
  std::string many;
  for (char c = 'a'; c < 'q'; ++c) many += std::string("key ") + c + " = 1\n";
  EXPECT_TRUE(tells(*opened(many + "1 2\n"), "key h and more, which are not used"));
}

/// Pages of one pixel, each described by `text` under a tag.
std::unique_ptr<FilmSource> pages(const test::TemporaryFolder& folder, ttag_t tag,
                                  const std::vector<std::string>& text) {
  TIFF* tiff = TIFFOpen((folder / "a.tif").c_str(), "w");
  for (const std::string& each : text) {
    for (const auto& [field, value] : {std::pair{TIFFTAG_IMAGEWIDTH, 1},
                                       {TIFFTAG_IMAGELENGTH, 1},
                                       {TIFFTAG_BITSPERSAMPLE, 16},
                                       {TIFFTAG_SAMPLESPERPIXEL, 1},
                                       {TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK},
                                       {TIFFTAG_ROWSPERSTRIP, 1}})
      TIFFSetField(tiff, static_cast<ttag_t>(field), value);
    TIFFSetField(tiff, tag, each.c_str());
    std::uint16_t pixel = 7;
    TIFFWriteEncodedStrip(tiff, 0, &pixel, 2);
    TIFFWriteDirectory(tiff);
  }
  TIFFClose(tiff);
  return open_film(folder / "a.tif");
}

TEST(StatedTimes, DescriptionsOfPagesStateNumbersAndTimes) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(pages(folder, TIFFTAG_IMAGEDESCRIPTION, {"frame 12", "frame 13", "frame 16"})->info().number,
            (Numbers64{0, 1, 4}));
  const auto json = pages(folder, TIFFTAG_IMAGEDESCRIPTION,
                          {"{\"frame\": 1, \"timestamp_s\": 0.5}", "{\"frame\": 2, \"timestamp_s\": 1}"});
  EXPECT_EQ(json->info().time, (std::vector<double>{0, 0.5}));
  EXPECT_TRUE(tells(*pages(folder, TIFFTAG_IMAGEDESCRIPTION, {"time = 1", "none"}), "Only 1 of 2 frames state a time"));
}

TEST(StatedTimes, DatesOfPagesAreTold) {
  const test::TemporaryFolder folder;
  const char *one = "2024:05:01 12:00:00", *later = "2024:05:01 12:00:04";
  EXPECT_TRUE(tells(*pages(folder, TIFFTAG_DATETIME, {one, one, later}), "in whole seconds (DateTime, "));
  EXPECT_TRUE(pages(folder, TIFFTAG_DATETIME, {one, one})->info().remarks.empty());
}

}  // namespace
}  // namespace arenite::io
