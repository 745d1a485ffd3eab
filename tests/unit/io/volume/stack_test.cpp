#include "io/volume/stack.hpp"

#include <gtest/gtest.h>
#include <tiffio.h>

#include <string>
#include <vector>

#include "io/film/film.hpp"
#include "support/films.hpp"
#include "support/pictures.hpp"
#include "support/temporary_folder.hpp"

namespace arenite::io {
namespace {

/// Slices of 5 x 4 pixels with these numbers in their names.
class SlicesOfFiles {
 public:
  explicit SlicesOfFiles(const std::vector<int>& numbers) {
    for (const int number : numbers) {
      Film slice = test::counted(5, 4, 1);
      write_film(folder_ / ("s" + std::to_string(number) + ".tif"), slice);
    }
  }
  std::string refused() const {
    return test::complaint([&] { open_slices(folder_.path(), {}); });
  }
  VolumeFacts facts() const { return open_slices(folder_.path(), {})->facts(); }
  std::filesystem::path operator/(const std::string& name) const { return folder_ / name; }

 private:
  test::TemporaryFolder folder_;
};

TEST(Slices, OneThatIsMissingIsNamedAndTheRestNoVolume) {
  EXPECT_EQ(SlicesOfFiles({8, 9, 10, 11}).facts().depth, 4);
  EXPECT_EQ(SlicesOfFiles({0, 10, 20}).facts().depth, 3) << "a step that all have";
  const std::string one = SlicesOfFiles({7, 8, 10, 11}).refused();
  EXPECT_NE(one.find("lacks 1 of its slices"), std::string::npos) << one;
  EXPECT_NE(one.find("number 9, would follow s8.tif; add"), std::string::npos) << one;
  const std::string more = SlicesOfFiles({0, 2, 4, 10, 12, 16}).refused();
  EXPECT_NE(more.find("lacks 3 of its slices"), std::string::npos) << more;
  EXPECT_NE(more.find("number 6, would follow s4.tif"), std::string::npos) << more;
}

TEST(Slices, AreToldOfAsSlicesAndNotAsFrames) {
  for (const std::string& remark : SlicesOfFiles({0, 10, 20}).facts().remarks)
    EXPECT_EQ(remark.find("frame"), std::string::npos) << remark;
}

TEST(Slices, PicturesThatAreNotAsFarApartAsPixelsAreWideAreNoCubes) {
  const test::TemporaryFolder folder;
  const std::filesystem::path path = folder / "a.tif";
  const auto opened = [&](const char* spacing, bool dx_given = false) {
    Film pictures = test::counted(5, 4, 6);
    write_film(path, pictures);
    TIFF* const file = TIFFOpen(path.c_str(), "r+");
    TIFFSetField(file, TIFFTAG_XRESOLUTION, 2.0), TIFFSetField(file, TIFFTAG_YRESOLUTION, 2.0);
    TIFFSetField(file, TIFFTAG_RESOLUTIONUNIT, RESUNIT_NONE);
    TIFFSetField(file, TIFFTAG_IMAGEDESCRIPTION,
                 (std::string("ImageJ=1.53t\nimages=6\nslices=6\nunit=um\n") + spacing).c_str());
    TIFFRewriteDirectory(file);
    TIFFClose(file);
    return open_volume(path, {.dx_given = dx_given})->facts();
  };
  const VolumeFacts cubes = opened("spacing=0.5\n");
  EXPECT_EQ(cubes.depth, 6);
  ASSERT_FALSE(cubes.remarks.empty());
  EXPECT_NE(cubes.remarks.back().find("states pixels of 0.5 um"), std::string::npos);
  EXPECT_NE(test::complaint([&] { opened("spacing=2\n"); }).find("pixels of 0.5 um and pictures 2 um apart"),
            std::string::npos);
  EXPECT_EQ(opened("spacing=2\n", true).depth, 6);
}

TEST(Slices, PicturesOfAnotherKindAreRefusedAsSlices) {
  const SlicesOfFiles none({});
  for (const char* name : {"a1.png", "a2.png"}) test::spill(none / name, test::grey_png(2, 2, std::string(4, 'a')));
  const std::string refused = none.refused();
  EXPECT_NE(refused.find("a1.png: is a PNG picture, and slices are read from TIFF"), std::string::npos) << refused;
  EXPECT_EQ(refused.find("film"), std::string::npos) << refused;
}

}  // namespace
}  // namespace arenite::io
