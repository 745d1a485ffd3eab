#include "grains/fields/friction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "core/error.hpp"
#include "unit/grains/texture/packings.hpp"

namespace arenite::fields {
namespace {

/// Three disks in a row on the floor: contacts with F_t/F_n of 0.3 and 0.15, one at the floor with 0.2, one that pulls.
Packing row() {
  Packing p = test::empty_box(3, 1);
  for (int k = 0; k < 3; ++k) test::add_grain(p, {k + 0.5, 0.5}, 0.5);
  test::add_contact(p, 0, 1, 10, -3);
  test::add_contact(p, 1, 2, 20, 3);
  test::add_wall_contact(p, 1, bottom, 5, 1);
  test::add_wall_contact(p, 2, right, -1, 1);
  return p;
}

TEST(Friction, IsMobilisedAgainstTheCoefficientOfItsPair) {
  const FrictionState s = measure_friction(row(), {0.3, 0.2, 1e-3, 4});
  EXPECT_EQ(s.contacts, 3u);
  EXPECT_NEAR(s.mobilisation[0], 1, 1e-15);
  EXPECT_NEAR(s.mobilisation[1], 0.5, 1e-15);
  EXPECT_NEAR(s.mobilisation[2], 1, 1e-15);
  EXPECT_TRUE(std::isnan(s.mobilisation[3]));  // Coulomb's cap of a contact that pulls is that of its adhesion
  EXPECT_NEAR(s.mean.value, 2.5 / 3, 1e-15);
  EXPECT_NEAR(s.sliding.value, 2.0 / 3, 1e-15);
  EXPECT_NEAR(s.sliding_grains.value, 0.5, 1e-15);
  EXPECT_EQ(s.density.x, (std::vector<double>{0.125, 0.375, 0.625, 0.875}));
  EXPECT_NEAR(s.density.y[2], 4.0 / 3, 1e-15);
  EXPECT_NEAR(s.density.y[3], 8.0 / 3, 1e-15);
  EXPECT_NEAR(std::accumulate(s.density.y.begin(), s.density.y.end(), 0.0) / 4, 1, 1e-15);
  EXPECT_NEAR(s.density.error[3], 4 * std::sqrt(2) / 3, 1e-15);
  EXPECT_TRUE(std::isnan(s.total_power));
}

TEST(Friction, OfWallsIsThatOfGrainsUnlessGivenAndMayBeNone) {
  EXPECT_NEAR(measure_friction(row(), {0.4, {}, 1e-3, 4}).mobilisation[2], 0.5, 1e-15);
  const FrictionState smooth = measure_friction(row(), {0.3, 0.0, 1e-3, 4});
  EXPECT_EQ(smooth.contacts, 2u);
  EXPECT_TRUE(std::isnan(smooth.mobilisation[2]));
  const FrictionState none = measure_friction(row(), {0, {}, 1e-3, 4});
  EXPECT_EQ(none.contacts, 0u);
  EXPECT_TRUE(std::isnan(none.mean.value));
  EXPECT_TRUE(none.density.y.empty());
}

TEST(Friction, TakesPowerFromWhatSlidesAgainstItsForce) {
  Packing p = row();
  p.contacts.sliding_velocity = {0.02, 0.01, NAN, -0.5};
  const FrictionState s = measure_friction(p, {0.3, {}, 1e-3, 4});
  EXPECT_DOUBLE_EQ(s.power[0], 0.06);
  EXPECT_DOUBLE_EQ(s.power[1], -0.03);  // a spring that gives back
  EXPECT_TRUE(std::isnan(s.power[2]));
  EXPECT_EQ(s.known_powers, 3u);
  EXPECT_NEAR(s.total_power, 0.06 - 0.03 + 0.5, 1e-15);
  EXPECT_DOUBLE_EQ(s.sliding_power, 0.06);
}

TEST(Friction, ErrorsAreThoseOfTheScatterBetweenBlocks) {
  // Mobilisation uniform in [0, 1) on 2 x 30 x 30 contacts: 1/2 with a standard error of sqrt(1/12/1800), known from 36
  // blocks to 12 %.
  Packing p = test::square_lattice(30);
  RandomStream random(5, Purpose::test);
  for (double& t : p.contacts.ft) t = 0.5 * random.uniform(-1, 1);
  const FrictionState s = measure_friction(p, {0.5, {}, 0.1, 20});
  const double error = std::sqrt(1.0 / 12 / 1800);
  EXPECT_NEAR(s.mean.value, 0.5, 3 * error);
  EXPECT_NEAR(s.mean.error, error, 0.36 * error);
  EXPECT_NEAR(s.sliding.value, 0.1, 3 * std::sqrt(0.09 / 1800));
  for (std::size_t k = 0; k < 20; ++k) EXPECT_NEAR(s.density.y[k], 1, 5 * s.density.error[k]);
}

TEST(Friction, RefusesWhatIsNoCoefficient) {
  EXPECT_THROW(measure_friction(row(), {-0.1, {}, 1e-3, 4}), InputError);
  EXPECT_THROW(measure_friction(row(), {0.3, -0.1, 1e-3, 4}), InputError);
  EXPECT_THROW(measure_friction(row(), {0.3, {}, 1, 4}), InputError);
  EXPECT_THROW(measure_friction(row(), {0.3, {}, 1e-3, 0}), InputError);
}

}  // namespace
}  // namespace arenite::fields
