#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

#include "model/packing.hpp"

namespace arenite::dem {

/// A grain rests on both sides of an upright groove of this half angle, rad, alike, and the groove bears its weight, N.
template <int D> void expect_rest_in_groove(const PackingIn<D>& now, double half, double weight) {
  ASSERT_EQ(now.contacts.size(), 2U);
  for (std::size_t c = 0; c < 2; ++c) {
    EXPECT_TRUE(now.contacts.is_boundary(c));
    EXPECT_EQ(now.domain.boundary_of(now.contacts.element(c)), 0);
    EXPECT_NEAR(now.contacts.fn[c], weight / (2 * std::sin(half)), 1e-8 * weight);
  }
  EXPECT_NEAR(now.domain.boundaries[0].force.y, -weight, 1e-8 * weight);
  EXPECT_NEAR(now.domain.boundaries[0].force.x, 0, 1e-8 * weight);
}

}  // namespace arenite::dem
