#include "geometry/label_cells.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

namespace {
using namespace arenite::geometry;

std::vector<std::uint8_t> speckles(const arenite::geometry::Cells& cells, int share_of_ten) {
  std::vector<std::uint8_t> inside(cells.size());
  for (auto& in : inside) in = *rc::gen::inRange(0, 10) < share_of_ten;
  return inside;
}

std::array<int, 3> place_of(const arenite::geometry::Cells& cells, std::size_t cell) {
  const auto i = static_cast<int>(cell);
  return {i % cells.width, i / cells.width % cells.height, i / cells.width / cells.height};
}

std::int32_t nearest_by_search(const arenite::geometry::Cells& cells, const std::vector<std::uint8_t>& inside,
                               std::size_t cell) {
  std::int32_t least = std::numeric_limits<std::int32_t>::max();
  const auto from = place_of(cells, cell);
  for (std::size_t other = 0; other < inside.size(); ++other) {
    if (inside[other]) continue;
    const auto to = place_of(cells, other);
    std::int32_t squared = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      int apart = std::abs(to[axis] - from[axis]);
      if (cells.periodic) apart = std::min(apart, cells.count()[axis] - apart);
      squared += apart * apart;
    }
    least = std::min(least, squared);
  }
  return least;
}

TEST(SquaredDistanceOfCells, IsThatOfASearchInSpaceAndInAPeriod) {
  EXPECT_TRUE(rc::check([] {
    const auto side = [] { return *rc::gen::inRange(1, 9); };
    const arenite::geometry::Cells cells{side(), side(), side(), *rc::gen::arbitrary<bool>()};
    const auto inside = speckles(cells, *rc::gen::inRange(5, 11));
    const auto squared = squared_distance(cells, inside);
    for (std::size_t k = 0; k < inside.size(); ++k) RC_ASSERT(squared[k] == nearest_by_search(cells, inside, k));
  }));
}

/// Balls of one radius.
std::vector<std::uint8_t> balls(const arenite::geometry::Cells& cells,
                                const std::vector<std::array<double, 3>>& centres, double radius) {
  std::vector<std::uint8_t> inside(cells.size(), 0);
  for (std::size_t k = 0; k < inside.size(); ++k) {
    const auto at = place_of(cells, k);
    for (const auto& c : centres) {
      double squared = 0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        double apart = std::abs(at[axis] + 0.5 - c[axis]);
        if (cells.periodic) apart = std::min(apart, cells.count()[axis] - apart);
        squared += apart * apart;
      }
      if (squared <= radius * radius) inside[k] = 1;
    }
  }
  return inside;
}

TEST(LabelCells, OverlappingBallsArePartedAtThePlaneBetweenThem) {
  const arenite::geometry::Cells cells{48, 28, 28};
  const auto inside = balls(cells, {{15, 14, 14}, {33, 14, 14}}, 11);
  EXPECT_EQ(label_cells(cells, inside, {}).count, 1);
  const CellLabels cut = label_cells(cells, inside, {Labelling::watershed, 1});
  ASSERT_EQ(cut.count, 2);
  for (std::size_t k = 0; k < inside.size(); ++k)
    ASSERT_EQ(cut.label[k], !inside[k] ? -1 : place_of(cells, k)[0] < 24 ? 0 : 1) << k;
  // The neck's half width is sqrt(11^2 - 9^2) = 6.3: the saddle lies 4.7 below both summits.
  EXPECT_EQ(label_cells(cells, inside, {Labelling::watershed, 6}).count, 1);
}

TEST(LabelCells, APeriodJoinsWhatItsFacesCut) {
  const arenite::geometry::Cells open{30, 16, 16}, period{30, 16, 16, true};
  const auto inside = balls(period, {{0, 8, 8}, {15, 8, 8}}, 6);  // the first is cut in two by the faces along x
  for (const Labelling way : {Labelling::components, Labelling::watershed}) {
    EXPECT_EQ(label_cells(open, inside, {way, 1}).count, 3);
    EXPECT_EQ(label_cells(period, inside, {way, 1}).count, 2);
  }
}

TEST(LabelCells, APeriodMayBeginAnywhere) {
  EXPECT_TRUE(rc::check([] {
    const arenite::geometry::Cells cells{7, 6, 5, true};
    const auto inside = speckles(cells, 5);
    std::vector<std::uint8_t> moved(inside.size());
    const auto place = [&](std::size_t k) {
      const auto [x, y, z] = place_of(cells, k);
      return static_cast<std::size_t>((x + 3) % 7 + 7 * ((y + 4) % 6 + 6 * ((z + 2) % 5)));
    };
    for (std::size_t k = 0; k < inside.size(); ++k) moved[place(k)] = inside[k];
    const CellLabels here = label_cells(cells, inside, {}), there = label_cells(cells, moved, {});
    RC_ASSERT(here.count == there.count);
    std::vector<std::int32_t> number(static_cast<std::size_t>(here.count), -1);
    for (std::size_t k = 0; k < inside.size(); ++k) {
      RC_ASSERT((here.label[k] < 0) == (there.label[place(k)] < 0));
      if (here.label[k] < 0) continue;
      auto& own = number[static_cast<std::size_t>(here.label[k])];
      if (own < 0) own = there.label[place(k)];
      RC_ASSERT(own == there.label[place(k)]);
    }
  }));
}

}  // namespace
