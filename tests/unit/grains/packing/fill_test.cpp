#include "grains/packing/fill.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/error.hpp"
#include "grains/packing/population.hpp"

namespace arenite::packing {
namespace {

Grains disks(std::int64_t n, double min_diameter, double max_diameter) {
  Population p;
  p.material = "A";
  p.count = n;
  p.size = UniformSizes{min_diameter, max_diameter};
  return draw_grains({p}, {{"A", 1000, 1e6, 0}}, 0, 1);
}

Domain box_for(const Grains& grains, double width, double solid_fraction, bool periodic) {
  Domain domain;
  domain.periodic[0] = domain.periodic[1] = periodic;
  domain.wall[right].position = width;
  domain.wall[top].position = height_for(grains, width, solid_fraction);
  return domain;
}

/// Largest overlap over the mean radius of the pair, walls included, by comparing all with all.
double largest_overlap(const Grains& g, const Domain& d) {
  double worst = 0;
  for (std::size_t i = 0; i < g.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double reach = g.radius[i] + g.radius[j];
      worst = std::max(worst, 2 * (reach - norm(d.nearest_image(g.position[i] - g.position[j]))) / reach);
    }
    if (!d.periodic[0])
      worst = std::max({worst, 1 - (g.position[i].x - d.wall[left].position) / g.radius[i],
                        1 - (d.wall[right].position - g.position[i].x) / g.radius[i]});
    if (!d.periodic[1])
      worst = std::max({worst, 1 - (g.position[i].y - d.wall[bottom].position) / g.radius[i],
                        1 - (d.wall[top].position - g.position[i].y) / g.radius[i]});
  }
  return worst;
}

TEST(Fill, RandomFillingLeavesNoOverlapAndTheAskedSolidFraction) {
  for (const bool periodic : {false, true}) {
    auto g = disks(600, 0.008, 0.016);
    const auto box = box_for(g, 0.3, 0.78, periodic);
    const auto report = fill_at_random(g, box, 4);
    EXPECT_LE(largest_overlap(g, box), 1.0001e-4);
    EXPECT_LE(report.overlap_after, 1e-4);
    EXPECT_GT(report.overlap_before, 0.1);
    double area = 0;
    for (const double r : g.radius) area += std::numbers::pi * r * r;
    EXPECT_NEAR(area / box.area(), 0.78, 1e-12);
  }
}

TEST(Fill, SameSeedSameBytes) {
  auto a = disks(200, 0.01, 0.02), b = a, c = a;
  const auto box = box_for(a, 0.3, 0.75, false);
  fill_at_random(a, box, 9);
  fill_at_random(b, box, 9);
  fill_at_random(c, box, 10);
  EXPECT_EQ(a.position, b.position);
  EXPECT_NE(a.position, c.position);
}

TEST(Fill, AnImpossibleSolidFractionIsRefusedWithTheMend) {
  auto g = disks(100, 0.01, 0.012);
  const auto box = box_for(g, 0.12, 0.95, false);
  try {
    fill_at_random(g, box, 1);
    FAIL() << "a solid fraction of 0.95 was accepted";
  } catch (const InputError& e) { EXPECT_NE(std::string(e.what()).find("solid_fraction"), std::string::npos); }
}

TEST(Fill, SmallOverlapsOfMeasuredCentresAreRelaxedAndReported) {
  Grains g;
  g.resize(2);
  g.radius = {0.01, 0.01};
  g.position = {{0.03, 0.05}, {0.0490, 0.05}};
  Domain box;
  box.wall[right].position = box.wall[top].position = 0.1;
  const auto report = relax(g, box, 1e-6);
  EXPECT_NEAR(report.overlap_before, 0.1, 1e-12);
  EXPECT_LE(report.overlap_after, 1e-6);
  // Each centre must give way by half the overlap, 0.5 mm; inertia may carry it a fifth further.
  EXPECT_GE(report.largest_move, 0.0005 - 1e-8);
  EXPECT_LE(report.largest_move, 0.0006);
  EXPECT_NEAR(g.position[0].x + g.position[1].x, 0.079, 1e-12);
}

TEST(Fill, LatticeRowsTouchAndStayInside) {
  auto g = disks(50, 0.0105, 0.0105 + 1e-15);
  auto box = box_for(g, 0.0105 * 8, 0.9, false);
  const double height = fill_lattice(g, box);
  box.wall[top].position = height;
  EXPECT_LE(largest_overlap(g, box), 1e-9);
  int touching = 0;
  for (std::size_t i = 0; i < g.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) touching += norm(g.position[i] - g.position[j]) < 0.0105 * (1 + 1e-9);
  EXPECT_GT(touching, 100);
}

/// Equal spheres of diameter 2 in a box of that width and depth, as high as their lattice.
struct Stack {
  GrainsIn<3> spheres;
  DomainIn<3> box;

  Stack(std::size_t count, double width, double depth, bool periodic) {
    spheres.resize(count);
    spheres.radius.assign(count, 1);
    const double size[] = {width, 0, depth};
    for (int axis = 0; axis < 3; ++axis) {
      box.periodic[axis] = periodic;
      box.wall[2 * axis + 1].position = size[axis];
    }
    box.wall[top].position = fill_lattice(spheres, box);
  }
  /// Of all pairs of spheres, how far apart the nearest are, and how many touch.
  std::pair<double, int> nearest() const {
    double least = HUGE_VAL;
    int touching = 0;
    for (std::size_t i = 0; i < spheres.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const double apart = norm(box.nearest_image(spheres.position[i] - spheres.position[j]));
        least = std::min(least, apart);
        touching += apart < 2 * (1 + 1e-9);
      }
    return {least, touching};
  }
};

TEST(Fill, LatticeOfSpheresInACellHasTwelveNeighboursAndKeplersFraction) {
  const Stack stack(4 * 4 * 6, 8, 8, true);
  const auto [least, touching] = stack.nearest();
  EXPECT_NEAR(least, 2, 1e-12);
  EXPECT_EQ(touching, 6 * 4 * 4 * 6);  // half of twelve a sphere
  EXPECT_NEAR(stack.spheres.volume() / volume_of(stack.box), std::numbers::pi / std::sqrt(18), 1e-12);
}

TEST(Fill, LatticeOfSpheresStaysBetweenWalls) {
  for (const double width : {8.0, 9.0}) {  // layers that are shifted have a sphere less along it, or as many
    const Stack stack(60, width, 6.5, false);
    EXPECT_NEAR(stack.nearest().first, 2, 1e-12);
    for (const Vec3& place : stack.spheres.position)
      for (int side = 0; side < sides_in<3>; ++side) EXPECT_GE(stack.box.depth(side, place), 1 - 1e-12);
  }
  EXPECT_THROW(Stack(2, 1.9, 8, false), InputError);
}

}  // namespace
}  // namespace arenite::packing
