#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "grains/texture/texture.hpp"
#include "support.hpp"
#include "support/numbers_of.hpp"

namespace arenite::verification {
namespace {

/// 8 x 8 disks of two sizes and materials with friction, pressed from below under their weight until they rest.
Packing pressed_sample() {
  const double cell = 13e-3;
  Packing p = box(8 * cell, 8 * cell);
  RandomStream random(5, Purpose::test);
  for (int r = 0; r < 8; ++r)
    for (int c = 0; c < 8; ++c) {
      const bool small = random.below(2) == 1;
      const double radius = small ? 5.25e-3 : 6.2e-3;
      add(p, {{(c + 0.5) * cell + random.uniform(-2e-4, 2e-4), (r + 0.5) * cell}, radius, small ? hdpe : pom});
    }
  dem::ContactParameters law;
  law.friction_law = dem::CundallStrack{};
  law.restitution = 0.1;
  law.attractive_dashpot = true;
  dem::Engine engine(p, law, {});
  set_gravity(engine, {0, -gravity});
  set_drag(engine, 30);
  set_drives(engine, {dem::WallDrive{}, dem::WallDrive{}, pressed(5000), dem::WallDrive{}});
  EXPECT_TRUE(settle(engine, 1e-6, 1e-8, 800))
      << equilibrium_of(engine).unbalanced_ratio << " " << equilibrium_of(engine).kinetic_ratio;
  return packing_of(engine);
}

using test::tensor_of;
using test::value_of;

double largest_difference(const Tensor2& a, const Tensor2& b) {
  return std::max({std::abs(a.xx - b.xx), std::abs(a.xy - b.xy), std::abs(a.yx - b.yx), std::abs(a.yy - b.yy)});
}

TEST(StressBalance, OfContactsGrainsAndWallsAgreeAtRest) {
  texture::Options options;
  options.gravity = {0, -gravity};
  const Numbers j = texture::measure(pressed_sample(), options).numbers;
  const Tensor2 whole = tensor_of(j, "stress");
  const double size = value_of(j, "stress_details/pressure_Pa");
  EXPECT_GT(size, 1e5);
  EXPECT_LT(largest_difference(whole, tensor_of(j, "stress_details/sum_over_grains")), 1e-12 * size);
  EXPECT_LT(largest_difference(whole, tensor_of(j, "stress_details/from_walls_and_weight")),
            1e-5 * size);                        // the residual, times the distance across
  EXPECT_NEAR(whole.xy, whole.yx, 1e-5 * size);  // no torque is left on any grain
}

TEST(StressBalance, NeedsTheWeight) {
  const Numbers j = texture::measure(pressed_sample()).numbers;
  EXPECT_GT(largest_difference(tensor_of(j, "stress"), tensor_of(j, "stress_details/from_walls_and_weight")),
            1e-3 * value_of(j, "stress_details/pressure_Pa"));
}

}  // namespace
}  // namespace arenite::verification
