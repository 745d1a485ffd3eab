#include "raster/raster.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "support/disks.hpp"

namespace arenite::raster {
namespace {

using test::disks;

PhaseMap raster_of(const Packing& packing, const Cement& cement, std::int64_t nodes, RasterReport& report, double crop = 0) {
  PhaseMap map = rasterise(packing, cement, {nodes, crop}, {}, report);
  check(map);
  return map;
}

TEST(Raster, CountsAreasThatComeCloserToTheExactOnesWithResolution) {
  const Packing three = disks({{-1.03, -0.2, 1}, {1.01, -0.3, 1}, {0.02, 1.35, 0.8}}, 3);
  Cement cement;
  cement.bridges = {{0, 1, 0.6, 0.6}, {1, 2, 0.6, 0.48}};
  cement.menisci = {{0, 2, 0.3}};
  RasterReport coarse, fine;
  raster_of(three, cement, 100, coarse);
  raster_of(three, cement, 1600, fine);
  EXPECT_LT(std::abs(coarse.particle_area_error), 1e-2);
  EXPECT_LT(std::abs(fine.particle_area_error), 2e-4);
  EXPECT_LT(std::abs(fine.matrix_area_error), 4e-3);
  EXPECT_EQ(coarse.joints, 3u);
  EXPECT_EQ(fine.lost_joints, 0u);
}

TEST(Raster, CropThatDoesNotFitIsAnInputError) {
  RasterReport report;
  EXPECT_THROW(raster_of(disks({{0, 0, 1}}, 3), {}, 10, report, 6.1), InputError);
  EXPECT_THROW(raster_of(disks({{0, 0, 1}}, 3), {}, 0, report), InputError);
}

}  // namespace
}  // namespace arenite::raster
