#include "model/packing.hpp"

#include <gtest/gtest.h>

namespace {
using namespace arenite;

TEST(Packing, MeanForceIsOfPushingContactsBetweenGrains) {
  Contacts contacts;
  contacts.add(0, 1, {1, 0}, 4, 0, 1, 1);
  contacts.add(0, 1, {1, 0}, 2, 0, 1, 1);
  contacts.add(0, 1, {1, 0}, -100, 0, 1, 1);
  contacts.add(0, wall_partner(top), {0, -1}, 50, 0, 1, 0);
  EXPECT_EQ(mean_compressive_force(contacts), 3);
  EXPECT_EQ(mean_compressive_force(Contacts{}), 0);
}

}  // namespace
