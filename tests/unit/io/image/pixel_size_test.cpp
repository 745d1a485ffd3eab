#include "io/image/pixel_size.hpp"

#include <gtest/gtest.h>
#include <tiffio.h>

#include "support/films.hpp"
#include "support/pictures.hpp"
#include "support/temporary_folder.hpp"

namespace arenite::io {
namespace {

std::string big_endian_number(unsigned value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xff);
  return bytes;
}

TEST(PixelSize, OfPngIsThatOfItsPixelsAMetre) {
  const test::TemporaryFolder folder;
  const auto read = [&](unsigned x, unsigned y, char unit) {
    test::spill(folder / "a.png", "\x89PNG\r\n\x1a\n" + big_endian_number(9) + "pHYs" + big_endian_number(x) +
                                      big_endian_number(y) + unit + "....");
    return stated_pixel(folder / "a.png");
  };
  EXPECT_DOUBLE_EQ(read(80000, 80000, 1).value(), 12.5e-6);
  EXPECT_FALSE(read(80000, 80000, 0));  // a ratio alone
  for (const char unit : {0, 1})
    EXPECT_NE(test::complaint([&] { read(80000, 70000, unit); }).find("a.png: has pixels 0.875 times as wide as high"),
              std::string::npos);
  EXPECT_DOUBLE_EQ(read(80000, 80040, 1).value(), 12.5e-6);  // rounding to whole pixels a metre
  EXPECT_FALSE(read(0, 0, 1));
  for (const unsigned per_metre : {2835, 3780, 11811}) EXPECT_FALSE(read(per_metre, per_metre, 1));  // 72, 96, 300 dpi
}

TEST(PixelSize, OfTiffIsInItsUnitOrThatOfImagej) {
  const test::TemporaryFolder folder;
  const auto read = [&](double resolution, int unit, const char* description, double higher = 1) {
    TIFF* const file = TIFFOpen((folder / "a.tif").c_str(), "w");
    const std::uint8_t pixel = 0;
    for (const auto tag : {TIFFTAG_IMAGEWIDTH, TIFFTAG_IMAGELENGTH, TIFFTAG_ROWSPERSTRIP}) TIFFSetField(file, tag, 1);
    TIFFSetField(file, TIFFTAG_BITSPERSAMPLE, 8), TIFFSetField(file, TIFFTAG_SAMPLESPERPIXEL, 1);
    TIFFSetField(file, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
    TIFFSetField(file, TIFFTAG_XRESOLUTION, resolution), TIFFSetField(file, TIFFTAG_YRESOLUTION, resolution * higher);
    TIFFSetField(file, TIFFTAG_RESOLUTIONUNIT, unit);
    if (*description != 0) TIFFSetField(file, TIFFTAG_IMAGEDESCRIPTION, description);
    TIFFWriteRawStrip(file, 0, const_cast<std::uint8_t*>(&pixel), 1);
    TIFFClose(file);
    return stated_pixel(folder / "a.tif");
  };
  const auto apart = [&] { return stated_voxel(open_bytes(folder / "a.tif")).spacing; };
  EXPECT_NEAR(read(800, RESUNIT_CENTIMETER, "").value(), 12.5e-6, 1e-11);
  EXPECT_NEAR(read(2000, RESUNIT_INCH, "").value(), 12.7e-6, 1e-11);
  EXPECT_NEAR(read(2, RESUNIT_NONE, "ImageJ=1.53t\nunit=um\n").value(), 0.5e-6, 1e-12);
  EXPECT_NEAR(read(4, RESUNIT_NONE, "ImageJ=1.53t\nunit=\\u00B5m\n").value(), 0.25e-6, 1e-12);
  EXPECT_FALSE(apart());
  EXPECT_NEAR(read(2, RESUNIT_NONE, "ImageJ=1.53t\nunit=micron\nspacing=1.5\n").value(), 0.5e-6, 1e-12);
  EXPECT_NEAR(apart().value(), 1.5e-6, 1e-12);
  EXPECT_NEAR(read(300, RESUNIT_INCH,
                   "<OME><Pixels PhysicalSizeX=\"0.5\" PhysicalSizeY=\"0.5\" PhysicalSizeZ=\"2e-3\" "
                   "PhysicalSizeZUnit=\"mm\" SizeC=\"1\" SizeZ=\"1\" SizeT=\"1\"/></OME>")
                  .value(),
              0.5e-6, 1e-12);
  EXPECT_NEAR(apart().value(), 2e-6, 1e-12);
  EXPECT_FALSE(read(2, RESUNIT_NONE, "ImageJ=1.53t\nunit=pixel\nspacing=3\n") || apart());
  EXPECT_FALSE(read(2, RESUNIT_NONE, ""));
  EXPECT_FALSE(read(300, RESUNIT_INCH, ""));
  EXPECT_NE(test::complaint([&] { read(2540, RESUNIT_INCH, "", 0.5); }).find("no squares; resample it"),
            std::string::npos);
}

TEST(PixelSize, OfWhatIsNoPictureIsNone) {
  const test::TemporaryFolder folder;
  test::spill(folder / "a.txt", "1 2 3");
  EXPECT_FALSE(stated_pixel(folder / "a.txt"));
  EXPECT_FALSE(stated_pixel(folder / "none"));
}

}  // namespace
}  // namespace arenite::io
