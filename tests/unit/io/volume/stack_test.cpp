#include "io/volume/stack.hpp"

#include <gtest/gtest.h>

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
    return test::complaint([&] { open_slices(folder_.path()); });
  }
  VolumeFacts facts() const { return open_slices(folder_.path())->facts(); }
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

TEST(Slices, PicturesOfAnotherKindAreRefusedAsSlices) {
  const SlicesOfFiles none({});
  for (const char* name : {"a1.png", "a2.png"}) test::spill(none / name, test::grey_png(2, 2, std::string(4, 'a')));
  const std::string refused = none.refused();
  EXPECT_NE(refused.find("a1.png: is a PNG picture, and slices are read from TIFF"), std::string::npos) << refused;
  EXPECT_EQ(refused.find("film"), std::string::npos) << refused;
}

}  // namespace
}  // namespace arenite::io
