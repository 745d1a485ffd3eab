#include <gtest/gtest.h>

#include <cstdlib>

#include "io/image/image.hpp"
#include "support/pictures.hpp"

namespace {
using namespace arenite;
using namespace arenite::test;

Image decode(const std::string& bytes, io::Channel channel = io::Channel::grey) {
  return io::decode_image(bytes, "a.jpg", {.channel = channel});
}
std::string refusal(const std::string& bytes) {
  return complaint([&] { decode(bytes); });
}

/// A slope in red, another in green, a constant blue; or the first of these alone.
std::string slopes(unsigned width, unsigned height, int samples) {
  std::string pixels;
  for (unsigned y = 0; y < height; ++y)
    for (unsigned x = 0; x < width; ++x)
      for (int c = 0; c < samples; ++c) pixels += static_cast<char>(c == 0 ? 5 * x : c == 1 ? 7 * y : 90);
  return pixels;
}

void expect_slopes(const Image& image, int per_x, int per_y, int constant, int tolerance) {
  ASSERT_EQ(image.value.size(), image.size());
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      EXPECT_NEAR(image.value[image.index(x, y)], per_x * x + per_y * y + constant, tolerance) << x << ", " << y;
}

TEST(JpegImage, ReadsGreyAndTheChannelsOfColourRowByRowFromTheTop) {
  expect_slopes(decode(jpeg(21, 18, 1, slopes(21, 18, 1))), 5, 0, 0, 2);
  for (const bool progressive : {false, true}) {
    const std::string colour = jpeg(21, 18, 3, slopes(21, 18, 3), progressive);
    expect_slopes(decode(colour, io::Channel::red), 5, 0, 0, 4);
    expect_slopes(decode(colour, io::Channel::green), 0, 7, 0, 4);
    expect_slopes(decode(colour, io::Channel::blue), 0, 0, 90, 4);
  }
}

/// A camera held upright stores its rows as columns: the first row is seen on the right.
TEST(JpegImage, IsSeenAsItsExifSays) {
  const std::string stored = jpeg(21, 18, 1, slopes(21, 18, 1));
  for (const bool low_first : {false, true}) {
    const std::string data = std::string("Exif\0\0", 6) + exif(6, low_first);
    const std::string marker = std::string("\xff\xe1\0", 3) + static_cast<char>(data.size() + 2) + data;
    const Image image = decode(stored.substr(0, 2) + marker + stored.substr(2));
    ASSERT_EQ(image.width, 18);
    ASSERT_EQ(image.height, 21);
    expect_slopes(image, 0, 5, 0, 2);
  }
}

TEST(JpegImage, IsNoPhaseMap) {
  EXPECT_EQ(complaint([] { decode(jpeg(8, 8, 1, slopes(8, 8, 1)), io::Channel::none); }),
            "a.jpg: is a JPEG picture, which blurs values across edges; save the phases as one of PNG, TIFF, HDF5");
}

TEST(JpegImage, RefusesAFileCutShortAtAnyByte) {
  for (const bool progressive : {false, true}) {
    const std::string whole = jpeg(21, 18, 3, slopes(21, 18, 3), progressive);
    for (std::size_t n = 3; n + 2 < whole.size(); ++n)  // the last two only say that it ends
      EXPECT_NE(refusal(whole.substr(0, n)).find("cut short or damaged"), std::string::npos) << n;
  }
}

TEST(JpegImage, RefusesInksAndSizesOfTooMuch) {
  EXPECT_NE(refusal(jpeg(8, 8, 4, std::string(256, 'a'))).find("printing inks"), std::string::npos);
  std::string wide = jpeg(8, 8, 1, slopes(8, 8, 1));
  const auto frame = wide.find("\xff\xc0");
  ASSERT_NE(frame, std::string::npos);
  for (const std::size_t byte : {5, 6, 7, 8}) wide[frame + byte] = '\xf0';
  EXPECT_NE(refusal(wide).find("61680 x 61680 pixels, but at most 100 million can be read"), std::string::npos)
      << refusal(wide);
}

}  // namespace
