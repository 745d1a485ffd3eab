#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "grains/packing/free_space.hpp"

namespace arenite::packing {
namespace {

using std::numbers::pi;

TEST(FreeSpace, PlacesBesideADiskLeaveOutWhatItsNeighbourForbids) {
  // Equal disks that touch: a third keeps off the neighbour on 120 degrees, so it is at 60 degrees or more from it.
  FreeSpace<2> space({{}, {20, 20}}, 0);
  space.open_store(2);
  const Ball<2> disk{{10, 10}, 1};
  space.add(disk);
  space.add({{12, 10}, 1});
  RandomStream random(1, Purpose::test);
  double nearest = pi;
  for (int k = 0; k < 4000; ++k) {
    const auto place = space.free_place_beside(disk, 1, random);
    ASSERT_TRUE(place);
    EXPECT_NEAR(norm(*place - disk.centre), 2, 1e-9);
    nearest = std::min(nearest, std::abs(std::atan2(place->y - 10, place->x - 10)));
  }
  EXPECT_GE(nearest, pi / 3 - 1e-9);
  EXPECT_LT(nearest, pi / 3 + 0.01);
}

TEST(FreeSpace, SevenDisksLeaveNoPlaceRoundTheOneInTheirMiddleAndOneFewerDoes) {
  RandomStream random(1, Purpose::test);
  for (const int around : {5, 6}) {
    FreeSpace<2> space({{}, {20, 20}}, 0);
    space.open_store(2);
    const Ball<2> disk{{10, 10}, 1};
    space.add(disk);
    for (int k = 0; k < around; ++k)
      space.add({disk.centre + 2.0001 * Vec2{std::cos(k * pi / 3), std::sin(k * pi / 3)}, 1});
    EXPECT_EQ(space.free_place_beside(disk, 1, random).has_value(), around == 5);
  }
}

TEST(FreeSpace, AGapAndWallsTakeRoomAndAPeriodicSideGivesIt) {
  FreeSpace<2> walls({{}, {10, 10}}, 0), periodic({{}, {10, 10}, {true, true}}, 0);
  EXPECT_FALSE(walls.fits({{0.9, 5}, 1}));
  EXPECT_TRUE(walls.fits({{1.0, 5}, 1}));
  EXPECT_TRUE(periodic.fits({{0.1, 5}, 1}));
  periodic.open_store(2);
  periodic.add({{9.5, 5}, 1});
  EXPECT_FALSE(periodic.fits({{1.4, 5}, 1}));
  EXPECT_TRUE(periodic.fits({{1.6, 5}, 1}));
  periodic.set_gap(0.2);
  EXPECT_FALSE(periodic.fits({{1.6, 5}, 1}));
  FreeSpace<2> narrow({{}, {3, 3}, {true, true}}, 0);
  EXPECT_FALSE(narrow.fits({{1, 1}, 1.6}));  // it would overlap its own image
}

RC_GTEST_PROP(FreeSpace, HasAPlaceBesideADiskExactlyWhereSomeAngleFits, ()) {
  RandomStream random(*rc::gen::arbitrary<std::uint64_t>(), Purpose::test);
  const geometry::Box<2> box{{-1, 2},
                             {*rc::gen::element(3.0, 8.0), *rc::gen::element(3.0, 8.0)},
                             {*rc::gen::arbitrary<bool>(), *rc::gen::arbitrary<bool>()}};
  FreeSpace<2> space(box, *rc::gen::element(0.0, 0.3));
  std::vector<Ball<2>> disks;
  for (const double size : {1.0, 0.3}) {
    space.open_store(size);
    for (int k = 0; k < 60; ++k) {
      const double r = random.uniform(0.3, 0.6) * size;
      const Ball<2> disk{{random.uniform(box.corner.x, box.end().x), random.uniform(box.corner.y, box.end().y)}, r};
      if (!space.fits(disk)) continue;
      space.add(disk);
      disks.push_back(disk);
    }
  }
  RC_PRE(!disks.empty());
  const Ball<2>& disk = disks[random.below(disks.size())];
  const double radius = random.uniform(0.02, 0.4);
  int fitting = 0;
  for (int k = 0; k < 3600; ++k) {
    const double angle = k * pi / 1800;
    fitting += space.fits({space.place_beside(disk, radius, {std::cos(angle), std::sin(angle)}), radius});
  }
  const auto place = space.free_place_beside(disk, radius, random);
  RC_CLASSIFY(!place.has_value(), "full");
  if (fitting > 0) RC_ASSERT(place.has_value());
  if (place) {
    RC_ASSERT(space.fits({*place, radius}));
    RC_ASSERT(place->x >= box.corner.x - 1e-12 && place->x <= box.end().x + 1e-12);
  }
}

}  // namespace
}  // namespace arenite::packing
