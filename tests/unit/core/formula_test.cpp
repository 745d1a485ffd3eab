#include "core/formula.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <stdexcept>
#include <vector>

namespace arenite {
namespace {

std::vector<double> of(const char* formula) {
  return evaluated(formula, 2, [](std::string_view name) {
    return name == "a" ? std::vector<double>{3, 1} : name == "b" ? std::vector<double>{4, -1} : std::vector<double>{};
  });
}

TEST(Formula, OperatorsStandBehindWhatTheyActOn) {
  EXPECT_EQ(of("a b + 2 /"), (std::vector<double>{3.5, 0}));
  EXPECT_EQ(of("a b a - *"), (std::vector<double>{3, -2}));
  EXPECT_EQ(of("a b hypot")[0], 5);
  EXPECT_DOUBLE_EQ(of("b a atan2")[1], -std::numbers::pi / 4);
  EXPECT_DOUBLE_EQ(of("pi 1.5 *")[1], 1.5 * std::numbers::pi);
}

TEST(Formula, WhatIsNoneIsRefused) {
  for (const char* wrong : {"", "a b", "a +", "c 2 *"}) EXPECT_THROW(of(wrong), std::logic_error) << wrong;
}

}  // namespace
}  // namespace arenite
