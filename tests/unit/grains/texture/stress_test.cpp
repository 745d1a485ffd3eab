#include "grains/texture/texture.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "support/numbers_of.hpp"
#include "unit/grains/texture/packings.hpp"

namespace arenite::texture {
namespace {

using std::numbers::pi;

double number(const Texture& t, const std::string& path) { return test::value_of(t.numbers, path); }

TEST(Stress, OfTwoDisksBetweenWallsIsTheirForceOverTheWall) {
  // Two disks in a row, squeezed by 100 N: sigma_xx = -F W/(W H L) = -F/(H L), nothing else.
  Packing p = test::empty_box(0.04, 0.02, 0.06);
  test::add_grain(p, {0.01, 0.01}, 0.01);
  test::add_grain(p, {0.03, 0.01}, 0.01);
  test::add_contact(p, 0, 1, 100);
  test::add_wall_contact(p, 0, left, 100);
  test::add_wall_contact(p, 1, right, 100);
  const Texture t = measure(p);
  EXPECT_NEAR(number(t, "stress/value/0/0"), -100 / (0.02 * 0.06), 1e-7);
  EXPECT_NEAR(number(t, "stress/value/1/1"), 0, 1e-9);
  EXPECT_NEAR(number(t, "stress_details/from_walls_and_weight/0/0"), number(t, "stress/value/0/0"), 1e-9);
  EXPECT_NEAR(number(t, "stress_details/axis_of_compression_deg"), 0, 1e-12);
  // A grain under two opposite forces: sigma_xx = -2 F R/(pi R^2 L), half of it hydrostatic.
  EXPECT_NEAR(t.per_grain.sigma[0].xx, -2 * 100 / (pi * 0.01 * 0.06), 1e-6);
  EXPECT_NEAR(t.per_grain.sigma_hyd[1], -100 / (pi * 0.01 * 0.06), 1e-6);
  EXPECT_NEAR(t.per_grain.sigma_norm[0], 1, 1e-14);
}

TEST(Stress, OfGrainsAsALaboratoryMeasuredItTakesThePlaceOfThatOfContacts) {
  Packing p = test::empty_box(0.04, 0.02, 0.06);
  test::add_grain(p, {0.01, 0.01}, 0.01);
  test::add_grain(p, {0.03, 0.01}, 0.01, 1);
  Options options;
  options.border = 0;
  options.grain_sigma_hyd = {-1e6, -3e6};
  const Texture without_contacts = measure(p, options);
  test::add_contact(p, 0, 1, 100);
  const Texture t = measure(p, options);
  EXPECT_EQ(t.per_grain.sigma_hyd, options.grain_sigma_hyd);
  EXPECT_DOUBLE_EQ(t.per_grain.sigma_norm[0], 0.5);
  EXPECT_DOUBLE_EQ(t.per_grain.sigma_norm[1], 1.5);
  EXPECT_EQ(without_contacts.per_grain.sigma_norm, t.per_grain.sigma_norm);
  // The stress of the sample as a whole stays that of its contacts.
  EXPECT_LT(number(t, "stress/value/0/0"), 0);
  EXPECT_GT(number(t, "stress/value/0/0"), -1e6);
}

TEST(Stress, ThatALaboratoryCouldNotMeasureIsLeftOutOfMeansAndDistributions) {
  Packing p = test::empty_box(0.06, 0.02, 0.06);
  for (const double x : {0.01, 0.03, 0.05}) test::add_grain(p, {x, 0.01}, 0.01);
  Options options;
  options.border = 0;
  options.grain_sigma_hyd = {-1e6, unknown, -3e6};
  const Texture t = measure(p, options);
  EXPECT_DOUBLE_EQ(t.per_grain.sigma_norm[0], 0.5);
  EXPECT_TRUE(std::isnan(t.per_grain.sigma_norm[1]));
  EXPECT_DOUBLE_EQ(t.per_grain.sigma_norm[2], 1.5);
  EXPECT_DOUBLE_EQ(number(t, "sigma_norm/mean_Pa"), -2e6);
  EXPECT_DOUBLE_EQ(number(t, "sigma_norm/P0"), 0.5);
}

TEST(Stress, OfAGrainUnderItsWeightIsBalancedByTheWallBelow) {
  Packing p = test::empty_box(1, 1, 0.5);
  test::add_grain(p, {0.5, 0.2}, 0.2);
  const double weight = 1000 * pi * 0.04 * 0.5 * 9.81;
  test::add_wall_contact(p, 0, bottom, weight);
  Options gravity;
  gravity.gravity = {0, -9.81};
  const Texture t = measure(p, gravity);
  EXPECT_NEAR(number(t, "stress/value/1/1"), -weight * 0.2 / 0.5, 1e-9);
  EXPECT_NEAR(number(t, "stress_details/from_walls_and_weight/1/1"), number(t, "stress/value/1/1"), 1e-9);
}

TEST(Stress, OfALatticeIsHydrostatic) {
  const Texture t = measure(test::square_lattice(8));
  EXPECT_NEAR(number(t, "stress/value/0/0"), -1, 1e-14);  // one contact of 1 N in every unit of height
  EXPECT_NEAR(number(t, "stress_details/deviator_Pa"), 0, 1e-14);
  EXPECT_NEAR(number(t, "stress_details/in_window/value/1/1"), -1, 1e-13);
  EXPECT_FALSE(t.numbers["stress"]["error"].is_known());  // one sample at rest cannot tell how others differ
  Options in_motion;
  in_motion.in_time = TimeScatter{{3, 1, 1, 4}, 0.5};
  EXPECT_EQ(number(measure(test::square_lattice(8), in_motion), "stress/error/1/1"), 4);
}

RC_GTEST_PROP(Stress, SummedOverGrainsEqualsThatOverContacts, ()) {
  const Texture t = measure(test::random_network(*rc::gen::inRange(0u, 100000u)));
  const double size = std::abs(number(t, "stress/value/0/0")) + std::abs(number(t, "stress/value/1/1"));
  for (const std::string component : {"0/0", "0/1", "1/0", "1/1"})
    RC_ASSERT(std::abs(number(t, "stress/value/" + component) -
                       number(t, "stress_details/sum_over_grains/" + component)) < 1e-12 * size);
}

TEST(Stress, WithoutThicknessOrBoxIsLeftOutWithAReason) {
  Packing p = test::random_network(5);
  p.domain.thickness = 0;
  Texture t = measure(p);
  EXPECT_FALSE(t.numbers.contains("stress"));
  EXPECT_TRUE(t.per_grain.sigma.empty());
  EXPECT_TRUE(t.numbers.contains("sigma_norm"));  // a length cancels
  EXPECT_TRUE(std::isnan(number(t, "sigma_norm/mean_Pa")));
  EXPECT_NE(t.notes.at(0).find("out-of-plane length"), std::string::npos);
  p.domain.wall = {};
  t = measure(p);
  EXPECT_TRUE(std::isnan(t.solid_fraction.value));
  EXPECT_NE(t.notes.at(0).find("box is not known"), std::string::npos);
}

TEST(Stress, SharesOfStrongAndWeakContactsAddUp) {
  // Vertical contacts carry 3 N, horizontal ones 1 N: strong are the vertical ones, three quarters of the mean stress;
  // the deviator is theirs less what the weak ones take back.
  Packing p = test::square_lattice(6);
  for (std::size_t c = 0; c < p.contacts.size(); ++c) p.contacts.fn[c] = std::abs(p.contacts.normal[c].y) > 0.5 ? 3 : 1;
  const Texture t = measure(p);
  EXPECT_NEAR(number(t, "stress_details/strong_share_of_pressure"), 0.75, 1e-14);
  EXPECT_NEAR(number(t, "stress_details/strong_share_of_deviator"), 3.0 / 2.0, 1e-13);
  EXPECT_NEAR(number(t, "stress_details/axis_of_compression_deg"), 90, 1e-10);
  EXPECT_NEAR(number(t, "fabric/load_axis_deg"), 90, 1e-10);
}

/// Without one of its corners the sample has no deviator at all, of which a share could be told.
TEST(Stress, TheStrongShareOfADeviatorThatIsInOneBlockHasAnErrorOfItsOwnSize) {
  Packing p = test::square_lattice(8);
  for (std::size_t c = 0; c < p.contacts.size(); ++c) {
    const Vec2 at = p.grains.position[static_cast<std::size_t>(p.contacts.i[c])];
    const bool corner = at.x < 0.3 * p.domain.extent(0) && at.y < 0.3 * p.domain.extent(1);
    p.contacts.fn[c] = corner && std::abs(p.contacts.normal[c].y) > 0.5 ? 3 : 1;
  }
  const Numbers told = measure(p).numbers["stress_details"]["strong_share_of_deviator"];
  EXPECT_NEAR(told["value"].get<double>(), 1.5, 1e-12);
  ASSERT_TRUE(told["error"].is_number());
  EXPECT_LT(told["error"].get<double>(), 0.5);
}

}  // namespace
}  // namespace arenite::texture
