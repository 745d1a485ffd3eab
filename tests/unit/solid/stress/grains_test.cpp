#include "solid/stress/stress.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "core/random.hpp"
#include "samples.hpp"
#include "solid/stress/grains.hpp"
#include "support/numbers_of.hpp"

namespace arenite::stress {
namespace {

using test::error_of;
using test::value_of;

StressField linear(const PhaseMap& map) {
  StressField field = no_stress(map);
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x) {
      const std::size_t i = map.index(x, y);
      const double a = (x + 0.5) * map.dx, b = (y + 0.5) * map.dx;
      field.xx[i] = 3 + 20 * a - 5 * b;
      field.yy[i] = 5 + 7 * a + 11 * b;
      field.xy[i] = 1 - 2 * a + 4 * b;
    }
  return field;
}

TEST(GrainStress, OfALinearFieldIsItsValueAtTheCentre) {
  const PhaseMap map = disks();
  const GrainStresses grains = measure_grains(map, linear(map), 4, 4);
  ASSERT_EQ(grains.stress.size(), 16u);
  for (std::size_t g = 0; g < 16; ++g) {
    const double x = (12 + 24 * static_cast<double>(g % 4) + 0.5) * map.dx,
                 y = (12 + 24 * static_cast<double>(g / 4) + 0.5) * map.dx;
    EXPECT_NEAR(grains.centre[g].x, x, 1e-12);
    EXPECT_NEAR(grains.centre[g].y, y, 1e-12);
    EXPECT_NEAR(grains.stress[g].xx, 3 + 20 * x - 5 * y, 1e-12);
    EXPECT_NEAR(grains.stress[g].yy, 5 + 7 * x + 11 * y, 1e-12);
    EXPECT_NEAR(grains.stress[g].xy, 1 - 2 * x + 4 * y, 1e-12);
    EXPECT_EQ(grains.stress[g].xy, grains.stress[g].yx);
  }
}

TEST(GrainStress, CutGrainsCountInNoMean) {
  const PhaseMap map = disks();
  const GrainStresses all = measure_grains(map, linear(map), 0, 4), cut = measure_grains(map, linear(map), 4, 4);
  for (std::size_t g = 0; g < 16; ++g) {
    EXPECT_EQ(all.whole[g], 1);
    const bool edge_row = g < 4 || g >= 12, large = map.grain_class[g] == GrainClass::large;
    EXPECT_EQ(cut.whole[g], !(edge_row && large)) << g;  // radius 10 about row 12 reaches row 2, radius 6 row 6
  }
}

TEST(GrainStress, MeansByClassTakeEveryGrainAlike) {
  const PhaseMap map = disks();
  const GrainStresses grains = measure_grains(map, linear(map), 0, 4);
  double large = 0;
  for (std::size_t g = 0; g < 16; g += 2) large += grains.stress[g].yy / 8;
  const Numbers mean = numbers(grains)["mean_stress_Pa"]["large"];
  EXPECT_NEAR(test::tensor_of(mean, "value").yy, large, 1e-12);
  EXPECT_GT(test::tensor_of(mean, "error").yy, 0);
}

TEST(GrainStress, AgreesWithItselfAndWithAnythingProportional) {
  const PhaseMap map = disks();
  const GrainStresses grains = measure_grains(map, linear(map), 0, 4);
  std::vector<Tensor2> contacts;
  for (const Tensor2& t : grains.stress) contacts.push_back(-3.0 * t);
  const Numbers compared = compare(map, grains, contacts);
  const Numbers& a = compared["sigma_hyd"]["all"];
  EXPECT_EQ(value_of(a, "grains"), 16);
  EXPECT_NEAR(value_of(a, "correlation"), 1, 1e-12);
  EXPECT_NEAR(value_of(a, "slope"), 1, 1e-12);
  EXPECT_NEAR(value_of(a, "rms"), 0, 1e-12);
}

TEST(GrainStress, ComparisonSeesNoiseAndLeavesOutGrainsWithoutContacts) {
  const PhaseMap map = disks(480);
  const GrainStresses grains = measure_grains(map, linear(map), 0, 4);
  RandomStream random(4, Purpose::test);
  std::vector<Tensor2> contacts;
  double mean = 0, deviation = 0;
  for (const Tensor2& t : grains.stress) mean += t.yy / static_cast<double>(grains.stress.size());
  for (const Tensor2& t : grains.stress) {
    deviation += (t.yy / mean - 1) * (t.yy / mean - 1) / static_cast<double>(grains.stress.size());
    contacts.push_back({t.xx, t.xy, t.yx, t.yy + 0.2 * mean * random.normal()});
  }
  contacts[5] = {};
  contacts[7].yy = unknown;
  const Numbers compared = compare(map, grains, contacts);
  const Numbers& a = compared["sigma_yy"]["all"];
  EXPECT_EQ(value_of(a, "grains"), static_cast<double>(grains.stress.size() - 2));
  EXPECT_NEAR(value_of(a, "rms"), 0.2, 0.02);
  EXPECT_NEAR(value_of(a, "correlation"), std::sqrt(deviation / (deviation + 0.04)), 4 * error_of(a, "correlation"));
  EXPECT_NEAR(value_of(a, "slope"), deviation / (deviation + 0.04), 4 * error_of(a, "slope"));
  EXPECT_THROW(compare(map, grains, std::vector<Tensor2>(3)), InputError);
}

}  // namespace
}  // namespace arenite::stress
