#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/rim.hpp"
#include "shapes.hpp"

namespace arenite::verification {
namespace {

using dem::Engine;

/// What a stage hands to the next: an engine built from a packing with its contacts goes on with the friction that it
/// found.
TEST(Polygons, TangentialForcesOfAPackingAreTakenUp) {
  const double slope = 0.2;
  Packing p = box(2, 1);
  add(p, Polygon{4, {0.1, 0}});
  const double half = half_side(p, 0), r = rounding(p, 0);
  p.grains.position[0].y = half + r;
  add(p, Polygon{4, {0.1, 3 * half + 3 * r}});
  dem::ContactParameters law;
  law.friction = 0.5;
  law.restitution = 0.2;
  Engine first(p, law, {});
  set_gravity(first, gravity * Vec2{std::sin(slope), -std::cos(slope)});
  while (time_of(first) < 0.2) first.advance(100);
  const Packing then = packing_of(first), now = packing_of(Engine(then, law, {}));
  ASSERT_EQ(then.contacts.size(), 6U);
  ASSERT_EQ(now.contacts.size(), 6U);
  double largest = 0;
  for (std::size_t c = 0; c < then.contacts.size(); ++c) {
    largest = std::max(largest, std::abs(then.contacts.ft[c]));
    EXPECT_NEAR(now.contacts.ft[c], then.contacts.ft[c], 1e-4 * mass(p, 0) * gravity);
  }
  EXPECT_GT(largest, 0.05 * mass(p, 0) * gravity);
}

Packing crowd(bool periodic, std::uint64_t seed = 1, int side = 6) {
  const double pitch = 0.0172;
  Packing p = periodic ? periodic_cell(side * pitch, side * pitch) : box(side * pitch, side * pitch);
  RandomStream random(seed, Purpose::test);
  for (int q = 0; q < side * side; ++q)
    add(p, Polygon{3 + q % 4,
                   {(q % side + 0.5) * pitch, (q / side + 0.5) * pitch},
                   random.uniform(0, 6),
                   {random.uniform(-1, 1), random.uniform(-1, 1)},
                   random.uniform(-50, 50),
                   5.5e-3,
                   q % 2 == 0 ? 1.0 : 1.5,
                   0.15});
  return p;
}

Packing squeezed_crowd(bool periodic, int side = 6) { return pressed_together(crowd(periodic, 1, side), side); }

TEST(Polygons, EnergyIsClosedToAMillionthOfTheWorkAtAStepOfTcOver500) { expect_energy_is_closed(squeezed_crowd); }

TEST(Polygons, SameBitsOnOneAndTwoThreadsAndForEveryKernel) { expect_same_bits(squeezed_crowd(true, 48)); }

TEST(Polygons, AStateThatIsSavedAndRestoredGoesOnWithTheSameBits) {
  const Packing p = squeezed_crowd(true);
  Engine whole(p, {}, {});
  set_drives(whole, {moved(0.5), moved(-0.5), moved(0.5), moved(-0.5)});
  set_shear_rate(whole, 20);
  whole.advance(511);
  const auto bytes = save_sample(whole);
  whole.advance(1000);
  ASSERT_GT(packing_of(whole).contacts.size(), 60U);
  EXPECT_GT(whole.builds, 3);
  Engine resumed(p, {}, {});
  restore_sample(resumed, bytes);
  resumed.advance(1000);
  EXPECT_EQ(state_hash(resumed), state_hash(whole));
}

}  // namespace
}  // namespace arenite::verification
