#include "study/foreign_map.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "io/field_file.hpp"
#include "support/field_results.hpp"
#include "support/pictures.hpp"
#include "support/temporary_folder.hpp"

namespace {
using namespace arenite;
using namespace arenite::test;

class ForeignMap : public ::testing::Test {
 protected:
  std::filesystem::path write(const char* name, const std::string& bytes) {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return folder_ / name;
  }
  TemporaryFolder folder_;
};

std::string joined(const std::vector<std::string>& notes) {
  std::string text;
  for (const auto& note : notes) text += note + "\n";
  return text;
}

TEST_F(ForeignMap, FindsGrainsWhereThereAreNoLabelsAndSaysHow) {
  const auto path = write("map.png", grey_png(5, 1, std::string("\1\0\1\1\1", 5)));
  const auto read = study::read_foreign_map(path, {});
  EXPECT_EQ(read.map.grain, (std::vector<std::int32_t>{0, -1, 1, 1, 1}));
  EXPECT_EQ(joined(read.notes), "Values 0 (20 %), 1 (80 %): the lower was taken as void, the higher as particle.\n"
                                "2 grains found as connected particles.\n"
                                "The largest of them holds 75 % of the particle nodes: if grains touch, find them with --grains watershed.\n");
  study::ForeignMapOptions options;
  options.labelling = {imaging::Labelling::watershed, 0.5};
  EXPECT_NE(joined(study::read_foreign_map(path, options).notes).find("by a watershed of the distance transform, smoothed by 0.5 nodes"),
            std::string::npos);
  options.reading.labels = write("labels.png", grey_png(5, 1, std::string("\1\0\2\3\3", 5)));
  const auto labelled = study::read_foreign_map(path, options);
  EXPECT_EQ(labelled.map.grain, (std::vector<std::int32_t>{0, -1, 1, 2, 2}));
  EXPECT_NE(joined(labelled.notes).find("3 grains by the labels given."), std::string::npos);
}

TEST_F(ForeignMap, TakesTheMapOfAResultAsItIs) {
  const FieldResult result = small_field();
  io::write_field(folder_ / "field.h5", result);
  const auto read = study::read_foreign_map(folder_ / "field.h5", {});
  EXPECT_EQ(read.map.phase, result.map.phase);
  EXPECT_EQ(read.map.grain, result.map.grain);
  EXPECT_EQ(read.map.grain_class, result.map.grain_class);
  EXPECT_EQ(read.map.dx, result.map.dx);
  study::ForeignMapOptions options;
  options.reading.dx = 2;
  EXPECT_NE(complaint([&] { study::read_foreign_map(folder_ / "field.h5", options); }).find("leave out the options"), std::string::npos);
  EXPECT_NE(complaint([&] { study::read_foreign_map(write("stage.h5", "arenite result format 1\n"), {}); }).find("without a phase map"),
            std::string::npos);
}

}  // namespace
