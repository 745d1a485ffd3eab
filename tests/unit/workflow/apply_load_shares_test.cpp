#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

#include "support/element_samples.hpp"
#include "workflow/apply_load.hpp"
#include "workflow/load_voxels.hpp"

namespace arenite::workflow {
namespace {

/// A load by elements with all that may follow it, of a sample of two materials.
recipe::Load load_of(bool moduli) {
  recipe::Load load;
  load.method = recipe::LoadMethod::elements;
  load.effective_stiffness = true;
  load.moduli = moduli;
  load.tolerance = 1e-4;
  return load;
}

template <class Map> void put_grain(Map& map, std::size_t cell) {
  map.phase[cell] = Phase::particle;
  map.grain[cell] = 0;
  map.grain_class = {GrainClass::none};
}

/// How far it is when each of its solves begins: where a watch hears of an iteration 0.
template <class Apply> std::vector<double> shares_at_begin(const Apply& apply) {
  std::vector<double> begins;
  double last = 0;
  EXPECT_TRUE(apply([&](const statics::Progress& p) {
                EXPECT_GE(p.share, last - 1e-12);
                EXPECT_LE(p.share, 1);
                last = p.share;
                if (p.iterations == 0) begins.push_back(p.share);
                return true;
              }).has_value());
  EXPECT_GT(last, 0.8);
  return begins;
}

void expect_equal_parts(const std::vector<double>& begins, std::size_t parts) {
  ASSERT_EQ(begins.size(), parts);
  for (std::size_t k = 0; k < parts; ++k)
    EXPECT_NEAR(begins[k], static_cast<double>(k) / static_cast<double>(parts), 1e-12);
}

TEST(SolveShares, OfThePlaneAreThoseOfItsLoadModuliAndStrains) {
  FieldResult sample;
  sample.map = test::solid(30, 30);
  for (int y = 8; y < 20; ++y)
    for (int x = 10; x < 22; ++x) put_grain(sample.map, sample.map.index(x, y));
  for (const bool moduli : {false, true})
    expect_equal_parts(
        shares_at_begin([&](const statics::Watch& watch) { return apply_load(load_of(moduli), sample, watch); }),
        moduli ? 7 : 4);
}

TEST(SolveShares, OfSpaceAreThoseOfItsLoadAndStrains) {
  VoxelMap map = test::solid(12, 12, 12);
  for (std::size_t k = 0; k < map.size(); ++k)
    if (k % 5 == 0) put_grain(map, k);
  expect_equal_parts(
      shares_at_begin([&](const statics::Watch& watch) { return apply_load(load_of(false), map, watch); }), 7);
}

}  // namespace
}  // namespace arenite::workflow
