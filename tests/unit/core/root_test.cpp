#include "core/root.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace {
using namespace arenite;

TEST(Root, OfACosineIsFoundToItsLastDigits) {
  const auto f = [](double x) { return std::cos(x); };
  EXPECT_DOUBLE_EQ(bracketed_root<double>(f, 1, f(1), 2, f(2)), std::numbers::pi / 2);
}

TEST(Minimum, LiesWithinOrAtAnEndOfItsInterval) {
  EXPECT_NEAR(minimum_between([](double x) { return std::cosh(x - 0.7); }, -3, 5), 0.7, 1e-7);
  EXPECT_NEAR(minimum_between([](double x) { return x; }, 0, 2), 0, 1e-7);
}

}  // namespace
