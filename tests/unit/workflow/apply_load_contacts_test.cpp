#include <gtest/gtest.h>

#include <numeric>

#include "grains/texture/stress.hpp"
#include "grains/texture/texture.hpp"
#include "solid/grid/crop.hpp"
#include "support/page_sample.hpp"
#include "workflow/apply_load.hpp"

namespace arenite::workflow {
namespace {

/// The first forty grains of a packing under load, as a grid that shows them has them.
FieldResult sample_of(const Packing& packing) {
  std::vector<std::int32_t> labels(40);
  std::iota(labels.begin(), labels.end(), 0);
  FieldResult sample;
  sample.packing = grid::crop(packing, {}, labels, {0.01, 0.02}).packing;
  sample.map.grain_class.assign(labels.size(), GrainClass::none);
  return sample;
}

TEST(ContactStresses, OfATextureAreThoseThatTheSampleGives) {
  const test::PageSample made(120);
  const Packing& packing = made.stage.snapshots.back().packing;
  const FieldResult sample = sample_of(packing);
  const auto known = texture::grain_stresses(packing), measured = contact_stresses(sample),
             taken = contact_stresses(sample, packing, known);
  ASSERT_EQ(measured.size(), 40u);
  ASSERT_EQ(taken.size(), 40u);
  FieldResult turned = sample;
  turned.packing = grid::transposed(sample.packing);
  const auto of_turned = contact_stresses(turned);
  for (std::size_t g = 0; g < 40; ++g) {
    EXPECT_EQ(taken[g].xx, measured[g].xx);
    EXPECT_EQ(taken[g].xy, measured[g].xy);
    EXPECT_EQ(taken[g].yx, measured[g].yx);
    EXPECT_EQ(taken[g].yy, measured[g].yy);
    EXPECT_EQ(taken[g].xx, known[g].xx);
    EXPECT_EQ(of_turned[g].xx, measured[g].yy);
    EXPECT_EQ(of_turned[g].xy, measured[g].yx);
  }
}

TEST(ContactStresses, AreEmptyWithoutContactsOrThickness) {
  const test::PageSample made(120);
  Packing packing = made.stage.snapshots.back().packing;
  packing.domain.thickness = 0;
  EXPECT_TRUE(contact_stresses(sample_of(packing)).empty());
  EXPECT_TRUE(contact_stresses(FieldResult{}).empty());
}

}  // namespace
}  // namespace arenite::workflow
