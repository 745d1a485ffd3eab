#include <gtest/gtest.h>
#include <hdf5.h>

#include "io/film/formats.hpp"
#include "support/films.hpp"
#include "support/temporary_folder.hpp"
#include "unit/io/film/same_films.hpp"

namespace arenite::io {
namespace {

using test::counted;

TEST(FilmFormats, PtwWithStampsOverMidnight) {
  const Film film = counted();
  const auto read = opened(test::ptw(film));
  expect_same(*read, film);
  ASSERT_EQ(read->info().time.size(), 3U);
  EXPECT_NEAR(read->info().time[2], 0.02, 1e-9);
  EXPECT_TRUE(opened(test::ptw(film), {.frame_rate = 50.0})->info().time.empty());
  EXPECT_EQ(opened(test::ptw(film), {.frame_rate = 50.0})->info().frame_rate, 50);
  EXPECT_TRUE(opened(test::ptw(film, 0))->info().time.empty());           // one stamp for all says nothing
  EXPECT_EQ(opened(test::ptw(film, -0.001))->info().remarks.size(), 1U);  // nor do stamps that run backwards
  expect_same(*opened(test::ptw(film, 0.01, 500, 0)), film);              // other sizes of headers
}

TEST(FilmFormats, PtwLockInLineIsLeftOut) {
  Film film = counted(6, 4, 2);
  const Film with_line = film;
  Film without = counted(6, 3, 2);
  for (int f = 0; f < 2; ++f)
    for (int i = 0; i < 18; ++i)
      without.level[static_cast<std::size_t>(18 * f + i)] = with_line.level[static_cast<std::size_t>(24 * f + 6 + i)];
  const std::uint16_t mark[] = {1220, 3907, 1204, 2382};
  for (std::size_t f = 0; f < 2; ++f)
    std::copy(mark, mark + 4, film.level.begin() + static_cast<std::ptrdiff_t>(24 * f));
  const auto read = opened(test::ptw(film));
  expect_same(*read, without);
  ASSERT_EQ(read->info().remarks.size(), 1U);
  EXPECT_NE(read->info().remarks[0].find("lock-in"), std::string::npos);
  const test::TemporaryFolder folder;
  for (std::size_t f = 0; f < 2; ++f)
    film.level[24 * f + 4] = static_cast<std::uint16_t>(100 + 7 * f), film.level[24 * f + 5] = 9;
  test::spill(folder / "lock.ptw", test::ptw(film));
  test::spill(folder / "plain.ptw", test::ptw(with_line));
  EXPECT_EQ(lock_in_line(folder / "lock.ptw"), (std::vector<double>{100, 107}));
  EXPECT_TRUE(lock_in_line(folder / "plain.ptw").empty());
}

TEST(FilmFormats, DroppedFramesAreSeenFromTheStamps) {
  FilmInfo info;
  info.frames = 5;
  info.frame_rate = 100;
  take_stamps(info, {3.00, 3.01, 3.02, 3.05, 3.06});
  const FrameIntervals times = frame_intervals(info);
  EXPECT_EQ(times.dropped, 2);
  EXPECT_EQ(times.gap, std::vector<std::int64_t>{3});
  EXPECT_NEAR(times.interval, 0.01, 1e-12);
  EXPECT_NEAR(times.duration, 0.06, 1e-12);
}

TEST(FilmFormats, Sfmov) {
  for (const bool floating : {false, true}) {
    const Film film = counted(5, 4, 3, floating);
    const auto read = opened(test::sfmov(film, "FRate_0 148\r\nITime_0 1.5\r\nADBits 14\r\nNote MYDATA in words\r\n"));
    expect_same(*read, film);
    EXPECT_EQ(read->info().frame_rate, 148);
    EXPECT_DOUBLE_EQ(read->info().integration, 0.0015);
  }
  std::string unix_ends = test::sfmov(counted());
  for (std::size_t at; (at = unix_ends.find("\r\n")) < unix_ends.find("DATA") + 6;) unix_ends.erase(at, 1);
  expect_same(*opened(unix_ends), counted());
}

TEST(FilmFormats, SfmovTakesTheRateFromTheFileItIncludes) {
  const test::TemporaryFolder folder;
  test::spill(folder / "rec.inc", "HdSize auto\nFRate_0 30\nITime_0 6.68608\nDATA\n");
  test::spill(folder / "rec.sfmov", test::sfmov(counted(), "Include rec.inc\r\n"));
  const auto read = open_film(folder / "rec.sfmov");
  EXPECT_EQ(read->info().frame_rate, 30);
  EXPECT_NEAR(read->info().integration, 6.68608e-3, 1e-12);
}

TEST(FilmFormats, Hcc) {
  const Film film = counted(8, 4, 3);
  const auto read = opened(test::hcc(film));
  expect_same(*read, film);
  EXPECT_EQ(read->info().frame_rate, 125);
  EXPECT_DOUBLE_EQ(read->info().integration, 0.0015);
  ASSERT_EQ(read->info().time.size(), 3U);
  EXPECT_NEAR(read->info().time[1], 0.008, 1e-9);
  EXPECT_NEAR(read->info().time[2], 0.016, 1e-9);
  const auto scaled = opened(test::hcc(film, 2, -4, 10));
  ASSERT_TRUE(scaled->info().floating);
  EXPECT_EQ(test::all_of(*scaled).value[8 * 4 + 1], 10 + 1001 / 16.0F);
}

TEST(FilmFormats, AnyFilmCanBeToldItsScale) {
  const test::TemporaryFolder folder;
  test::spill(folder / "a.ptw", test::ptw(counted()));
  for (int f = 0; f < 3; ++f)
    test::spill(folder / ("s" + std::to_string(f) + ".asc"), std::to_string(1000 * f) + " 1\n");
  const auto film = open_film(folder / "a.ptw", {.frame_rate = 50.0, .scale = 0.01, .offset = 273.15});
  EXPECT_EQ(film->info().quantity, FilmQuantity::kelvin);
  EXPECT_TRUE(film->info().floating);
  EXPECT_EQ(film->info().frame_rate, 50);
  const auto values = test::all_of(*film).value;
  ASSERT_EQ(values.size(), 60U);
  EXPECT_FLOAT_EQ(values[0], 273.15F);
  EXPECT_FLOAT_EQ(values[59], static_cast<float>(273.15 + 0.01 * 2034));
  const auto series =
      open_film(folder / "s*.asc", {.offset = 273.15});  // once, and not once for the file and once for all
  EXPECT_FLOAT_EQ(test::all_of(*series).value[4], 2273.15F);
}

TEST(FilmFormats, SeriesOfFilesInTheOrderOfTheirNumbers) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directory(folder / "frames");
  for (int f = 0; f < 12; ++f)
    test::spill(folder / ("frames/f" + std::to_string(f) + ".asc"),
                std::to_string(1000 * f) + " " + std::to_string(1000 * f + 1) + "\n");
  test::spill(folder / "frames/notes.md", "by hand\n");
  const Film film = as_floating(counted(2, 1, 12));
  expect_same(*open_film(folder / "frames"), film);
  expect_same(*open_film(folder / "frames/f*.asc", {.frame_rate = 25.0}), film);
  EXPECT_EQ(open_film(folder / "frames/f*.asc", {.frame_rate = 25.0})->info().frame_rate, 25);
}

TEST(FilmFormats, Hdf5OfOthers) {
  const test::TemporaryFolder folder;
  const Film film = counted();
  const hid_t file = H5Fcreate((folder / "a.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  const hsize_t shape[] = {3, 4, 5}, three = 3;
  const hid_t group = H5Gcreate2(file, "camera", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  const hid_t space = H5Screate_simple(3, shape, nullptr), line = H5Screate_simple(1, &three, nullptr),
              one = H5Screate(H5S_SCALAR);
  const hid_t set = H5Dcreate2(group, "data", H5T_STD_U16BE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  H5Dwrite(set, H5T_NATIVE_UINT16, H5S_ALL, H5S_ALL, H5P_DEFAULT, film.level.data());
  const hid_t time = H5Dcreate2(group, "timestamps", H5T_IEEE_F64LE, line, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  const double stamp[] = {7, 7.5, 9};
  H5Dwrite(time, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, stamp);
  const hid_t rate = H5Acreate2(file, "fps", H5T_STD_I32LE, one, H5P_DEFAULT, H5P_DEFAULT);
  const int fps = 2;
  H5Awrite(rate, H5T_NATIVE_INT, &fps);
  for (const hid_t id : {set, time}) H5Dclose(id);
  for (const hid_t id : {space, line, one}) H5Sclose(id);
  H5Aclose(rate);
  H5Gclose(group);
  H5Fclose(file);
  const auto read = open_film(folder / "a.h5", {.dataset = "camera/data"});
  expect_same(*read, film);
  expect_same(*open_film(folder / "a.h5"), film);
  EXPECT_EQ(read->info().frame_rate, 2);
  EXPECT_EQ(read->info().time, (std::vector<double>{0, 0.5, 2}));
  EXPECT_EQ(frame_intervals(read->info()).dropped, 2);
}

}  // namespace
}  // namespace arenite::io
