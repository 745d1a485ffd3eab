#include "geometry/rim.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "geometry/outline.hpp"

namespace arenite::geometry {
namespace {

Edge part_of(const Edge& arc, double from, double to) {
  return {arc.at(from), arc.at(to), arc.centre, arc.radius, arc.from + from * arc.sweep, (to - from) * arc.sweep};
}

/// Arcs in the order in which one begins where another ends.
std::vector<Edge> chained(std::vector<Edge> open) {
  std::vector<Edge> rim;
  Vec2 end;
  while (!open.empty()) {
    auto next = open.begin();
    if (!rim.empty())
      next = std::min_element(open.begin(), open.end(),
                              [&](const Edge& p, const Edge& q) { return norm(p.a - end) < norm(q.a - end); });
    end = next->b;
    rim.push_back(*next);
    open.erase(next);
  }
  return rim;
}

/// Integral of f over the directed edge, f a polynomial in sines and cosines of low degree; Gauss's five points in each
/// of eight parts.
template <class Integrand> double integral(const Edge& edge, Integrand f) {
  constexpr std::array<double, 3> node{0, 0.5384693101056831, 0.9061798459386640},
      weight{0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
  constexpr int parts = 8;
  const double half = 0.5 / parts;
  double sum = 0;
  for (int p = 0; p < parts; ++p) {
    const double middle = (2 * p + 1) * half;
    for (std::size_t k = 0; k < node.size(); ++k)
      for (const double sign : {-1.0, 1.0}) {
        if (k == 0 && sign < 0) continue;
        const double t = middle + sign * half * node[k];
        const Vec2 n = edge.outward(t);
        const double speed = edge.straight() ? norm(edge.b - edge.a) : edge.radius * std::abs(edge.sweep);
        sum += half * weight[k] * f(edge.at(t), n) * speed;
      }
  }
  return sum;
}

}  // namespace

std::vector<Edge> rim_of_disks(const std::vector<Vec2>& centre, const std::vector<double>& radius) {
  std::vector<Edge> open;
  for (std::size_t k = 0; k < centre.size(); ++k) {
    const Outline own = Outline::disk(centre[k], radius[k]);
    for (const Edge& circle : edges(own))
      for (int quarter = 0; quarter < 4; ++quarter) {
        const Edge arc = part_of(circle, 0.25 * quarter, 0.25 * (quarter + 1));
        std::vector<Part> covered;
        for (std::size_t other = 0; other < centre.size(); ++other)
          if (other != k)
            add_covered_parts(arc, Outline::disk(centre[other], radius[other]),
                              other < k ? CoveredSide::either : CoveredSide::outside, 1e-9 * radius[k], covered);
        each_rest(covered, [&](double from, double to) { open.push_back(part_of(arc, from, to)); });
      }
  }
  return chained(std::move(open));
}

std::vector<Edge> rim_of_polygon(const std::vector<Vec2>& corner, double radius) {
  std::vector<Edge> rim;
  const std::size_t n = corner.size();
  const auto normal = [&](std::size_t k) { return straight_edge(corner[k % n], corner[(k + 1) % n]).outward(0); };
  for (std::size_t k = 0; k < n; ++k) {
    const Vec2 here = normal(k), next = normal(k + 1), to = corner[(k + 1) % n];
    rim.push_back(straight_edge(corner[k] + radius * here, to + radius * here));
    rim.push_back({to + radius * here, to + radius * next, to, radius, std::atan2(here.y, here.x),
                   std::atan2(cross(here, next), dot(here, next))});
  }
  return rim;
}

Moments moments_within(const std::vector<Edge>& rim) {
  Moments m;
  for (const Edge& edge : rim) m.area += edge.area_under(0, 1);
  for (const Edge& edge : rim) {
    m.centre.x += integral(edge, [](Vec2 p, Vec2 n) { return 0.5 * p.x * p.x * n.x; }) / m.area;
    m.centre.y += integral(edge, [](Vec2 p, Vec2 n) { return 0.5 * p.y * p.y * n.y; }) / m.area;
  }
  for (const Edge& edge : rim)
    m.polar += integral(edge, [&](Vec2 p, Vec2 n) {
      const Vec2 q = p - m.centre;
      return (q.x * q.x * q.x * n.x + q.y * q.y * q.y * n.y) / 3;
    });
  return m;
}

}  // namespace arenite::geometry
