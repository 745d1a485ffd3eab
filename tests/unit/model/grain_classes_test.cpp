#include "model/grain_classes.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace arenite {
namespace {

Packing of_two(std::vector<double> radius, std::vector<std::int32_t> material) {
  Packing p;
  p.materials = {{"A", 1000, 0, 0}, {"B", 1000, 0, 0}};
  p.grains.resize(radius.size());
  p.grains.radius = std::move(radius);
  p.grains.material = std::move(material);
  return p;
}

TEST(GrainClasses, OfTwoMaterialsThatWithTheLargerMeanRadiusIsTheLargeGrains) {
  const Packing p = of_two({1, 3, 9, 1}, {0, 1, 0, 1});  // means 5 and 2, though B has no grain as small as A's
  EXPECT_DOUBLE_EQ(mean_radius(p), 3.5);
  EXPECT_DOUBLE_EQ(mean_radius(p, 0), 5);
  const auto classes = classes_by_radius(p);
  ASSERT_TRUE(classes);
  EXPECT_EQ(classes->large, 0);
  EXPECT_EQ(classes_of(p, classes),
            (std::vector<GrainClass>{GrainClass::large, GrainClass::small, GrainClass::large, GrainClass::small}));
}

TEST(GrainClasses, AreNoneWhereRadiiOrMaterialsDoNotTellThem) {
  EXPECT_FALSE(classes_by_radius(of_two({2, 2}, {0, 1})));
  EXPECT_FALSE(classes_by_radius(of_two({2, 3}, {0, 0})));
  Packing three = of_two({1, 2}, {0, 1});
  three.materials.push_back({"C", 1000, 0, 0});
  EXPECT_FALSE(classes_by_radius(three));
  EXPECT_TRUE(classes_of(three, {}).empty());
  EXPECT_EQ(classes_of(three, ClassMaterials{2, 0}), (std::vector<GrainClass>{GrainClass::small, GrainClass::none}));
}

TEST(GrainClasses, GapAndWindowAreNodesOfPsGrid) {
  const double radius = 40 * 0.12e-3;  // 40 nodes to a large radius
  EXPECT_NEAR(sample_lengths(radius).gap, 3 * 0.12e-3, 1e-15);
  EXPECT_NEAR(sample_lengths(radius).window, 1024 * 0.12e-3, 1e-12);
}

}  // namespace
}  // namespace arenite
