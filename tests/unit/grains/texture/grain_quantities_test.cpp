#include "grains/texture/grain_quantities.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/error.hpp"

namespace arenite::texture {
namespace {

/// Three grains of which the first two touch.
Packing three(double shift = 0) {
  Packing packing;
  for (const Vec2 place : {Vec2{0.5 + shift, 1}, Vec2{1.5 + shift, 1}, Vec2{2.5 + shift, 3}}) {
    packing.grains.resize(packing.grains.size() + 1);
    packing.grains.position.back() = place;
    packing.grains.radius.back() = 0.5;
  }
  packing.domain.wall[right].position = packing.domain.wall[top].position = 4;
  packing.domain.thickness = 0.1;
  return packing;
}

TEST(GrainQuantities, HaveNamesOfTheirOwnAndSayWhatTheyAre) {
  std::set<std::string_view> names;
  for (const GrainQuantity& quantity : grain_quantities()) {
    EXPECT_TRUE(names.insert(quantity.name).second) << quantity.name;
    EXPECT_FALSE(quantity.label.empty() || quantity.symbol.empty()) << quantity.name;
  }
  EXPECT_EQ(values_of(three(), "size"), (std::vector<double>{1, 1, 1}));
  EXPECT_THROW(values_of(three(), "beauty"), InputError);
  EXPECT_THROW(values_of(three(), "displacement"), InputError);
}

TEST(GrainQuantities, MagnitudesAreNeverBelowZero) {
  Packing packing = three();
  packing.contacts.add(0, 1, {-1, 0}, -10, 3, 0.5, 0.5);
  packing.grains.velocity[0] = {-1, -2};
  EXPECT_LT(std::ranges::min(values_of(packing, "pressure")), 0);
  for (const GrainQuantity& quantity : grain_quantities()) {
    if (!quantity.is_magnitude || !quantity.of) continue;
    EXPECT_GE(std::ranges::min(quantity.of(packing)), 0) << quantity.name;
  }
}

TEST(GrainQuantities, MobilisationIsTheMeanOverContactsThatPush) {
  Packing packing = three();
  packing.contacts.add(0, 1, {-1, 0}, 10, 3, 0.5, 0.5);
  packing.contacts.add(1, 2, {0, -1}, 20, -2, 0.5, 0.5);
  packing.contacts.add(0, 2, {0, -1}, -5, 4, 0.5, 0.5);
  const auto ratio = mobilisations(packing), share = mobilisations(packing, 0.5);
  EXPECT_NEAR(ratio[0], 0.3, 1e-12);
  EXPECT_NEAR(ratio[1], 0.2, 1e-12);
  EXPECT_NEAR(ratio[2], 0.1, 1e-12);
  EXPECT_NEAR(share[1], 0.4, 1e-12);
  EXPECT_EQ(mobilisations(packing, 0.0), (std::vector<double>{0, 0, 0}));
}

TEST(GrainQuantities, GoOnAcrossPeriodicSides) {
  Packing first = three(), second = three(1.5), third = three(-1);
  for (Packing* packing : {&first, &second, &third}) packing->domain.periodic[0] = true;
  const auto ways = displacements({{&first}, {&second}, {&third}});
  EXPECT_NEAR(ways[1][0].x, 1.5, 1e-12);
  EXPECT_NEAR(ways[2][2].x, 3, 1e-12);
  EXPECT_NEAR(ways[2][2].y, 0, 1e-12);
}

TEST(GrainQuantities, RotationsCountFromTheFirstStateOfEachGrain) {
  Packing first = three(), second = three(), third = three();
  second.grains.angle = {0.5, -0.25, 0};
  third.grains.angle = {1, -0.5, 7};
  third.grains.id[2] = 99;  // put in since
  const auto turned = rotations({&first, &second, &third});
  EXPECT_EQ(turned[0], (std::vector<double>{0, 0, 0}));
  EXPECT_EQ(turned[2], (std::vector<double>{1, -0.5, 0}));
}

TEST(GrainQuantities, TheShearOfACellIsNoDisplacement) {
  Packing start = three(), end = three();
  for (Packing* packing : {&start, &end}) packing->domain.periodic = {true, true};
  end.domain.tilt = 1.2;
  for (Vec2& place : end.grains.position) place.x += 0.3 * (place.y - 2);
  const auto ways = displacements({{&start, 0}, {&end, 0.3}});
  for (const Vec2 way : ways[1]) EXPECT_NEAR(norm(way), 0, 1e-12);
}

}  // namespace
}  // namespace arenite::texture
