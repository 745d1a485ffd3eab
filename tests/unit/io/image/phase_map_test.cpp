#include "io/image/phase_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "support/pictures.hpp"
#include "support/temporary_folder.hpp"

namespace {
using namespace arenite;
using namespace arenite::test;
using io::PhaseMapOptions;
using enum Phase;

const io::PhaseTable electrode{{0, empty}, {85, particle}, {170, matrix}};

io::ForeignMap made(const Image& picture, const PhaseMapOptions& options = {}, const Image* labels = nullptr) {
  return io::make_phase_map(picture, labels, options, "map.png", "labels.png");
}
std::string refusal(const Image& picture, const PhaseMapOptions& options = {}, const Image* labels = nullptr) {
  return complaint([&] { made(picture, options, labels); });
}
PhaseMapOptions with(const io::PhaseTable& table) {
  PhaseMapOptions options;
  options.phases = table;
  return options;
}

TEST(PhaseTable, ReadsValuesAndNamesAndTellsWhatIsWrong) {
  EXPECT_EQ(io::parse_phase_table("0=void,85=particle,170=matrix"), electrode);
  EXPECT_EQ(io::parse_phase_table("0=void, 85=particle, 170=matrix,"), electrode);
  EXPECT_EQ(complaint([] { io::parse_phase_table("0=void,85=partikle"); }),
            "\"partikle\" is not a phase; did you mean \"particle\"?; phases are void, matrix and particle");
  EXPECT_NE(complaint([] { io::parse_phase_table("0:void"); }).find("\"0:void\" does not assign a phase"),
            std::string::npos);
  EXPECT_NE(complaint([] { io::parse_phase_table("x=void"); }).find("does not assign a phase"), std::string::npos);
  EXPECT_NE(complaint([] { io::parse_phase_table("1=void,1=matrix"); }).find("1 is assigned a phase twice"),
            std::string::npos);
  EXPECT_NE(complaint([] { io::parse_phase_table(""); }).find("does not assign a phase"), std::string::npos);
}

TEST(PhaseMapImage, TurnsRowsRoundSoThatTheBottomComesFirst) {
  const auto read = made({2, 2, {0, 85, 170, 170}}, with(electrode));
  EXPECT_EQ(read.map.phase, (std::vector{matrix, matrix, empty, particle}));
  EXPECT_FALSE(read.labelled);
  EXPECT_TRUE(read.notes.empty());
}

TEST(PhaseMapImage, GuessesTwoValuesAndSaysSo) {
  const auto read = made({4, 1, {7, 255, 255, 255}});
  EXPECT_EQ(read.map.phase, (std::vector{empty, particle, particle, particle}));
  ASSERT_EQ(read.notes.size(), 1u);
  EXPECT_EQ(
      read.notes[0],
      "Values 7 (25 %), 255 (75 %): the lower was taken as void, the higher as particle. Where particles lie in a "
      "matrix, give --phases 7=matrix,255=particle.");
}

TEST(PhaseMapImage, AsksForThePhasesOfThreeValues) {
  EXPECT_EQ(refusal({4, 1, {0, 85, 170, 170}}),
            "map.png: has the values 0 (25 %), 85 (25 %), 170 (50 %); state the phase of each, for example with "
            "--phases 0=void,85=matrix,170=particle");
  EXPECT_NE(refusal({9, 1, {0, 1, 2, 3, 4, 5, 6, 7, 8}}).find("has 9 values"), std::string::npos);
}

TEST(PhaseMapImage, NamesValuesWithoutPhase) {
  EXPECT_EQ(refusal({4, 1, {0, 85, 86, 85}}, with(electrode)),
            "map.png: has values whose phase is not given: 86 (25 %); add them to --phases, or save the picture "
            "without smoothing");
}

TEST(PhaseMapImage, RefusesOnePhaseOnly) {
  EXPECT_NE(refusal({2, 1, {255, 255}}).find("the value 255 everywhere"), std::string::npos);
  EXPECT_EQ(refusal({2, 1, {0, 0}}, with(electrode)), "map.png: is void everywhere; give a map of at least two phases");
  EXPECT_NE(refusal({2, 1, {170, 170}}, with(electrode)).find("matrix everywhere"), std::string::npos);
  EXPECT_NE(refusal({2, 1, {85, 85}}, with(electrode)).find("particle everywhere"), std::string::npos);
  const Image one{2, 1, {4, 4}}, two{2, 1, {4, 5}};
  EXPECT_NE(refusal({2, 1, {85, 85}}, with(electrode), &one).find("particle everywhere"), std::string::npos);
  EXPECT_EQ(made({2, 1, {85, 85}}, with(electrode), &two).map.grain, (std::vector<std::int32_t>{0, 1}));  // two grains
  EXPECT_NE(refusal({0, 0, {}}, with(electrode)).find("no pixels"), std::string::npos);
}

TEST(PhaseMapImage, CutsOutARectangleCountedFromTheUpperLeft) {
  PhaseMapOptions options = with(electrode);
  options.crop = io::parse_crop("1,0,2,2");
  options.dx = 0.5;
  const auto map = made({3, 3, {0, 85, 170, 85, 0, 85, 0, 0, 0}}, options).map;
  EXPECT_EQ(map.phase, (std::vector{empty, particle, particle, matrix}));
  EXPECT_EQ(map.dx, 0.5);
  for (const char* outside : {"2,0,2,2", "0,-1,2,2", "0,0,0,2", "0,2147483647,2,2", "2147483647,0,2147483647,1"}) {
    options.crop = io::parse_crop(outside);
    EXPECT_NE(refusal({3, 3, {0, 85, 170, 85, 0, 85, 0, 0, 0}}, options).find("does not lie inside"), std::string::npos)
        << outside;
  }
  for (const char* wrong : {"", "1,2,3", "1,2,3,4,5", "a,2,3,4", "1;2;3;4"})
    EXPECT_NE(complaint([&] { io::parse_crop(wrong); }).find("is not a rectangle"), std::string::npos) << wrong;
  PhaseMapOptions no_length = with(electrode);
  no_length.dx = 0;
  EXPECT_NE(refusal({2, 1, {0, 85}}, no_length).find("positive length"), std::string::npos);
}

TEST(PhaseMapImage, NumbersGrainsByTheirFirstNodeFromTheBottom) {
  const Image labels{3, 2, {9, 9, 70000, 0, 3, 70000}};
  const auto read = made({3, 2, {85, 85, 85, 0, 85, 85}}, with(electrode), &labels);
  EXPECT_TRUE(read.labelled);
  EXPECT_EQ(read.map.grain, (std::vector<std::int32_t>{-1, 0, 1, 2, 2, 1}));
  EXPECT_EQ(read.map.grain_class.size(), 3u);
  check(read.map);
}

TEST(PhaseMapImage, NamesLabelsThatDoNotFitTheMap) {
  const Image picture{3, 1, {85, 85, 170}};
  const Image few{3, 1, {4, 0, 0}}, many{3, 1, {4, 4, 4}}, both{3, 1, {0, 4, 4}}, narrow{2, 1, {4, 4}};
  EXPECT_EQ(refusal(picture, with(electrode), &few),
            "labels.png: has no label for 1 particle pixels, the first at 1, 0; label them, or leave the labels out so "
            "that grains are found");
  EXPECT_EQ(refusal(picture, with(electrode), &many),
            "labels.png: labels 1 pixels that are not particle, the first at 2, 0; write 0 there, or state with "
            "--phases that they are particle");
  const std::string two_problems = refusal(picture, with(electrode), &both);
  EXPECT_EQ(std::count(two_problems.begin(), two_problems.end(), '\n'), 1) << two_problems;
  EXPECT_NE(refusal(picture, with(electrode), &narrow).find("has 2 x 1 pixels and the phase map 3 x 1"),
            std::string::npos);
  EXPECT_NE(refusal({2, 1, {0, 170}}, with(electrode), &narrow).find("a map without particles"), std::string::npos);
}

TEST(PhaseMapImage, ReadsAMapAndItsLabelsFromFiles) {
  const TemporaryFolder folder;
  const auto write = [&](const char* name, const std::string& bytes) {
    std::ofstream(folder / name, std::ios::binary) << bytes;
  };
  write("map.png", grey_png(2, 2, std::string("\0\x55\x55\x55", 4)));
  write("labels.png", grey_png(2, 2, std::string("\0\1\2\2", 4)));
  PhaseMapOptions options = with(electrode);
  options.labels = folder / "labels.png";
  EXPECT_EQ(io::read_phase_map(folder / "map.png", options).map.grain, (std::vector<std::int32_t>{0, 0, -1, 1}));
  options.labels = folder / "missing.png";
  EXPECT_NE(
      complaint([&] { io::read_phase_map(folder / "map.png", options); }).find("missing.png: there is no such file"),
      std::string::npos);
}

}  // namespace
