#include "grains/fields/coarse_grained.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "core/random.hpp"

namespace arenite::fields {
namespace {

constexpr double width = 0.7;

/// Composite Simpson's rule.
template <class F> double integral(double from, double to, int pieces, F&& f) {
  const double h = (to - from) / (2 * pieces);
  double sum = f(from) + f(to);
  for (int k = 1; k < 2 * pieces; ++k) sum += (k % 2 ? 4 : 2) * f(from + k * h);
  return sum * h / 3;
}

class Kernels : public testing::TestWithParam<KernelShape> {
 protected:
  const Kernel kernel{GetParam(), width};
};
INSTANTIATE_TEST_SUITE_P(Shapes, Kernels, testing::Values(KernelShape::gaussian, KernelShape::lucy),
                         [](const auto& of) { return of.param == KernelShape::gaussian ? "Gaussian" : "Lucy"; });

TEST_P(Kernels, HaveIntegralOneAndTheirWidthAsDeviationAlongAnAxis) {
  // Simpson's rule errs by (reach/2000)^4 of the fourth derivative, a few times 1e-11 at most; beyond the reach lie
  // 2.1e-16 of the Gaussian.
  const auto moment = [&](int power) {
    return integral(0, kernel.reach(), 1000, [&](double r) {
      return 2 * std::numbers::pi * std::pow(r, power + 1) * kernel.value({0, r});
    });
  };
  EXPECT_NEAR(moment(0), 1, 1e-10);
  EXPECT_NEAR(std::sqrt(moment(2) / 2), width,
              1e-10);  // <r^2> = <x^2> + <y^2>; what lies beyond weighs 72 w^2 times 2.1e-16
  EXPECT_LT(kernel.value({1.0001 * kernel.reach(), 0}), 2.2e-16 * kernel.value({}));
}

TEST_P(Kernels, HaveTheGradientOfTheirValue) {
  // Central differences of step h: h^2/6 times the third derivative (a few phi(0)/w^3), 1e-9, and rounding 1e-16/1e-5.
  const double h = 1e-5 * width, scale = kernel.value({}) / width;
  RandomStream random(1, Purpose::test);
  for (int k = 0; k < 200; ++k) {
    const Vec2 d{random.uniform(-3, 3) * width, random.uniform(-3, 3) * width}, g = kernel.gradient(d);
    EXPECT_NEAR(g.x, (kernel.value(d + Vec2{h, 0}) - kernel.value(d - Vec2{h, 0})) / (2 * h), 1e-8 * scale);
    EXPECT_NEAR(g.y, (kernel.value(d + Vec2{0, h}) - kernel.value(d - Vec2{0, h})) / (2 * h), 1e-8 * scale);
  }
}

TEST_P(Kernels, HaveTheMeanAlongALineThatQuadratureFinds) {
  // Simpson's rule over 4000 pieces of a line up to 20 w long. The Gaussian is smooth (h^4 = 1e-14 times the fourth
  // derivative); Lucy's third derivative jumps by 72/c^3 at its rim and |t|^3 at its middle: h^3 times that, 1e-9,
  // spread over the length.
  RandomStream random(2, Purpose::test);
  for (int k = 0; k < 100; ++k) {
    const auto place = [&] { return Vec2{random.uniform(-7, 7) * width, random.uniform(-7, 7) * width}; };
    const Vec2 a = place(), b = k % 5 == 0 ? -1.5 * a : place();  // every fifth goes through the centre
    const double mean = integral(0, 1, 4000, [&](double s) { return kernel.value(a + s * (b - a)); });
    EXPECT_NEAR(kernel.line_mean(a, b), mean, 1e-9 * kernel.value({}));
    EXPECT_NEAR(kernel.line_mean(a, b), kernel.line_mean(b, a), 1e-14 * kernel.value({}));
  }
  EXPECT_DOUBLE_EQ(kernel.line_mean({0.3, 0.1}, {0.3, 0.1}), kernel.value({0.3, 0.1}));
  EXPECT_NEAR(kernel.line_mean({9 * width, -3}, {9 * width, 5}), 0, 1e-16 * kernel.value({}));
}

TEST(Kernel, RefusesAWidthThatIsNone) {
  for (const double w : {0.0, -1.0, std::nan(""), HUGE_VAL}) EXPECT_THROW(Kernel(KernelShape::lucy, w), InputError);
}

}  // namespace
}  // namespace arenite::fields
