#include <gtest/gtest.h>

#include <algorithm>

#include "io/disk/file.hpp"
#include "io/image/image.hpp"
#include "support/pictures.hpp"
#include "support/temporary_folder.hpp"

namespace {
using namespace arenite;
using namespace arenite::test;
using Values = std::vector<std::int32_t>;

std::string tiff(const std::vector<TiffPage>& pages) {
  const TemporaryFolder folder;
  write_tiff(folder / "a.tif", pages);
  return io::read_file(folder / "a.tif");
}
Image decode_tiff(const std::string& bytes, const io::ImageChoice& choice = {}) {
  return io::decode_image(bytes, "a.tif", choice);
}
std::string tiff_refusal(const std::string& bytes, const io::ImageChoice& choice = {}) {
  return complaint([&] { decode_tiff(bytes, choice); });
}
TiffPage page(std::uint32_t width, std::uint32_t height, std::vector<std::uint8_t> bytes) {
  TiffPage p;
  p.width = width;
  p.height = height;
  p.bytes = std::move(bytes);
  return p;
}

TEST(TiffImage, KeepsTheStoredValuesOfEveryDepthAndCompression) {
  for (const std::uint16_t compression :
       {COMPRESSION_NONE, COMPRESSION_LZW, COMPRESSION_ADOBE_DEFLATE, COMPRESSION_PACKBITS}) {
    TiffPage p = page(3, 3, {0, 85, 170, 1, 2, 3, 4, 5, 255});
    p.compression = compression;
    EXPECT_EQ(decode_tiff(tiff({p})).value, (Values{0, 85, 170, 1, 2, 3, 4, 5, 255})) << compression;
  }
  TiffPage wide = page(2, 1, {0x34, 0x12, 0xff, 0xff});
  wide.bits = 16;
  EXPECT_EQ(decode_tiff(tiff({wide})).value, (Values{0x1234, 0xffff}));
  wide.format = SAMPLEFORMAT_INT;
  EXPECT_EQ(decode_tiff(tiff({wide})).value, (Values{0x1234, -1}));
  TiffPage label = page(1, 1, {0x78, 0x56, 0x34, 0x12});
  label.bits = 32;
  EXPECT_EQ(decode_tiff(tiff({label})).value, (Values{0x12345678}));
  TiffPage bit = page(9, 2, {0xa0, 0x80, 0x01, 0x00});
  bit.bits = 1;
  EXPECT_EQ(decode_tiff(tiff({bit})).value, (Values{1, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 0}));
}

TEST(TiffImage, TurnsWhiteIsZeroRoundAndResolvesAGreyPalette) {
  TiffPage p = page(3, 1, {0, 85, 255});
  p.photometric = PHOTOMETRIC_MINISWHITE;
  EXPECT_EQ(decode_tiff(tiff({p})).value, (Values{255, 170, 0}));
  TiffPage bit = page(3, 1, {0x40});
  bit.bits = 1;
  bit.photometric = PHOTOMETRIC_MINISWHITE;
  EXPECT_EQ(decode_tiff(tiff({bit})).value, (Values{1, 0, 1}));
  p.photometric = PHOTOMETRIC_PALETTE;
  p.bytes = {0, 1, 25};
  EXPECT_EQ(decode_tiff(tiff({p})).value, (Values{0, 10, 250}));
}

TEST(TiffImage, ReadsTilesAsItReadsStrips) {
  constexpr std::uint32_t width = 40, height = 21, side = 16;
  TiffPage tiled = page(width, height, std::vector<std::uint8_t>(3 * 2 * side * side));
  tiled.tile = side;
  Values expected;
  for (std::uint32_t y = 0; y < height; ++y)
    for (std::uint32_t x = 0; x < width; ++x) {
      const auto v = static_cast<std::uint8_t>(7 * x + 13 * y);
      expected.push_back(v);
      tiled.bytes[((y / side) * 3 + x / side) * side * side + (y % side) * side + x % side] = v;
    }
  EXPECT_EQ(decode_tiff(tiff({tiled})).value, expected);
}

TEST(TiffImage, GivesTheSliceThatIsAskedFor) {
  const std::string stack = tiff({page(1, 1, {5}), page(2, 1, {6, 7}), page(1, 1, {8})});
  EXPECT_EQ(tiff_refusal(stack),
            "a.tif: is a stack of 3 slices; choose one with --slice 0 to 2, or for a load take all as voxels with "
            "--dimension 3");
  EXPECT_EQ(decode_tiff(stack, {.slice = 0}).value, (Values{5}));
  EXPECT_EQ(decode_tiff(stack, {.slice = 1}).value, (Values{6, 7}));
  EXPECT_EQ(tiff_refusal(stack, {.slice = 3}), "a.tif: has no slice 3; its slices are numbered from 0 to 2");
  EXPECT_NE(tiff_refusal(stack, {.slice = -1}).find("no slice -1"), std::string::npos);
}

TEST(TiffImage, FloatingNumbersThatAreWholeAreLabels) {
  const Image image =
      io::read_image(std::filesystem::path(ARENITE_SOURCE_DIR) / "tests/data/films/labels-as-floats.tif");
  EXPECT_EQ(image.size(), 64U * 64U);
  EXPECT_EQ(*std::ranges::min_element(image.value), 1);
  EXPECT_EQ(*std::ranges::max_element(image.value), 2);
  TiffPage p = page(2, 1, {0, 0, 0x80, 0x3f, 0, 0, 0xa0, 0xc0});
  p.bits = 32;
  p.format = SAMPLEFORMAT_IEEEFP;
  EXPECT_EQ(decode_tiff(tiff({p})).value, (Values{1, -5}));
}

/// A picture whose directory stands before its one strip, as Pillow writes it.
std::string strip_behind_directory(std::uint32_t width, std::uint32_t height) {
  std::string bytes("II*\0\x08\0\0\0", 8);
  const auto add = [&](std::uint32_t value, int count) {
    for (int k = 0; k < count; ++k) bytes += static_cast<char>(value >> 8 * k & 0xff);
  };
  const std::pair<int, std::uint32_t> entries[] = {
      {TIFFTAG_IMAGEWIDTH, width},    {TIFFTAG_IMAGELENGTH, height},
      {TIFFTAG_BITSPERSAMPLE, 8},     {TIFFTAG_COMPRESSION, 1},
      {TIFFTAG_PHOTOMETRIC, 1},       {TIFFTAG_STRIPOFFSETS, 8 + 2 + 8 * 12 + 4},
      {TIFFTAG_ROWSPERSTRIP, height}, {TIFFTAG_STRIPBYTECOUNTS, width * height}};
  add(8, 2);
  for (const auto& [tag, value] : entries) add(static_cast<std::uint32_t>(tag), 2), add(4, 2), add(1, 4), add(value, 4);
  add(0, 4);
  return bytes + std::string(std::size_t{width} * height, 'a');
}

TEST(TiffImage, CutWithinItsPixelsIsSaidWithoutALineThatItHasNot) {
  const std::string whole = strip_behind_directory(20, 30);
  ASSERT_EQ(decode_tiff(whole).value.size(), 600u);
  const std::string said = tiff_refusal(whole.substr(0, whole.size() - 100));
  EXPECT_NE(said.find("cut short or damaged"), std::string::npos) << said;
  EXPECT_EQ(said.find("4294967295"), std::string::npos) << said;
}

/// The picture 1 2 3 / 4 5 6 as each orientation stores it, by the definition in TIFF 6.0: the first word says where
/// the first row is seen, the second where the first column is.
TEST(TiffImage, IsSeenUprightHoweverItIsStored) {
  struct Stored {
    std::uint16_t orientation;
    std::uint32_t width, height;
    std::vector<std::uint8_t> bytes;
  };
  const Stored all[] = {
      {ORIENTATION_TOPLEFT, 3, 2, {1, 2, 3, 4, 5, 6}},  {ORIENTATION_TOPRIGHT, 3, 2, {3, 2, 1, 6, 5, 4}},
      {ORIENTATION_BOTRIGHT, 3, 2, {6, 5, 4, 3, 2, 1}}, {ORIENTATION_BOTLEFT, 3, 2, {4, 5, 6, 1, 2, 3}},
      {ORIENTATION_LEFTTOP, 2, 3, {1, 4, 2, 5, 3, 6}},  {ORIENTATION_RIGHTTOP, 2, 3, {3, 6, 2, 5, 1, 4}},
      {ORIENTATION_RIGHTBOT, 2, 3, {6, 3, 5, 2, 4, 1}}, {ORIENTATION_LEFTBOT, 2, 3, {4, 1, 5, 2, 6, 3}}};
  for (const Stored& stored : all) {
    TiffPage p = page(stored.width, stored.height, stored.bytes);
    p.orientation = stored.orientation;
    const Image image = decode_tiff(tiff({p}));
    EXPECT_EQ(image.width, 3) << stored.orientation;
    EXPECT_EQ(image.value, (Values{1, 2, 3, 4, 5, 6})) << stored.orientation;
  }
}

TEST(TiffImage, AStackOfWhichOnlyOnePictureCanBeReachedIsRefused) {
  const std::string said = complaint([] {
    io::read_image(std::filesystem::path(ARENITE_SOURCE_DIR) / "tests/data/films/imagej-one-directory.tif",
                   {.slice = 0});
  });
  EXPECT_NE(said.find("holds one picture, but ImageJ describes 120 images"), std::string::npos) << said;
}

TEST(TiffImage, RefusesFractionsColourTransparencyAndOddDepths) {
  TiffPage p = page(2, 1, {0, 0, 0x80, 0x3f, 0, 0, 0x20, 0x40});  // 1 and 2.5
  p.bits = 32;
  p.format = SAMPLEFORMAT_IEEEFP;
  EXPECT_EQ(tiff_refusal(tiff({p})),
            "a.tif: holds floating-point numbers with fractions (2.5 at pixel 1, 0); save whole numbers, one value per "
            "phase");
  p.bytes = {0, 0, 0x80, 0x3f, 0, 0, 0xc0, 0x7f};  // 1 and no number
  EXPECT_NE(tiff_refusal(tiff({p})).find("holds no number at pixel 1, 0"), std::string::npos);
  p.bytes = {0, 0, 0x80, 0x3f, 0xf9, 0x02, 0x15, 0x50};  // 1e10
  EXPECT_NE(tiff_refusal(tiff({p})).find("the value 1e+10 at pixel 1, 0"), std::string::npos);
  TiffPage rgb = page(2, 1, {7, 7, 7, 1, 2, 3});
  rgb.samples = 3;
  rgb.photometric = PHOTOMETRIC_RGB;
  EXPECT_NE(tiff_refusal(tiff({rgb})).find("in colour (pixel 1, 0)"), std::string::npos);
  rgb.bytes = {7, 7, 7, 9, 9, 9};
  EXPECT_EQ(decode_tiff(tiff({rgb})).value, (Values{7, 9}));
  TiffPage clear = page(1, 1, {7, 0});
  clear.samples = 2;
  EXPECT_NE(tiff_refusal(tiff({clear})).find("transparent"), std::string::npos);
  TiffPage deep = page(1, 1, {0, 0, 0, 0, 0, 0, 0, 0});
  deep.bits = 64;
  EXPECT_NE(tiff_refusal(tiff({deep})).find("64 bits per sample"), std::string::npos);
}

TEST(TiffImage, RefusesAFileCutShortAtAnyByte) {
  const std::string whole = tiff({page(6, 5, std::vector<std::uint8_t>(30, 85))});
  for (std::size_t n = 4; n < whole.size(); ++n) {
    const std::string said = tiff_refusal(whole.substr(0, n));
    EXPECT_FALSE(said.empty()) << n;
  }
  EXPECT_NE(tiff_refusal(whole.substr(0, 20)).find("cut short or damaged"), std::string::npos);
}

TEST(TiffImage, RefusesTooLargePictures) {
  const std::string whole = tiff({page(6, 5, std::vector<std::uint8_t>(30, 85))});
  EXPECT_NE(tiff_refusal(whole, {.slice = {}, .dataset = {}, .most_pixels = 29}).find("6 x 5 pixels"),
            std::string::npos);
}

}  // namespace
