#include "solid/grid/crop.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "grains/texture/texture.hpp"
#include "support/numbers_of.hpp"
#include "support/page_sample.hpp"

namespace arenite::grid {
namespace {

/// Disks pressed together, with contact forces in equilibrium.
Packing pressed() {
  static const test::PageSample sample(120);
  return sample.stage.snapshots.back().packing;
}

TEST(TransposedPacking, StressIsTransposedWithIt) {
  Packing packing = pressed();
  packing.contacts.ft[3] *= 5;  // so that xy and yx differ from zero and from each other
  const Tensor2 before = test::tensor_of(texture::measure(packing).numbers, "stress"),
                after = test::tensor_of(texture::measure(transposed(packing)).numbers, "stress");
  const double scale = std::abs(before.xx) + std::abs(before.yy);
  EXPECT_NEAR(after.xx, before.yy, 1e-12 * scale);
  EXPECT_NEAR(after.yy, before.xx, 1e-12 * scale);
  EXPECT_NEAR(after.xy, before.yx, 1e-12 * scale);
  EXPECT_NEAR(after.yx, before.xy, 1e-12 * scale);
  EXPECT_GT(std::abs(before.xx - before.yy), 1e-6 * scale);
}

TEST(TransposedPacking, TwiceIsTheSame) {
  const Packing packing = pressed(), twice = transposed(transposed(packing));
  EXPECT_EQ(twice.grains.position, packing.grains.position);
  EXPECT_EQ(twice.contacts.j, packing.contacts.j);
  EXPECT_EQ(twice.contacts.ft, packing.contacts.ft);
  for (std::size_t side = 0; side < 4; ++side)
    EXPECT_EQ(twice.domain.wall[side].position, packing.domain.wall[side].position);
}

TEST(CroppedPacking, LabelsComeFirstAndAllTheirContactsStay) {
  const Packing packing = pressed();
  const std::vector<std::int32_t> labels{17, 4, 60};
  Cement cement;
  cement.bridges = {{4, 60, 1e-3, 2e-3}, {4, 100, 3e-3, 4e-3}, {101, 102, 5e-3, 6e-3}};
  const Vec2 corner{0.01, 0.02};
  const CroppedPacking cropped = crop(packing, cement, labels, corner);
  for (std::size_t l = 0; l < labels.size(); ++l) {
    const auto g = static_cast<std::size_t>(labels[l]);
    EXPECT_EQ(cropped.packing.grains.id[l], packing.grains.id[g]);
    EXPECT_DOUBLE_EQ(cropped.packing.grains.position[l].x, packing.grains.position[g].x - corner.x);
    EXPECT_DOUBLE_EQ(cropped.packing.grains.position[l].y, packing.grains.position[g].y - corner.y);
  }
  const auto contacts_of = [](const Packing& p, std::int64_t id) {
    std::multiset<double> forces;
    for (std::size_t c = 0; c < p.contacts.size(); ++c)
      for (const std::int32_t end : {p.contacts.i[c], p.contacts.j[c]})
        if (end >= 0 && p.grains.id[static_cast<std::size_t>(end)] == id) forces.insert(p.contacts.fn[c]);
    return forces;
  };
  for (const std::int32_t label : labels) {
    const std::int64_t id = packing.grains.id[static_cast<std::size_t>(label)];
    EXPECT_EQ(contacts_of(cropped.packing, id), contacts_of(packing, id));
  }
  ASSERT_EQ(cropped.cement.bridges.size(), 2u);
  EXPECT_EQ(cropped.cement.bridges[0].i, 1);
  EXPECT_EQ(cropped.cement.bridges[0].j, 2);
  EXPECT_EQ(cropped.packing.grains.id[static_cast<std::size_t>(cropped.cement.bridges[1].j)], packing.grains.id[100]);
  EXPECT_DOUBLE_EQ(cropped.packing.domain.wall[left].position, packing.domain.wall[left].position - corner.x);
  EXPECT_DOUBLE_EQ(cropped.packing.domain.wall[top].position, packing.domain.wall[top].position - corner.y);
}

}  // namespace
}  // namespace arenite::grid
