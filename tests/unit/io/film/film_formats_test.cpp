#include <gtest/gtest.h>
#include <hdf5.h>
#include <tiffio.h>

#include <cmath>

#include "io/film/formats.hpp"
#include "support/films.hpp"
#include "support/pictures.hpp"
#include "support/temporary_folder.hpp"

namespace arenite::io {
namespace {

using test::counted;

/// What was read is what the film holds, at once, in blocks of two and one frame by itself.
void expect_same(FilmSource& read, const Film& film) {
  ASSERT_EQ(read.info().width, film.about.width);
  ASSERT_EQ(read.info().height, film.about.height);
  ASSERT_EQ(read.info().frames, film.about.frames);
  ASSERT_EQ(read.info().floating, film.about.floating);
  const FrameBlock all = test::all_of(read);
  EXPECT_EQ(all.level, film.level);
  EXPECT_EQ(all.value, film.value);
  FrameBlock part;
  for (std::int64_t f = film.about.frames - 1; f >= 0; --f) {
    read.read(f, 1, part);
    EXPECT_EQ(part.first, f);
    for (std::size_t p = 0; p < film.about.pixels(); ++p) {
      const std::size_t at = static_cast<std::size_t>(f) * film.about.pixels() + p;
      if (film.about.floating) EXPECT_EQ(part.value[p], film.value[at]);
      else EXPECT_EQ(part.level[p], film.level[at]);
    }
  }
  EXPECT_THROW(read.read(film.about.frames, 1, part), std::out_of_range);
}

std::unique_ptr<FilmSource> opened(const std::string& bytes, const FilmChoice& choice = {}) {
  return open_film(bytes_in_memory(bytes, "film"), choice);
}

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

template <class T> std::string data_of(const Film& film) {
  std::string bytes;
  for (const std::uint16_t v : film.level) test::add(bytes, static_cast<T>(v));
  return bytes;
}

Film as_floating(Film film) {
  film.about.floating = true;
  film.value.assign(film.level.begin(), film.level.end());
  film.level.clear();
  return film;
}

TEST(FilmFormats, NpyOfEveryType) {
  const Film film = counted(), small = counted(5, 4, 1);
  expect_same(*opened(test::npy("|u1", "(1, 4, 5)", data_of<std::uint8_t>(small))), small);
  expect_same(*opened(test::npy("|u1", "(4, 5)", data_of<std::uint8_t>(small))), small);
  expect_same(*opened(test::npy("<u2", "(3, 4, 5)", data_of<std::uint16_t>(film))), film);
  expect_same(*opened(test::npy("<i2", "(3, 4, 5)", data_of<std::int16_t>(film))), as_floating(film));
  expect_same(*opened(test::npy("<u4", "(3, 4, 5)", data_of<std::uint32_t>(film))), as_floating(film));
  expect_same(*opened(test::npy("<f4", "(3, 4, 5)", data_of<float>(film))), as_floating(film));
  expect_same(*opened(test::npy("<f8", "(3, 4, 5)", data_of<double>(film))), as_floating(film));
  std::string swapped = data_of<std::uint16_t>(film);
  for (std::size_t i = 0; i < swapped.size(); i += 2) std::swap(swapped[i], swapped[i + 1]);
  expect_same(*opened(test::npy(">u2", "(3, 4, 5)", swapped)), film);
}

/// With libtiff, as others write: many strips, tiles, compressed, 64-bit places, either order of bytes.
void write_tiff(const std::filesystem::path& path, const Film& film, const char* mode, bool tiled, int bits) {
  TIFF* tiff = TIFFOpen(path.c_str(), mode);
  for (std::int64_t f = 0; f < film.about.frames; ++f) {
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, film.about.width);
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, film.about.height);
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, bits);
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
    TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, film.about.floating ? SAMPLEFORMAT_IEEEFP : SAMPLEFORMAT_UINT);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
    TIFFSetField(tiff, TIFFTAG_COMPRESSION, COMPRESSION_LZW);
    std::vector<char> buffer;
    const auto put = [&](std::size_t pixel) {
      if (film.about.floating)
        buffer.insert(buffer.end(), reinterpret_cast<const char*>(&film.value[pixel]),
                      reinterpret_cast<const char*>(&film.value[pixel] + 1));
      else
        buffer.insert(buffer.end(), reinterpret_cast<const char*>(&film.level[pixel]),
                      reinterpret_cast<const char*>(&film.level[pixel]) + bits / 8);
    };
    const auto width = static_cast<std::size_t>(film.about.width), height = static_cast<std::size_t>(film.about.height);
    const std::size_t base = static_cast<std::size_t>(f) * film.about.pixels();
    if (tiled) {
      TIFFSetField(tiff, TIFFTAG_TILEWIDTH, 16);
      TIFFSetField(tiff, TIFFTAG_TILELENGTH, 16);
      for (std::uint32_t y = 0; y < height; y += 16)
        for (std::uint32_t x = 0; x < width; x += 16) {
          buffer.clear();
          for (std::size_t r = 0; r < 16; ++r)
            for (std::size_t c = 0; c < 16; ++c)
              put(base + std::min(y + r, height - 1) * width + std::min(x + c, width - 1));
          TIFFWriteTile(tiff, buffer.data(), x, y, 0, 0);
        }
    } else {
      TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, 3);
      for (std::size_t y = 0; y < height; ++y) {
        buffer.clear();
        for (std::size_t c = 0; c < width; ++c) put(base + y * width + c);
        TIFFWriteScanline(tiff, buffer.data(), static_cast<std::uint32_t>(y), 0);
      }
    }
    TIFFWriteDirectory(tiff);
  }
  TIFFClose(tiff);
}

TEST(FilmFormats, TiffAsOthersWriteIt) {
  const test::TemporaryFolder folder;
  for (const char* mode : {"w", "wb", "w8", "w8b"})
    for (const bool tiled : {false, true})
      for (const bool floating : {false, true}) {
        SCOPED_TRACE(std::string(mode) + (tiled ? " tiled" : " strips") + (floating ? " floating" : ""));
        const Film film = counted(21, 19, 3, floating);
        write_tiff(folder / "film.tif", film, mode, tiled, floating ? 32 : 16);
        expect_same(*open_film(folder / "film.tif"), film);
      }
  Film bytes = counted(21, 10, 2);
  for (std::uint16_t& v : bytes.level) v %= 256;
  write_tiff(folder / "film.tif", bytes, "w", false, 8);
  expect_same(*open_film(folder / "film.tif"), bytes);
  EXPECT_EQ(open_film(folder / "film.tif")->info().bits, 8);
}

TEST(FilmFormats, TextWithEverySeparatorAndParting) {
  const Film film = as_floating(counted(3, 2, 2));
  expect_same(*opened("0,1,2\n10,11,12\n\n1000,1001,1002\n1010,1011,1012\n"), film);
  expect_same(*opened("Frame 1\r\n0;1;2;\r\n10;11;12;\r\nFrame 2\r\n1000;1001;1002;\r\n1010;1011;1012;\r\n"), film);
  expect_same(*opened("Frame 1\n0\t1\t2\n10\t11\t12\n# next\n1000\t1001\t1002\n1010\t1011\t1012"), film);
  expect_same(*opened("  0 1   2 \n 10 11 12\n\n\n1000 1001 1002\n1010 1011 1012\n\n"), film);
  const auto decimal = opened("20,5;21,25\n-1,5e1;+3\n");
  EXPECT_EQ(test::all_of(*decimal).value, (std::vector<float>{20.5F, 21.25F, -15, 3}));
}

TEST(FilmFormats, RawWithASidecar) {
  const test::TemporaryFolder folder;
  const Film film = counted();
  std::string bytes(100, 'x');
  for (int f = 0; f < 3; ++f)
    bytes += std::string(7, 'h') + data_of<std::uint16_t>(film).substr(static_cast<std::size_t>(40 * f), 40) + "tt";
  test::spill(folder / "a.raw", bytes);
  test::spill(
      folder / "a.toml",
      "# a film\nwidth = 5\nheight = 4  # rows\ntype = \"uint16\"\noffset = 100\nframe_header = 7\nframe_trailer = 2\n"
      "frame_rate = \"148 Hz\"\nintegration = \"1500 us\"\ncamera = \"C #1\"\nquantity = \"DL\"\n");
  for (const char* name : {"a.raw", "a.toml"}) {
    const auto read = open_film(folder / name);
    expect_same(*read, film);
    EXPECT_EQ(read->info().frame_rate, 148);
    EXPECT_NEAR(read->info().integration, 0.0015, 1e-15);
    EXPECT_EQ(read->info().camera, "C #1");
  }
}

TEST(FilmFormats, ARecipeBesideRawFramesIsNotTheirSidecar) {
  const test::TemporaryFolder folder;
  test::spill(folder / "film.raw", data_of<std::uint16_t>(counted()));
  test::spill(folder / "film.toml", "[container]\nwidth = \"350 mm\"\nheight = \"350 mm\"\n");
  EXPECT_NE(test::complaint([&] { open_film(folder / "film.raw"); }).find("describe raw frames"), std::string::npos);
  test::spill(folder / "film.txt", "width = 5\nheight = 4\ntype = \"uint16\"\n");
  expect_same(*open_film(folder / "film.raw"), counted());
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
