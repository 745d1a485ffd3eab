#include "statistics/clusters.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"

namespace {
using namespace arenite;

std::vector<double> normals(std::initializer_list<std::pair<double, int>> classes, double spread) {
  RandomStream random(3, Purpose::test);
  std::vector<double> values;
  for (const auto& [mean, count] : classes)
    for (int i = 0; i < count; ++i) values.push_back(mean + spread * random.normal());
  return values;
}

TEST(Clusters, FindsAsManyClassesAsStandApart) {
  EXPECT_EQ(statistics::cluster(normals({{0, 200}}, 1)).size(), 1u);
  EXPECT_EQ(statistics::cluster(normals({{0, 100}, {3, 100}}, 1)).size(), 1u);
  const auto two = statistics::cluster(normals({{9, 40}, {0, 100}}, 1));
  ASSERT_EQ(two.size(), 2u);
  EXPECT_EQ(two.members, (std::vector<std::size_t>{100, 40}));
  EXPECT_NEAR(two.mean[0], 0, 0.3);
  EXPECT_NEAR(two.mean[1], 9, 0.5);
  EXPECT_EQ(two.of.front(), 1);
  EXPECT_EQ(two.of.back(), 0);
  EXPECT_EQ(statistics::cluster(normals({{0, 50}, {10, 50}, {20, 50}}, 1)).size(), 3u);
}

TEST(Clusters, FindsOneClassInUniformNumbers) {
  RandomStream random(5, Purpose::test);
  std::vector<double> values;
  for (int i = 0; i < 300; ++i) values.push_back(random.uniform());
  EXPECT_EQ(statistics::cluster(values).size(), 1u);
}

TEST(Clusters, TakesNothingAndAlikeNumbers) {
  EXPECT_EQ(statistics::cluster({}).size(), 0u);
  EXPECT_EQ(statistics::cluster({2, 2, 2}).size(), 1u);
  EXPECT_EQ(statistics::cluster({1, 2}, {.most = 2, .separation = 0, .least_members = 1}).size(), 2u);
}

}  // namespace
