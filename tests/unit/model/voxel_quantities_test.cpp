#include "model/voxel_quantities.hpp"

#include <gtest/gtest.h>

#include <string_view>
#include <vector>

namespace arenite {
namespace {

std::vector<std::string_view> drawn_under(const char* loading) {
  VoxelResult sample;
  sample.numbers = Numbers{{"load", {{"loading", loading}}}};
  std::vector<std::string_view> names;
  for (const VoxelQuantity* q : quantities_drawn(sample)) names.push_back(q->name);
  return names;
}

TEST(VoxelQuantities, TheComponentThatALoadActsByIsDrawnFirstAndTheOtherNotAtAll) {
  EXPECT_EQ(drawn_under("tension"), (std::vector<std::string_view>{"sigma_zz", "sigma_hyd", "sigma_mises"}));
  EXPECT_EQ(drawn_under("compression"), drawn_under("tension"));
  EXPECT_EQ(drawn_under("shear"), (std::vector<std::string_view>{"sigma_xz", "sigma_hyd", "sigma_mises"}));
}

}  // namespace
}  // namespace arenite
