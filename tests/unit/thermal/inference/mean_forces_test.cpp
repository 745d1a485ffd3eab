#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "support/pressed_crystal.hpp"
#include "thermal/inference/balance.hpp"
#include "thermal/inference/contact_forces.hpp"
#include "thermal/inference/mean_forces.hpp"

namespace arenite::inference {
namespace {

using test::pressed_crystal, test::relative_error, test::without_forces;

constexpr double disk_radius = 8.2e-3;

/// sigma_hyd of every grain by the sum rule.
std::vector<double> mean_stresses(const Packing& p) {
  std::vector<double> sigma(p.grains.size());
  for (std::size_t c = 0; c < p.contacts.size(); ++c) {
    sigma[static_cast<std::size_t>(p.contacts.i[c])] -= p.contacts.fn[c];
    if (!p.contacts.is_wall(c)) sigma[static_cast<std::size_t>(p.contacts.j[c])] -= p.contacts.fn[c];
  }
  for (std::size_t g = 0; g < sigma.size(); ++g)
    sigma[g] /= 2 * std::numbers::pi * p.grains.radius[g] * p.domain.thickness;
  return sigma;
}

/// Columns of fn and ft; rows: means, balance.
int dense_null_space(const Packing& p) {
  std::vector<Vec2> centre;
  for (std::size_t g = 0; g < p.grains.size(); ++g) centre.push_back(p.grains.position[g]);
  const auto touches = touches_of_grains(p, centre);
  const auto columns = static_cast<Eigen::Index>(2 * p.contacts.size());
  Eigen::MatrixXd m = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(4 * centre.size()), columns);
  Eigen::Index row = 0;
  for (const auto& of_grain : touches) {
    for (const Touch& t : of_grain) {
      const Vec2 tangent = perpendicular(t.normal);
      m(row, 2 * t.contact) = 1;
      m(row + 1, 2 * t.contact) = t.normal.x, m(row + 1, 2 * t.contact + 1) = tangent.x;
      m(row + 2, 2 * t.contact) = t.normal.y, m(row + 2, 2 * t.contact + 1) = tangent.y;
      m(row + 3, 2 * t.contact + 1) = 1;
    }
    row += 4;
  }
  Eigen::FullPivLU<Eigen::MatrixXd> lu(m);
  lu.setThreshold(1e-7);
  return static_cast<int>(columns - lu.rank());
}

/// One disk between four walls: eight components of force, three of balance, one mean.
TEST(MeanForces, NullSpaceOfOneDiskIsFour) {
  Packing p = pressed_crystal(1, 1, disk_radius, 1);
  p.contacts.add(0, wall_partner(right), inward_normal(right), 0, 0, disk_radius, 0);
  ASSERT_EQ(p.contacts.size(), 4u);
  const InferredForces f = infer_from_means({without_forces(p), {}, {}}, {-1e6}, {1e3}, {});
  EXPECT_EQ(f.null_space, 4);
  // The smallest energy shares the sum evenly, without friction.
  const double sum = 2 * std::numbers::pi * disk_radius * 0.06 * 1e6;
  for (std::size_t c = 0; c < 4; ++c) {
    EXPECT_NEAR(f.contacts.fn[c] / sum, 0.25, 1e-3);
    EXPECT_NEAR(f.contacts.ft[c] / sum, 0, 1e-9);
  }
}

RC_GTEST_PROP(MeanForces, NullSpaceIsThatOfTheDenseMatrix, ()) {
  const Packing p = pressed_crystal(*rc::gen::inRange(1, 5), *rc::gen::inRange(1, 5), disk_radius,
                                    *rc::gen::inRange<std::uint64_t>(1, 100));
  const std::vector<double> sigma = mean_stresses(p), error(sigma.size(), 1e3);
  RC_ASSERT(infer_from_means({without_forces(p), {}, {}}, sigma, error, {}).null_space == dense_null_space(p));
}

/// What comes out has the means that went in and is in balance; hence twice the means, twice the forces.
TEST(MeanForces, KeepMeansAndBalance) {
  const Packing p = pressed_crystal(6, 5, disk_radius, 2);
  std::vector<double> sigma = mean_stresses(p), error(sigma.size(), 10);
  ForceOptions options;
  options.prior = 1, options.balance_error = 1e-4;
  const InferredForces f = infer_from_means({without_forces(p), {}, {}}, sigma, error, options);
  EXPECT_LT(relative_error(mean_stresses({p.materials, p.domain, p.grains, f.contacts, {}, {}}), sigma), 1e-3);
  for (const double imbalance : f.imbalance) EXPECT_LT(imbalance, 0.5);
  for (double& s : sigma) s *= 2;
  for (double& e : error) e *= 2;
  const InferredForces twice = infer_from_means({without_forces(p), {}, {}}, sigma, error, options);
  for (std::size_t c = 0; c < f.contacts.size(); ++c) EXPECT_NEAR(twice.contacts.fn[c], 2 * f.contacts.fn[c], 1e-6);
}

TEST(MeanForces, BadInputIsToldInASentence) {
  const Packing p = without_forces(pressed_crystal(2, 2, disk_radius, 1));
  const std::vector<double> sigma(4, -1e6), none(4, 0.0);
  EXPECT_THROW(infer_from_means({p, {}, {}}, sigma, none, {}), InputError);
  EXPECT_THROW(infer_from_means({p, {}, {}}, {1, 2}, {1, 1}, {}), InputError);
  EXPECT_THROW(infer_from_means({p, {}, {{5, 1, 1}}}, sigma, sigma, {}), InputError);
  Packing bare = p;
  bare.contacts = {};
  EXPECT_THROW(infer_from_means({bare, {}, {}}, sigma, sigma, {}), InputError);
}

}  // namespace
}  // namespace arenite::inference
