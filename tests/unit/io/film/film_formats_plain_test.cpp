#include <gtest/gtest.h>
#include <tiffio.h>

#include "io/film/formats.hpp"
#include "support/films.hpp"
#include "support/pictures.hpp"
#include "support/temporary_folder.hpp"
#include "unit/io/film/same_films.hpp"

namespace arenite::io {
namespace {

using test::counted;

template <class T> std::string data_of(const Film& film) {
  std::string bytes;
  for (const std::uint16_t v : film.level) test::add(bytes, static_cast<T>(v));
  return bytes;
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

}  // namespace
}  // namespace arenite::io
