#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "core/random.hpp"
#include "geometry/close_pairs.hpp"
#include "grains/packing/fill.hpp"
#include "model/phase_map.hpp"

namespace arenite::test {

/// A made-up cemented packing in the image of P's samples, for tests and benchmarks of the peridynamic solvers.
struct CementedSample {
  int nodes = 1024;              ///< a side; the mean large radius spans nodes/25.6
  double size_ratio = 2.5;       ///< gamma
  double volume_ratio = 1.6;     ///< theta
  double bridge = 0.4;           ///< eta, half-width of a bridge over the radius; >= 10 fills all pores
  double gap = 0.075;            ///< widest surface gap that is bridged, over the mean large radius
  double solid_fraction = 0.86;  ///< of disks, overlaps counted twice
  std::uint64_t seed = 1;
};

inline double matrix_saturation(const PhaseMap& map) {
  std::size_t matrix = 0, particle = 0;
  for (const Phase p : map.phase) matrix += p == Phase::matrix, particle += p == Phase::particle;
  return static_cast<double>(matrix) / static_cast<double>(std::max<std::size_t>(1, map.size() - particle));
}

inline Grains pressed_disks(const CementedSample& sample, double side) {
  Grains grains;
  RandomStream random(sample.seed, Purpose::test);
  const auto draw = [&](double mean, double area) {
    const double deviation = 0.25 * mean;
    while (area > 0) {
      const double r = mean + std::clamp(random.normal(), -1.5, 1.5) * deviation;
      area -= std::numbers::pi * r * r;
      grains.radius.push_back(r);
      grains.material.push_back(mean == 1 ? 1 : 0);
    }
  };
  const double solid = sample.solid_fraction * side * side;
  draw(1, solid * sample.volume_ratio / (1 + sample.volume_ratio));
  draw(1 / sample.size_ratio, solid / (1 + sample.volume_ratio));
  const auto radius = grains.radius;
  const auto material = grains.material;
  grains.resize(radius.size());
  grains.radius = radius;
  grains.material = material;
  Domain domain;
  domain.periodic[0] = domain.periodic[1] = true;
  for (auto& wall : domain.wall) wall.present = false;
  domain.wall[right].position = domain.wall[top].position = side;
  for (std::size_t i = 0; i < grains.size(); ++i) {
    grains.position[i] = {random.uniform(0, side), random.uniform(0, side)};
  }
  packing::relax(grains, domain, 1e-4, 400);
  return grains;
}

inline PhaseMap cemented_sample(const CementedSample& sample) {
  const double side = 25.6, per_node = side / sample.nodes;
  const Grains grains = pressed_disks(sample, side);
  PhaseMap map = make_phase_map(sample.nodes, sample.nodes, 1e-3 * per_node);
  for (std::size_t g = 0; g < grains.size(); ++g)
    map.grain_class.push_back(grains.material[g] ? GrainClass::large : GrainClass::small);

  std::vector<double> depth(map.size(), 0);
  const auto visit = [&](double x0, double x1, double y0, double y1, auto&& node) {
    const auto low = [&](double a) { return std::max(0, static_cast<int>(std::ceil(a / per_node - 0.5))); };
    const auto high = [&](double a) {
      return std::min(sample.nodes - 1, static_cast<int>(std::floor(a / per_node - 0.5)));
    };
    for (int y = low(y0); y <= high(y1); ++y)
      for (int x = low(x0); x <= high(x1); ++x) node(map.index(x, y), (x + 0.5) * per_node, (y + 0.5) * per_node);
  };
  const auto images = [&](auto&& at) {
    for (const double sx : {-side, 0.0, side})
      for (const double sy : {-side, 0.0, side}) at(sx, sy);
  };
  for (std::size_t g = 0; g < grains.size(); ++g)
    images([&](double sx, double sy) {
      const double cx = grains.position[g].x + sx, cy = grains.position[g].y + sy, r = grains.radius[g];
      visit(cx - r, cx + r, cy - r, cy + r, [&](std::size_t i, double x, double y) {
        const double inside = r - std::hypot(x - cx, y - cy);
        if (inside < 0 || inside < depth[i]) return;
        depth[i] = inside;
        map.phase[i] = Phase::particle;
        map.grain[i] = static_cast<std::int32_t>(g);
      });
    });
  if (sample.bridge >= 10) {
    for (auto& p : map.phase) p = p == Phase::empty ? Phase::matrix : p;
    return map;
  }
  for (const auto [a, b] :
       geometry::close_pairs(grains.position, grains.radius, {{}, {side, side}, {true, true}}, sample.gap))
    images([&, a = a, b = b](double sx, double sy) {
      const double ax = grains.position[a].x + sx, ay = grains.position[a].y + sy;
      const double dx = std::remainder(grains.position[b].x - grains.position[a].x, side),
                   dy = std::remainder(grains.position[b].y - grains.position[a].y, side);
      const double l2 = dx * dx + dy * dy, wide = sample.bridge * std::max(grains.radius[a], grains.radius[b]);
      visit(std::min(ax, ax + dx) - wide, std::max(ax, ax + dx) + wide, std::min(ay, ay + dy) - wide,
            std::max(ay, ay + dy) + wide, [&](std::size_t i, double x, double y) {
              const double t = ((x - ax) * dx + (y - ay) * dy) / l2,
                           across = std::abs((x - ax) * dy - (y - ay) * dx) / std::sqrt(l2);
              if (t < 0 || t > 1 || across > sample.bridge * ((1 - t) * grains.radius[a] + t * grains.radius[b]))
                return;
              if (map.phase[i] == Phase::empty) map.phase[i] = Phase::matrix;
            });
    });
  return map;
}

}  // namespace arenite::test
