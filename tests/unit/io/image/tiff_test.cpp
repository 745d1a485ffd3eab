#include <gtest/gtest.h>

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
Image decode_tiff(const std::string& bytes, const io::ImageChoice& choice = {}) { return io::decode_image(bytes, "a.tif", choice); }
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
  for (const std::uint16_t compression : {COMPRESSION_NONE, COMPRESSION_LZW, COMPRESSION_ADOBE_DEFLATE, COMPRESSION_PACKBITS}) {
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
  EXPECT_EQ(tiff_refusal(stack), "a.tif: is a stack of 3 slices; choose one with --slice 0 to 2");
  EXPECT_EQ(decode_tiff(stack, {.slice = 0}).value, (Values{5}));
  EXPECT_EQ(decode_tiff(stack, {.slice = 1}).value, (Values{6, 7}));
  EXPECT_EQ(tiff_refusal(stack, {.slice = 3}), "a.tif: has no slice 3; its slices are numbered from 0 to 2");
  EXPECT_NE(tiff_refusal(stack, {.slice = -1}).find("no slice -1"), std::string::npos);
}

TEST(TiffImage, RefusesFractionsColourTransparencyAndOddDepths) {
  TiffPage p = page(1, 1, {0, 0, 0, 0});
  p.bits = 32;
  p.format = SAMPLEFORMAT_IEEEFP;
  EXPECT_NE(tiff_refusal(tiff({p})).find("numbers with fractions"), std::string::npos);
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
  EXPECT_NE(tiff_refusal(whole, {.slice = {}, .dataset = {}, .most_pixels = 29}).find("6 x 5 pixels"), std::string::npos);
}

}  // namespace
