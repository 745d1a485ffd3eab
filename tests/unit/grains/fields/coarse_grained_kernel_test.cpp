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

template <class Of> class Kernels : public testing::Test {
 protected:
  static constexpr int D = Of::dimension;
  using Place = Vec<D>;
  const KernelIn<D> kernel{Of::shape, width};

  /// As far along the second axis.
  static Place up(double r) {
    return by_axis<D>([&](int axis) { return axis == 1 ? r : 0; });
  }
  static Place within(RandomStream& random, double range) {
    return by_axis<D>([&](int) { return random.uniform(-range, range) * width; });
  }
};
template <int D, KernelShape of> struct KernelOf {
  static constexpr int dimension = D;
  static constexpr KernelShape shape = of;
};
using AllKernels = testing::Types<KernelOf<2, KernelShape::gaussian>, KernelOf<2, KernelShape::lucy>,
                                  KernelOf<3, KernelShape::gaussian>, KernelOf<3, KernelShape::lucy>>;
TYPED_TEST_SUITE(Kernels, AllKernels);

TYPED_TEST(Kernels, HaveIntegralOneAndTheirWidthAsDeviationAlongAnAxis) {
  // Simpson's rule errs by (reach/2000)^4 of the fourth derivative, a few times 1e-11 at most; beyond the reach lie
  // 2.1e-16 of the Gaussian, in space 1.4e-15.
  constexpr int D = TestFixture::D;
  const double around = D * std::numbers::pi * (D == 2 ? 1.0 : 4.0 / 3);  // of the unit circle, the unit sphere
  const auto moment = [&](int power) {
    return integral(0, this->kernel.reach(), 1000,
                    [&](double r) { return around * std::pow(r, power + D - 1) * this->kernel.value(this->up(r)); });
  };
  EXPECT_NEAR(moment(0), 1, 1e-10);
  EXPECT_NEAR(std::sqrt(moment(2) / D), width,
              1e-10);  // <r^2> = D <x^2>; what lies beyond weighs 72 w^2 times as much
  EXPECT_LT(this->kernel.value(this->up(1.0001 * this->kernel.reach())), 2.2e-16 * this->kernel.value({}));
}

TYPED_TEST(Kernels, SumOverTheCellsOfAGridToOne) {
  // The sum differs from the integral by the Fourier components of waves of a step h and less: none of a Gaussian, of
  // Lucy's function in the plane 2e-9 times 48 in each of four directions, and in space, where they fall as 630/(k c)^5
  // with k c = 82, in each of six 1.7e-7; the shorter waves askew add half of that.
  constexpr int D = TestFixture::D;
  const double half = 1.001 * this->kernel.reach(), step = width / 3.75;
  const auto cells = static_cast<std::int32_t>(2 * half / step) + 1;
  const auto all = [](auto value) { return by_axis<D>([&](int) { return value; }); };
  const GridIn<D> grid{all(-0.5 * cells * step), all(0.5 * cells * step), all(cells)};
  const auto middle = by_axis<D>([&](int axis) { return 0.1 * (axis + 1) * step; });
  double sum = 0;
  for_points_in(grid, grid.low, grid.high, [&](std::size_t, typename TestFixture::Place point) {
    sum += this->kernel.value(point - middle) * grid.cell_volume();
  });
  const bool smooth = this->kernel.reach() > 5 * width;
  EXPECT_NEAR(sum, 1, smooth ? 1e-13 : 1.6e-6);
  EXPECT_NEAR(grid.cell_volume(), std::pow(step, D), 1e-14);
}

TYPED_TEST(Kernels, HaveTheGradientOfTheirValue) {
  // Central differences of step h: h^2/6 times the third derivative (a few phi(0)/w^3), 1e-9, and rounding 1e-16/1e-5.
  constexpr int D = TestFixture::D;
  const double h = 1e-5 * width, scale = this->kernel.value({}) / width;
  RandomStream random(1, Purpose::test);
  for (int k = 0; k < 200; ++k) {
    const auto d = this->within(random, 3), g = this->kernel.gradient(d);
    for (int axis = 0; axis < D; ++axis) {
      const auto on = by_axis<D>([&](int other) { return other == axis ? h : 0; });
      EXPECT_NEAR(g[axis], (this->kernel.value(d + on) - this->kernel.value(d - on)) / (2 * h), 1e-8 * scale);
    }
  }
}

TYPED_TEST(Kernels, HaveTheMeanAlongALineThatQuadratureFinds) {
  // Simpson's rule over 4000 pieces of a line up to 25 w long. The Gaussian is smooth (h^4 = 1e-14 times the fourth
  // derivative); Lucy's third derivative jumps by 72/c^3 at its rim and |t|^3 at its middle: h^3 times that, 1e-9,
  // spread over the length.
  using Place = typename TestFixture::Place;
  using Line = typename KernelIn<TestFixture::D>::Line;
  const auto between = [&](Place from, Place to) { return this->kernel.line_mean(from, Line(to - from)); };
  RandomStream random(2, Purpose::test);
  for (int k = 0; k < 100; ++k) {
    const auto a = this->within(random, 7),
               b = k % 5 == 0 ? -1.5 * a : this->within(random, 7);  // every fifth goes through the centre
    const double mean = integral(0, 1, 4000, [&](double s) { return this->kernel.value(a + s * (b - a)); });
    EXPECT_NEAR(between(a, b), mean, 1e-9 * this->kernel.value({}));
    EXPECT_NEAR(between(a, b), between(b, a), 1e-14 * this->kernel.value({}));
  }
  const auto here = this->within(random, 0.4);
  EXPECT_DOUBLE_EQ(between(here, here), this->kernel.value(here));
  const auto beside = [](double y) { return Place{9 * width, y}; };
  EXPECT_NEAR(between(beside(-3), beside(5)), 0, 1e-16 * this->kernel.value({}));
}

TEST(Kernel, RefusesAWidthThatIsNone) {
  for (const double w : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    EXPECT_THROW(Kernel(KernelShape::lucy, w), InputError);
    EXPECT_THROW(KernelIn<3>(KernelShape::lucy, w), InputError);
  }
}

}  // namespace
}  // namespace arenite::fields
