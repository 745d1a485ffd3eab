#include <gtest/gtest.h>

#include "io/image/image.hpp"
#include "support/pictures.hpp"

namespace {
using namespace arenite;
using namespace arenite::test;
using Values = std::vector<std::int32_t>;

Image decode_png(const std::string& bytes, const io::ImageChoice& choice = {}) {
  return io::decode_image(bytes, "a.png", choice);
}
std::string png_refusal(const std::string& bytes, const io::ImageChoice& choice = {}) {
  return complaint([&] { decode_png(bytes, choice); });
}

TEST(PngImage, KeepsTheStoredValuesOfEveryDepth) {
  const Image bytes = decode_png(grey_png(3, 2, std::string("\0\1\2\x55\xaa\xff", 6)));
  EXPECT_EQ(bytes.width, 3);
  EXPECT_EQ(bytes.height, 2);
  EXPECT_EQ(bytes.value, (Values{0, 1, 2, 0x55, 0xaa, 0xff}));
  EXPECT_EQ(decode_png(png(2, 1, 16, grey, {std::string("\x01\x02\xff\xfe", 4)})).value, (Values{0x0102, 0xfffe}));
  EXPECT_EQ(decode_png(png(9, 1, 1, grey, {std::string("\xa0\x80", 2)})).value, (Values{1, 0, 1, 0, 0, 0, 0, 0, 1}));
  EXPECT_EQ(decode_png(png(4, 1, 2, grey, {"\x1b"})).value, (Values{0, 1, 2, 3}));
  EXPECT_EQ(decode_png(png(2, 1, 4, grey, {"\x3c"})).value, (Values{3, 12}));
}

TEST(PngImage, IsSeenAsItsExifSays) {
  const std::string stored = grey_png(2, 3, std::string("\3\6\2\5\1\4", 6)), before = stored.substr(0, 8 + 25);
  for (const bool low_first : {false, true}) {
    const Image image = decode_png(before + png_chunk("eXIf", exif(6, low_first)) + stored.substr(before.size()));
    EXPECT_EQ(image.width, 3);
    EXPECT_EQ(image.value, (Values{1, 2, 3, 4, 5, 6}));
  }
}

TEST(PngImage, TakesAGreyPaletteAsWhatItShowsAndRefusesColour) {
  const std::string greys("\0\0\0\x55\x55\x55\xff\xff\xff", 9), red("\0\0\0\xff\0\0", 6);
  EXPECT_EQ(decode_png(png(3, 1, 8, palette, {std::string("\2\1\0", 3)}, greys)).value, (Values{255, 85, 0}));
  EXPECT_EQ(decode_png(png(3, 1, 8, palette, {std::string("\0\0\0", 3)}, red)).value,
            (Values{0, 0, 0}));  // no pixel is red
  EXPECT_EQ(
      png_refusal(png(3, 1, 8, palette, {std::string("\0\0\1", 3)}, red)),
      "a.png: is in colour (pixel 2, 0), and colours are not phases; save it as greyscale with one value per phase");
  EXPECT_NE(png_refusal(png(1, 1, 8, palette, {"\x07"}, greys)).find("not in its palette"), std::string::npos);
}

TEST(PngImage, TakesColourThatIsGreyAndOpacityThatIsFull) {
  EXPECT_EQ(decode_png(png(2, 1, 8, colour, {"\7\7\7\x9\x9\x9"})).value, (Values{7, 9}));
  EXPECT_EQ(decode_png(png(2, 1, 8, grey_alpha, {"\7\xff\x9\xff"})).value, (Values{7, 9}));
  EXPECT_EQ(decode_png(png(1, 1, 16, colour_alpha, {"\1\2\1\2\1\2\xff\xff"})).value, (Values{0x0102}));
  EXPECT_NE(png_refusal(png(2, 1, 8, colour, {"\7\7\7\x9\x9\x8"})).find("in colour (pixel 1, 0)"), std::string::npos);
  EXPECT_NE(png_refusal(png(2, 1, 8, grey_alpha, {"\7\xff\x9\xfe"})).find("transparent at pixel 1, 0"),
            std::string::npos);
}

/// A value that stands for a transparent pixel is an alpha channel by another name.
TEST(PngImage, RefusesAPixelThatAChunkCallsTransparentAsItDoesAnAlphaChannel) {
  const auto with = [](std::string bytes, const std::string& before, const std::string& clear) {
    return bytes.insert(bytes.find(before) - 4, png_chunk("tRNS", clear));
  };
  const std::string greys = grey_png(3, 1, std::string("\0\1\2", 3));
  EXPECT_NE(png_refusal(with(greys, "IDAT", std::string("\0\1", 2))).find("transparent at pixel 1, 0"),
            std::string::npos);
  EXPECT_EQ(decode_png(with(greys, "IDAT", std::string("\0\7", 2))).value, (Values{0, 1, 2})) << "no pixel is";
  const std::string two = png(2, 1, 8, palette, {std::string("\1\0", 2)}, std::string("\0\0\0\7\7\7", 6));
  EXPECT_NE(png_refusal(with(two, "IDAT", "\x80")).find("transparent at pixel 1, 0"), std::string::npos);
  EXPECT_EQ(decode_png(with(two, "IDAT", "\xff")).value, (Values{7, 0}));
  const std::string seen = png(2, 1, 8, colour, {"\7\7\7\x9\x9\x9"});
  EXPECT_NE(png_refusal(with(seen, "IDAT", std::string("\0\x9\0\x9\0\x9", 6))).find("transparent at pixel 1, 0"),
            std::string::npos);
  EXPECT_EQ(decode_png(with(seen, "IDAT", std::string("\0\x9\0\x9\0\x8", 6))).value, (Values{7, 9}));
}

TEST(PngImage, TakesTheChannelThatIsChosenOfAColour) {
  const auto value = [](io::Channel channel, const std::string& bytes) {
    return decode_png(bytes, {.channel = channel}).value;
  };
  const std::string pixels = png(2, 1, 8, colour, {std::string("\x0a\x14\x3f\x07\x07\x07", 6)});
  EXPECT_EQ(value(io::Channel::red, pixels), (Values{10, 7}));
  EXPECT_EQ(value(io::Channel::green, pixels), (Values{20, 7}));
  EXPECT_EQ(value(io::Channel::blue, pixels), (Values{63, 7}));
  EXPECT_EQ(value(io::Channel::mean, pixels), (Values{31, 7}));
  EXPECT_EQ(value(io::Channel::grey, pixels), (Values{22, 7}));  // 2.99 + 11.74 + 7.182
  EXPECT_EQ(
      value(io::Channel::green, png(1, 1, 8, palette, {std::string("\1", 1)}, std::string("\0\0\0\xff\x05\0", 6))),
      (Values{5}));
  EXPECT_EQ(value(io::Channel::blue, grey_png(1, 1, "a")), (Values{'a'}));
}

TEST(PngImage, RefusesAFileCutShortAtAnyByte) {
  const std::string whole = grey_png(5, 4, std::string(20, '\x55'));
  for (std::size_t n = 8; n < whole.size(); ++n) {
    const std::string said = png_refusal(whole.substr(0, n));
    EXPECT_NE(said.find("cut short or damaged"), std::string::npos) << n << ": " << said;
  }
  std::string flipped = whole;
  flipped[whole.size() - 20] ^= 1;
  EXPECT_NE(png_refusal(flipped).find("damaged"), std::string::npos);
}

TEST(PngImage, RefusesSizesOfNothingAndOfTooMuch) {
  EXPECT_NE(png_refusal(png(0, 4, 8, grey, {})).find("damaged"), std::string::npos);
  EXPECT_EQ(png_refusal(png(100000, 100000, 8, grey, {})),
            "a.png: holds a picture of 100000 x 100000 pixels, but at most 100 million can be read; crop it");
  EXPECT_NE(png_refusal(grey_png(3, 1, "abc"), {.slice = {}, .dataset = {}, .most_pixels = 2}).find("crop it"),
            std::string::npos);
  EXPECT_NE(png_refusal(grey_png(3, 1, "abc"), {.slice = 1}).find("no slice 1"), std::string::npos);
}

TEST(Image, SaysWhatIsNoPicture) {
  EXPECT_NE(png_refusal("").find("is empty"), std::string::npos);
  EXPECT_NE(png_refusal("id,x,y\n").find("is no picture in a known format; save it as one of " + io::picture_formats()),
            std::string::npos);
  EXPECT_NE(png_refusal("\x1f\x8b\x08").find("is compressed (gzip); unpack it (gunzip)"), std::string::npos);
  EXPECT_NE(png_refusal("\xff\xd8\xff\xe0").find("JPEG"), std::string::npos);
  EXPECT_NE(complaint([] { io::read_image("/nowhere.png"); }).find("no such file"), std::string::npos);
}

}  // namespace
