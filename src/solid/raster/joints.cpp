#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/outline.hpp"
#include "solid/raster/joints.hpp"

namespace arenite::raster {
namespace {

/// Area of a joint that its own two grains leave bare.
double bare_area(const JointShape& shape) {
  const auto& joint = shape.joint();
  std::vector<geometry::Outline> outlines{geometry::Outline::disk(joint.a, joint.radius_a), geometry::Outline::disk(joint.b, joint.radius_b)};
  const double reach = 2 * std::max({joint.radius_a, joint.radius_b, joint.half_a, joint.half_b}) + shape.length();
  const geometry::Rectangle all{joint.a.x - reach, joint.a.x + reach, joint.a.y - reach, joint.a.y + reach};
  const double grains = geometry::union_area(outlines, all);
  if (shape.is_meniscus()) add_meniscus_outlines(joint, outlines);
  else add_bridge_outline(joint, outlines);
  return geometry::union_area(outlines, all) - grains;
}

}  // namespace

int nodes_across(const Lattice& lattice, const JointShape& shape) {
  const auto& joint = shape.joint();
  const Vec2 along = shape.direction();
  const bool columns = std::abs(along.x) >= std::abs(along.y);
  const auto component = [&](Vec2 v, bool first) { return first == columns ? v.x : v.y; };
  const Vec2 from = joint.a + joint.radius_a * along, to = joint.b - joint.radius_b * along, middle = 0.5 * (from + to);
  const double p = lattice.place(component(from, true)), q = lattice.place(component(to, true));
  const int nearest = static_cast<int>(std::lround(lattice.place(component(middle, true))));
  // Overlapping grains have no gap: only the nearest line counts.
  const bool gap = shape.length() > joint.radius_a + joint.radius_b;
  const int low = gap ? std::min(nearest, static_cast<int>(std::ceil(std::min(p, q)))) : nearest;
  const int high = gap ? std::max(nearest, static_cast<int>(std::floor(std::max(p, q)))) : nearest;
  int fewest = -1;
  for (int line = low; line <= high; ++line) {
    const auto inside = [&](int k) {
      const double u = lattice.at(line), v = lattice.at(k);
      return shape.contains(columns ? Vec2{u, v} : Vec2{v, u});
    };
    const double step = (lattice.at(line) - component(middle, true)) / component(along, true);
    const int start = static_cast<int>(std::floor(lattice.place(component(middle, false) + step * component(along, false))));
    int count = 0;
    for (int k = start; inside(k); --k) ++count;
    for (int k = start + 1; inside(k); ++k) ++count;
    fewest = fewest < 0 ? count : std::min(fewest, count);
  }
  return fewest;
}

void note_joint(const Lattice& lattice, const JointShape& shape, int matrix_nodes, RasterReport& report) {
  const auto& joint = shape.joint();
  const Vec2 middle = joint.a + 0.5 * (shape.length() + joint.radius_a - joint.radius_b) * shape.direction();
  const double half = 0.5 * lattice.n * lattice.dx;
  if (std::abs(middle.x) > half || std::abs(middle.y) > half) return;
  const int across = nodes_across(lattice, shape);
  report.thinnest_joint = report.joints == 0 ? across : std::min(report.thinnest_joint, across);
  ++report.joints;
  if (matrix_nodes > 0) return;
  const double bare = bare_area(shape);
  if (!(bare > 1e-9 * joint.radius_a * joint.radius_b)) return;
  ++report.lost_joints;
  report.lost_area += bare;
}

}  // namespace arenite::raster
