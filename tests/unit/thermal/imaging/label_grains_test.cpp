#include "thermal/imaging/label_grains.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "support/homogeneous_sample.hpp"
#include "support/pictures.hpp"

namespace {
using namespace arenite;
using namespace arenite::imaging;

PhaseMap speckled(int width, int height, int share_of_ten) {
  PhaseMap map = make_phase_map(width, height, 1);
  for (Phase& p : map.phase)
    p = *rc::gen::inRange(0, 10) < share_of_ten ? Phase::particle : *rc::gen::element(Phase::empty, Phase::matrix);
  return map;
}
PhaseMap disks(int size, const std::vector<std::array<double, 3>>& all) {
  PhaseMap map = make_phase_map(size, size, 1);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      for (const auto& [cx, cy, r] : all)
        if (std::hypot(x - cx, y - cy) <= r) map.phase[map.index(x, y)] = Phase::particle;
  return map;
}
std::int32_t grains(PhaseMap map, Labelling way, double smoothing = 1) {
  label_grains(map, {way, smoothing});
  return static_cast<std::int32_t>(map.grain_class.size());
}

std::int32_t nearest_by_search(const PhaseMap& map, int x, int y) {
  std::int32_t least = std::numeric_limits<std::int32_t>::max();
  for (int v = 0; v < map.height; ++v)
    for (int u = 0; u < map.width; ++u)
      if (map.phase[map.index(u, v)] != Phase::particle) least = std::min(least, (u - x) * (u - x) + (v - y) * (v - y));
  return least;
}

TEST(SquaredDistance, IsThatOfASearch) {
  EXPECT_TRUE(rc::check([] {
    const PhaseMap map = speckled(*rc::gen::inRange(1, 24), *rc::gen::inRange(1, 24), *rc::gen::inRange(5, 11));
    const auto squared = squared_distance(map);
    for (int y = 0; y < map.height; ++y)
      for (int x = 0; x < map.width; ++x) RC_ASSERT(squared[map.index(x, y)] == nearest_by_search(map, x, y));
  }));
}

/// Spreads a number through neighbours until nothing changes: slow and plainly right.
std::vector<std::int32_t> components_by_spreading(const PhaseMap& map) {
  std::vector<std::int32_t> mark(map.size(), -1);
  for (std::size_t i = 0; i < mark.size(); ++i)
    if (map.phase[i] == Phase::particle) mark[i] = static_cast<std::int32_t>(i);
  for (bool changed = true; changed;) {
    changed = false;
    const auto level = [&](std::size_t a, std::size_t b) {
      if (mark[a] < 0 || mark[b] < 0 || mark[a] == mark[b]) return;
      mark[a] = mark[b] = std::min(mark[a], mark[b]);
      changed = true;
    };
    for (int y = 0; y < map.height; ++y)
      for (int x = 0; x < map.width; ++x) {
        if (x > 0) level(map.index(x, y), map.index(x - 1, y));
        if (y > 0) level(map.index(x, y), map.index(x, y - 1));
      }
  }
  return mark;
}

TEST(LabelGrains, FindsTheSameComponentsAsSpreading) {
  EXPECT_TRUE(rc::check([] {
    PhaseMap map = speckled(*rc::gen::inRange(1, 24), *rc::gen::inRange(1, 24), *rc::gen::inRange(3, 9));
    label_grains(map, {});
    check(map);
    const auto expected = components_by_spreading(map);
    std::map<std::int32_t, std::int32_t> number;  // in the order of first nodes, as labels must be
    for (std::size_t i = 0; i < map.size(); ++i) {
      const auto n =
          expected[i] < 0 ? -1 : number.emplace(expected[i], static_cast<std::int32_t>(number.size())).first->second;
      RC_ASSERT(map.grain[i] == n);
    }
  }));
}

TEST(LabelGrains, CutsTouchingDisksAtTheirNeck) {
  const PhaseMap map = disks(64, {{20, 32, 12}, {42, 32, 12}});
  EXPECT_EQ(grains(map, Labelling::components), 1);
  EXPECT_EQ(grains(map, Labelling::watershed), 2);
  PhaseMap cut = map;
  label_grains(cut, {Labelling::watershed, 1});
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x)
      if (std::abs(x - 31) > 1 && map.phase[map.index(x, y)] == Phase::particle) {
        ASSERT_EQ(cut.grain[cut.index(x, y)] == cut.grain[cut.index(20, 32)], x < 31) << x << ' ' << y;
      }
}

TEST(LabelGrains, SmoothingJoinsWhatANeckHardlyParts) {
  const PhaseMap map = disks(64, {{24, 32, 14}, {40, 32, 14}});  // half width of the neck: sqrt(14^2 - 8^2) = 11.5
  EXPECT_EQ(grains(map, Labelling::watershed, 1), 2);
  EXPECT_EQ(grains(map, Labelling::watershed, 4), 1);
  for (const double radius : {3.0, 5.5, 9.3, 17.0, 25.0})
    EXPECT_EQ(grains(disks(64, {{31.3, 30.8, radius}}), Labelling::watershed), 1) << radius;
}

TEST(LabelGrains, FindsEachOfManyTouchingDisks) {
  std::vector<std::array<double, 3>> lattice;
  for (int j = 0; j < 5; ++j)
    for (int i = 0; i < 5; ++i) lattice.push_back({16.0 + 24 * i + 12 * (j % 2), 16.0 + 21 * j, 12.4});
  const PhaseMap map = disks(140, lattice);
  EXPECT_EQ(grains(map, Labelling::components), 1);
  EXPECT_EQ(grains(map, Labelling::watershed), 25);
}

TEST(LabelGrains, WatershedRefinesComponentsAndCoversThem) {
  EXPECT_TRUE(rc::check([] {
    PhaseMap whole = speckled(*rc::gen::inRange(1, 30), *rc::gen::inRange(1, 30), *rc::gen::inRange(6, 11)),
             cut = whole;
    label_grains(whole, {});
    label_grains(cut, {Labelling::watershed, 0.5 * *rc::gen::inRange(0, 5)});
    check(cut);
    std::map<std::int32_t, std::int32_t> component;
    for (std::size_t i = 0; i < cut.size(); ++i)
      if (cut.grain[i] >= 0) RC_ASSERT(component.emplace(cut.grain[i], whole.grain[i]).first->second == whole.grain[i]);
  }));
}

TEST(LabelGrains, HandlesMapsOfParticleOnlyAndOfNone) {
  EXPECT_EQ(grains(test::homogeneous_sample(9, 5, Phase::particle), Labelling::watershed), 1);
  EXPECT_EQ(grains(test::homogeneous_sample(9, 5, Phase::matrix), Labelling::watershed), 0);
  EXPECT_EQ(grains(make_phase_map(9, 5, 1), Labelling::components), 0);
  PhaseMap map = make_phase_map(3, 3, 1);
  for (const double wrong : {-1.0, std::nan("")})
    EXPECT_NE(test::complaint([&] {
                label_grains(map, {Labelling::watershed, wrong});
              }).find("smoothing"),
              std::string::npos);
}

}  // namespace
