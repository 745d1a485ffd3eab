#include "io/volume/header.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "io/volume/volume.hpp"

namespace arenite::io {
namespace {

bool says_of_origin(const std::string& header, const std::string& sentence) {
  const auto volume = open_volume(bytes_in_memory(header + std::string(8, '\1'), "a"));
  return std::ranges::any_of(volume->facts().remarks,
                             [&](const std::string& said) { return said.find(sentence) != std::string::npos; });
}

TEST(VolumeHeader, AnOffsetIsTold) {
  const auto meta = [](const std::string& offset) {
    return "NDims = 3\nDimSize = 2 2 2\nElementType = MET_UCHAR\n" + offset + "ElementDataFile = LOCAL\n";
  };
  EXPECT_TRUE(
      says_of_origin(meta("Offset = 5 0 -1\n"), "its Offset (5, 0, -1) is left aside: places are counted from"));
  EXPECT_FALSE(says_of_origin(meta("Offset = 0 0 0\n"), "Offset"));
  const auto nrrd = [](const std::string& origin) {
    return "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 2 2 2\n" + origin + "encoding: raw\n\n";
  };
  EXPECT_TRUE(says_of_origin(nrrd("space origin: (5,0,0)\n"), "its space origin (5, 0, 0) is left aside"));
  EXPECT_FALSE(says_of_origin(nrrd("space origin: (0,0,0)\n"), "origin"));
}

}  // namespace
}  // namespace arenite::io
