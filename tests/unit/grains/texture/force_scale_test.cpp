#include "grains/texture/force_scale.hpp"

#include <gtest/gtest.h>

#include "statistics/estimate.hpp"

namespace arenite::texture {
namespace {

TEST(ForceScale, IsByTheMeasuredMeanOrElseByContactsThatPush) {
  Contacts contacts;
  for (const double force : {1.0, 3.0, -8.0, 20.0}) contacts.add(0, 1, {1, 0}, force, 0, 1, 1);
  EXPECT_DOUBLE_EQ(force_scale(contacts, 5).mean, 5);
  EXPECT_DOUBLE_EQ(force_scale(contacts, 5).tension, -0.005);
  EXPECT_DOUBLE_EQ(force_scale(contacts, statistics::unknown).mean, 8);
  EXPECT_DOUBLE_EQ(force_scale(contacts, statistics::unknown, {0, 0, 0, 1}).mean, 2);
  EXPECT_EQ(force_scale(Contacts{}, statistics::unknown).mean, 0);
  contacts.add(0, wall_partner(top), {0, -1}, 50, 0, 1, 0);
  EXPECT_DOUBLE_EQ(force_scale(contacts, statistics::unknown).mean, mean_compressive_force(contacts));
}

TEST(ForceScale, TellsTracesOfTensionBetweenSpheresFromPulls) {
  ContactsIn<3> contacts;
  for (const double force : {1.0, 3.0, -1e-3, -8.0}) contacts.add(0, 1, {1, 0, 0}, force, {}, 1, 1);
  const ForceScale scale = force_scale(contacts, statistics::unknown);
  EXPECT_DOUBLE_EQ(scale.mean, 2);
  EXPECT_GT(contacts.fn[2], scale.tension);
  EXPECT_LT(contacts.fn[3], scale.tension);
}

TEST(ForceScale, OfSeveralStatesIsTheMeanOfAllTheirContactsThatPush) {
  Contacts one, other;
  for (const double force : {1.0, 3.0, -8.0}) one.add(0, 1, {1, 0}, force, 0, 1, 1);
  other.add(0, 1, {1, 0}, 5, 0, 1, 1);
  EXPECT_DOUBLE_EQ(mean_push(std::vector<const Contacts*>{&one, &other}),
                   3);  // (1 + 3 + 5)/3, and not the mean of both means, 3.5
  EXPECT_EQ(mean_push(std::vector<const Contacts*>{}), 0);
}

}  // namespace
}  // namespace arenite::texture
