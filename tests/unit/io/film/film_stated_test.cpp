// What a file states of its frames (how many, of which channel, when, which way up, what is missing) is used, refused
// or told.
#include <gtest/gtest.h>
#include <tiffio.h>

#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "io/film/formats.hpp"
#include "support/films.hpp"
#include "support/pictures.hpp"
#include "support/temporary_folder.hpp"
#include "unit/io/film/stated.hpp"
#include "unit/io/film/tiff_pages.hpp"

namespace arenite::io {
namespace {

using test::counted;
using Numbers64 = std::vector<std::int64_t>;

// TIFF

/// A TIFF file of 16 bits with one directory, behind which its images lie.
std::string one_directory(bool high_first, const std::string& description, const Film& film) {
  const auto number = [&](std::uint32_t value, std::size_t size) {
    std::string bytes;
    for (std::size_t i = 0; i < size; ++i) bytes += static_cast<char>(value >> 8 * (high_first ? size - 1 - i : i));
    return bytes;
  };
  const auto frame = static_cast<std::uint32_t>(2 * film.about.pixels());
  const std::uint32_t text = 8 + 2 + 9 * 12 + 4, first = text + static_cast<std::uint32_t>(description.size()) + 1;
  std::string bytes = (high_first ? "MM" : "II") + number(42, 2) + number(8, 4) + number(9, 2);
  const auto entry = [&](std::uint32_t tag, std::uint32_t type, std::uint32_t count, std::uint32_t value) {
    bytes += number(tag, 2) + number(type, 2) + number(count, 4) +
             (type == 3 ? number(value, 2) + number(0, 2) : number(value, 4));
  };
  entry(256, 4, 1, static_cast<std::uint32_t>(film.about.width));
  entry(257, 4, 1, static_cast<std::uint32_t>(film.about.height));
  entry(258, 3, 1, 16);
  entry(262, 3, 1, 1);
  entry(270, 2, static_cast<std::uint32_t>(description.size()) + 1, text);
  entry(273, 4, 1, first);
  entry(277, 3, 1, 1);
  entry(278, 4, 1, static_cast<std::uint32_t>(film.about.height));
  entry(279, 4, 1, frame);
  bytes += number(0, 4) + description + '\0';
  for (const std::uint16_t level : film.level) bytes += number(level, 2);
  return bytes;
}

TEST(StatedFilm, AllImagesBehindTheOneDirectoryOfImageJ) {
  const auto film = open_film(data("imagej-one-directory.tif"));
  EXPECT_EQ(film->info().frames, 120);
  EXPECT_EQ(film->info().width, 10);
  EXPECT_EQ(film->info().height, 6);
  const std::string bytes = open_bytes(data("imagej-one-directory.tif"))->text(0, 1 << 20);
  const FrameBlock all = test::all_of(*film);
  for (std::size_t i = 0; i < all.level.size(); ++i)
    ASSERT_EQ(all.level[i], number_at<std::uint16_t>(bytes, 352 + 2 * i));
}

TEST(StatedFilm, ImagesBehindOneDirectoryInEitherOrderOfBytes) {
  const Film film = counted(5, 4, 6);
  for (const bool high_first : {false, true})
    for (const char* by : {"ImageJ=1.54f\nimages=6\nslices=6\n", "ImageJ=1.54f\nimages=6\nframes=6\n",
                           "{\"shape\": [6, 4, 5]}", "{\"shape\": [2, 3, 4, 5], \"axes\": \"TZYX\"}"}) {
      const std::string bytes = one_directory(high_first, by, film);
      const auto read = open_film(bytes_in_memory(bytes, "a.tif"));
      EXPECT_EQ(test::all_of(*read).level, film.level) << by;
      const auto said =
          test::complaint([&] { open_film(bytes_in_memory(bytes.substr(0, bytes.size() - 1), "a.tif")); });
      EXPECT_NE(said.find("holds 5 images, but"), std::string::npos) << said;
    }
}

TEST(StatedFilm, OneChannelOfSeveralIsChosen) {
  const auto path = data("imagej-two-channels.tif");
  EXPECT_EQ(
      test::complaint([&] { open_film(path); }),
      path.string() +
          ": holds 120 frames of 2 channels, as ImageJ describes it; choose one with --dataset: channel 1, channel 2");
  EXPECT_THROW(open_film(path, {.dataset = "channel 3"}), InputError);
  const auto first = open_film(path, {.dataset = "channel 1"}), second = open_film(path, {.dataset = "channel 2"});
  EXPECT_EQ(first->info().frames, 120);
  EXPECT_EQ(second->info().frames, 120);
  const FrameBlock one = test::all_of(*first), two = test::all_of(*second);
  TIFF* tiff = TIFFOpen(path.c_str(), "r");
  std::vector<std::uint16_t> page(60);
  for (std::size_t n = 0; n < 240; ++n) {
    ASSERT_EQ(TIFFSetDirectory(tiff, static_cast<tdir_t>(n)), 1);
    ASSERT_EQ(TIFFReadEncodedStrip(tiff, 0, page.data(), 120), 120);
    const FrameBlock& channel = n % 2 == 0 ? one : two;
    EXPECT_TRUE(std::equal(page.begin(), page.end(), channel.level.begin() + static_cast<std::ptrdiff_t>(60 * (n / 2))))
        << n;
  }
  TIFFClose(tiff);
}

TEST(StatedFilm, OmeStatesChannelsTheirOrderAndTimes) {
  const test::TemporaryFolder folder;
  const Film film = counted(5, 4, 6);
  const auto ome = [](const std::string& order, const std::string& planes) {
    return "<?xml version=\"1.0\"?><OME><Image><Pixels DimensionOrder=\"" + order +
           "\" SizeX=\"5\" SizeY=\"4\" SizeC=\"2\" SizeZ=\"1\" SizeT=\"3\" TimeIncrement=\"20\" "
           "TimeIncrementUnit=\"ms\">" +
           planes + "</Pixels></Image></OME>";
  };
  const auto level_of = [&](const char* channel, std::int64_t frame) {
    const auto read = open_film(folder / "a.tif", {.dataset = channel});
    EXPECT_EQ(read->info().frames, 3);
    EXPECT_NEAR(read->info().frame_rate, 50, 1e-9);
    FrameBlock block;
    read->read(frame, 1, block);
    return block.level[0] / 1000;  // number of the page
  };
  write_pages(folder / "a.tif", film, ome("XYCZT", ""));
  EXPECT_EQ(level_of("channel 2", 1), 3);
  write_pages(folder / "a.tif", film, ome("XYTCZ", ""));
  EXPECT_EQ(level_of("channel 2", 1), 4);
  write_pages(folder / "a.tif", film,
              ome("XYCZT",
                  "<Plane TheC=\"1\" TheT=\"0\" TheZ=\"0\" DeltaT=\"7\"/><Plane TheC=\"1\" TheT=\"1\" TheZ=\"0\" "
                  "DeltaT=\"7.02\"/>"
                  "<Plane TheC=\"1\" TheT=\"2\" TheZ=\"0\" DeltaT=\"7.04\"/>"));
  const auto read = open_film(folder / "a.tif", {.dataset = "channel 2"});
  ASSERT_EQ(read->info().time.size(), 3U);
  EXPECT_NEAR(read->info().time[2], 0.04, 1e-9);
}

TEST(StatedFilm, DescriptionsThatThePagesContradict) {
  const test::TemporaryFolder folder;
  const auto opened = [&](const std::string& description) {
    write_pages(folder / "a.tif", counted(5, 4, 6), description);
    return open_film(folder / "a.tif");
  };
  EXPECT_NE(test::complaint([&] { opened("ImageJ=1.5\nimages=7\n"); }).find("holds 6 images, but ImageJ describes 7"),
            std::string::npos);
  EXPECT_NE(test::complaint([&] { opened("ImageJ=1.5\nimages=6\nslices=2\nframes=3\n"); }).find("3 frames of 2 slices"),
            std::string::npos);
  EXPECT_TRUE(tells(*opened("ImageJ=1.5\nimages=4\n"), "describes 4 images, but the film has 6 pages"));
  const auto timed = opened("ImageJ=1.5\nimages=6\nframes=6\nfinterval=0.04\nfps=7.0\n");
  EXPECT_NEAR(timed->info().frame_rate, 25, 1e-12);
  EXPECT_TRUE(timed->info().remarks.empty());
  EXPECT_NEAR(opened("ImageJ=1.5\nimages=6\nframes=6\nfinterval=40\ntunit=ms\n")->info().frame_rate, 25, 1e-12);
  EXPECT_TRUE(tells(*opened("ImageJ=1.5\nimages=6\nframes=6\nfinterval=40\ntunit=fortnight\n"), "\"fortnight\""));
  const auto shown = opened("ImageJ=1.5\nimages=6\nframes=6\nfps=7.0\n");
  EXPECT_EQ(shown->info().frame_rate, 0);
  EXPECT_TRUE(tells(*shown, "7 frames/s"));
}

TEST(StatedFilm, RateInTheDescriptionOfAPage) {
  const test::TemporaryFolder folder;
  const auto opened = [&](const std::string& description) {
    write_pages(folder / "a.tif", counted(5, 4, 6), description);
    return open_film(folder / "a.tif");
  };
  EXPECT_NEAR(opened("Camera: X\nframe rate = 0.1 kHz\n")->info().frame_rate, 100, 1e-9);
  EXPECT_NEAR(opened("Frame interval [ms]: 40")->info().frame_rate, 25, 1e-9);
  const auto other = opened("fps = fast");
  EXPECT_EQ(other->info().frame_rate, 0);
  EXPECT_TRUE(tells(*other, "fps = fast"));
}

// Series

/// Text frames of two pixels, named by `name`.
void write_frames(const std::filesystem::path& folder, const Numbers64& numbers,
                  const std::function<std::string(std::int64_t)>& name) {
  std::filesystem::remove_all(folder);
  std::filesystem::create_directory(folder);
  for (const auto n : numbers) test::spill(folder / name(n), std::to_string(n) + " 1\n");
}

TEST(StatedFilm, NumbersInNamesAreTimes) {
  const test::TemporaryFolder folder;
  const auto plain = [](std::int64_t n) { return "shot2_f" + std::to_string(n) + ".asc"; };
  Numbers64 kept;
  for (std::int64_t n = 5; n < 125; ++n)
    if (n % 10 != 0) kept.push_back(n);
  write_frames(folder / "f", kept, plain);
  for (const auto& rate : {std::optional<double>(), std::optional<double>(30)}) {
    const auto film = open_film(folder / "f", {.frame_rate = rate});
    EXPECT_EQ(film->info().frames, 108);
    ASSERT_EQ(film->info().number.size(), 108U);
    EXPECT_EQ(film->info().number[5], 6);
    EXPECT_EQ(film->info().number.back(), 119);
    const FrameIntervals found = frame_intervals(film->info());
    EXPECT_EQ(found.dropped, 12);
    EXPECT_EQ(found.gap.size(), 12U);
    EXPECT_EQ(found.gap[0], 5);
    EXPECT_NEAR(found.duration, rate ? 119 / 30.0 : 0, 1e-9);
    EXPECT_TRUE(tells(*film, "12 frames are missing, the first before frame 5"));
  }
  write_frames(folder / "f", {0, 1, 2, 3}, plain);
  EXPECT_TRUE(open_film(folder / "f")->info().number.empty());
  EXPECT_TRUE(open_film(folder / "f")->info().remarks.empty());
  write_frames(folder / "f", {100, 110, 120, 140}, plain);
  EXPECT_EQ(open_film(folder / "f")->info().number, (Numbers64{0, 1, 2, 4}));
  EXPECT_TRUE(tells(*open_film(folder / "f"), "rise by 10"));
}

TEST(StatedFilm, NumbersThatCountSomethingElseAreTold) {
  const test::TemporaryFolder folder;
  const auto told = [&](const Numbers64& numbers, const std::function<std::string(std::int64_t)>& name) {
    write_frames(folder / "f", numbers, name);
    const auto film = open_film(folder / "f");
    EXPECT_TRUE(film->info().number.empty());
    return tells(*film, "do not count frames one by one");
  };
  EXPECT_TRUE(told({0, 33, 67, 100, 133}, [](std::int64_t n) { return "t" + std::to_string(n) + "ms.asc"; }));
  EXPECT_TRUE(
      told({1, 2, 3}, [](std::int64_t n) { return "a" + std::to_string(n) + "_" + std::to_string(7 * n) + ".asc"; }));
  EXPECT_TRUE(told({1, 2, 3}, [](std::int64_t n) { return (n == 2 ? "b" : "a") + std::to_string(n) + ".asc"; }));
}

TEST(StatedFilm, StampsOfFilesInASeriesAreItsTimes) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directory(folder / "f");
  const double stamps[] = {100, 100.02, 100.04, 100.1};
  for (const char* ending : {".tif", ".h5", ".ptw"}) {
    for (std::size_t n = 0; n < 4; ++n) {
      Film one = counted(5, 4, 1);
      one.about.time = {stamps[n]};
      write_film(folder / ("f/f" + std::to_string(n) + ending), one);
    }
    const auto film = open_film(folder / (std::string("f/f*") + ending));
    ASSERT_EQ(film->info().time.size(), 4U) << ending;
    EXPECT_NEAR(film->info().time[3], 0.1, 1e-6) << ending;
    EXPECT_EQ(frame_intervals(film->info()).dropped, 2) << ending;
  }
}

// Stamps and numbers of single files

TEST(StatedFilm, StampsThatARateSetsAsideAreTold) {
  const test::TemporaryFolder folder;
  Film film = counted(5, 4, 4);
  film.about.time = {0, 0.008, 0.016, 0.04};
  for (const char* name : {"a.tif", "a.h5", "a.ptw"}) {
    write_film(folder / name, film);
    EXPECT_TRUE(open_film(folder / name)->info().remarks.empty()) << name;
    const auto read = open_film(folder / name, {.frame_rate = 125.0});
    EXPECT_TRUE(read->info().time.empty()) << name;
    EXPECT_TRUE(tells(*read, "Time stamps say that 2 frames are missing")) << name;
  }
}

TEST(StatedFilm, EvenStampsAreNoMissingFrames) {
  FilmInfo info;
  info.frames = 4;
  info.frame_rate = 100;
  take_stamps(info, {1, 1.03, 1.06, 1.09});
  EXPECT_EQ(frame_intervals(info).dropped, 0);
  EXPECT_TRUE(frame_intervals(info).gap.empty());
  EXPECT_EQ(info.remarks,
            std::vector<std::string>{
                "Frames are stamped 0.03 s apart, while the film states a frame rate of 100 Hz; the stamps are used."});
}

TEST(StatedFilm, StampsInMillisecondsCountLongGapsRightly) {
  FilmInfo info;  // 148 Hz, rounded to a millisecond; frames 100 to 299 are missing
  Numbers64 numbers;
  std::vector<double> stamp;
  for (std::int64_t n = 0; n < 400; ++n)
    if (n < 100 || n >= 300) stamp.push_back(std::round(1e3 * static_cast<double>(n) / 148) * 1e-3);
  info.frames = 200;
  take_stamps(info, stamp);
  EXPECT_EQ(frame_intervals(info).dropped, 200);
}

TEST(StatedFilm, TelopsCountsFramesWhereItsClockStands) {
  std::string bytes = test::hcc(counted(8, 4, 3), 1, 0, 0, 0);  // one stamp for all
  const std::size_t frame = bytes.size() / 3;
  EXPECT_TRUE(open_film(bytes_in_memory(bytes, "a.hcc"))->info().number.empty());
  test::set(bytes, 2 * frame + 8, std::uint32_t{5});
  const auto film = open_film(bytes_in_memory(bytes, "a.hcc"));
  EXPECT_TRUE(film->info().time.empty());
  EXPECT_EQ(film->info().number, (Numbers64{0, 1, 5}));
}

TEST(StatedFilm, TextStatesNumbersOrTimesBetweenItsFrames) {
  const auto opened = [](const std::string& text) { return open_film(bytes_in_memory(text, "a.txt")); };
  EXPECT_EQ(opened("Frame 7\n1 2\nFrame 8\n1 3\nFrame 11\n1 4\n")->info().number, (Numbers64{0, 1, 4}));
  EXPECT_TRUE(opened("Frame 7\n1 2\nFrame 8\n1 3\n")->info().number.empty());
  EXPECT_TRUE(opened("Frame 7 of 9\n1 2\n\n1 3\n")->info().number.empty());  // the second has none
  EXPECT_EQ(opened("time = 3\n1 2\ntime = 3.5\n1 3\n")->info().time, (std::vector<double>{0, 0.5}));
}

// HDF5

}  // namespace
}  // namespace arenite::io
