#include <gtest/gtest.h>

#include <cmath>

#include "thermal/inference/grain_rows.hpp"

namespace arenite::inference {
namespace {

constexpr double pixel = 1.6e-3, disk_size = 7e-3;

/// One grain under three forces; its second neighbour only spills light.
Placed two_grains() {
  Placed p;
  p.length = 0.06, p.radius = {disk_size, disk_size}, p.factor = {1.5e-8, 2.5e-8};
  p.centre = p.found = {{0, 0}, {2.05 * disk_size, 0}};
  const auto touch = [](int contact, double angle) {
    return Touch{contact, -1, {std::cos(angle), std::sin(angle)}, 0};
  };
  p.touches = {{touch(0, 0.4), touch(1, 2.2), touch(2, 4.5)}, {touch(3, 1.3), touch(4, 4.0)}};
  p.near = {{{1, {0, 0}}}, {{0, {0, 0}}}};
  p.force = {400, 50, 700, -80, 300, 120, 500, 20, 450, -60};
  return p;
}

/// Pixels in the middle, beside the rim and beside the other grain.
const std::vector<GrainPixel> pixels{{{0.3e-3, 0.5e-3}, 0, 1, 1, 0},
                                     {{5.6e-3, -1e-3}, 0, 1, 1, 1},
                                     {{-3e-3, 4.5e-3}, 0, 1, 1, 2},
                                     {{-5.4e-3, 2e-3}, 0, 1, 1, 3}};

/// Warming of every pixel.
std::vector<double> warming(const Placed& p) {
  const GrainRows rows = rows_of_grain(p, 0, pixels, PointSpread(pixel, 0.5));
  std::vector<double> out = rows.spill;
  for (std::size_t q = 0; q < pixels.size(); ++q)
    for (std::size_t k = 0; k < 6; ++k) out[q] += rows.response(k, q) * p.force[k];
  return out;
}

TEST(GrainRows, TurningANormalDoesWhatItsColumnSays) {
  const GrainRows rows = rows_of_grain(two_grains(), 0, pixels, PointSpread(pixel, 0.5));
  const double step = 1e-5;
  for (std::size_t k = 0; k < 3; ++k) {
    Placed more = two_grains(), less = two_grains();
    more.touches[0][k].normal += step * perpendicular(more.touches[0][k].normal);
    less.touches[0][k].normal -= step * perpendicular(less.touches[0][k].normal);
    const std::vector<double> a = warming(more), b = warming(less);
    for (std::size_t q = 0; q < pixels.size(); ++q)
      EXPECT_NEAR(rows.turn(k, q), (a[q] - b[q]) / (2 * step), 1e-6 + 1e-3 * std::abs(rows.turn(k, q)));
  }
}

/// Cut pixels are sums over points, whose number in the grain jumps: a step of a point's distance, and a tenth of the
/// size.
TEST(GrainRows, MovingTheCentreDoesWhatItsColumnsSay) {
  Placed alone = two_grains();
  alone.near[0].clear();
  const GrainRows rows = rows_of_grain(alone, 0, pixels, PointSpread(pixel, 0.5));
  for (std::size_t axis = 0; axis < 2; ++axis)
    for (std::size_t q = 0; q < pixels.size(); ++q) {
      const double step = q == 0 ? 1e-6 : 0.125 * pixel;
      const Vec2 d = axis == 0 ? Vec2{step, 0} : Vec2{0, step};
      Placed more = alone, less = alone;
      more.centre[0] += d, less.centre[0] -= d;
      const double size = norm(rows.shift[q]);
      EXPECT_NEAR(rows.shift[q][axis], (warming(more)[q] - warming(less)[q]) / (2 * step),
                  (q == 0 ? 1e-4 : 0.15) * size)
          << q << axis;
    }
}

TEST(GrainRows, NeighboursSpillOnlyWhereTheLensReaches) {
  const GrainRows rows = rows_of_grain(two_grains(), 0, pixels, PointSpread(pixel, 0.5));
  EXPECT_EQ(rows.spill[0], 0);
  EXPECT_NE(rows.spill[1], 0);
  EXPECT_EQ(rows.spill[2], 0);
}

}  // namespace
}  // namespace arenite::inference
