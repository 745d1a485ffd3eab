#include "geometry/union_area.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "geometry/cell_grid.hpp"
#include "geometry/outline.hpp"

namespace arenite::geometry {
namespace {

/// Outlines that touch the window, sorted into cells by the rectangles around them.
class Index {
 public:
  Index(std::span<const Outline> outlines, const Rectangle& window) {
    double extent = 0;
    for (const auto& o : outlines) {
      const Rectangle box = bounds(o);
      if (!overlap(box, window)) continue;
      outline.push_back(o);
      boxes.push_back(box);
      extent += std::max(box.width(), box.height());
    }
    const Box<2> box{{window.x_min, window.y_min}, {window.width(), window.height()}};
    grid_ = {box, outline.empty() ? 1 : extent / static_cast<double>(outline.size()), 2000};
    std::vector<std::int32_t> cell;  // of every pair of an outline and a cell that its rectangle meets
    for (std::size_t o = 0; o < boxes.size(); ++o)
      visit(boxes[o], [&](std::int32_t c) {
        cell.push_back(c);
        owner_.push_back(static_cast<std::int32_t>(o));
      });
    cells_ = {grid_.size(), 0, cell.size(), [&](std::size_t k) { return cell[k]; }};
    seen_.assign(outline.size(), -1);
  }

  std::vector<Outline> outline;
  std::vector<Rectangle> boxes;

  /// Outlines whose rectangle meets `box`, each once, in the order of cells.
  void find(const Rectangle& box, std::vector<std::int32_t>& found) {
    found.clear();
    ++query_;
    visit(box, [&](std::int32_t cell) {
      for (auto k = cells_.first[cell]; k < cells_.first[cell + 1]; ++k) {
        const auto o = owner_[cells_.item[k]];
        if (seen_[o] == query_) continue;
        seen_[o] = query_;
        if (overlap(boxes[o], box)) found.push_back(o);
      }
    });
  }

 private:
  template <class Cell> void visit(const Rectangle& box, Cell&& cell) const {
    const auto left = grid_.along(0, box.x_min), right = grid_.along(0, box.x_max), top = grid_.along(1, box.y_max);
    for (auto row = grid_.along(1, box.y_min); row <= top; ++row)
      for (auto column = left; column <= right; ++column) cell(row * grid_.count[0] + column);
  }

  CellGrid<2> grid_{{{}, {1, 1}}, 1};
  SortedCells cells_{1, 0, 0, [](std::size_t) { return 0; }};
  std::int64_t query_ = 0;
  std::vector<std::int32_t> owner_;
  std::vector<std::int64_t> seen_;
};

/// How far off an edge its sides are looked at.
double step_of(const Rectangle& box) { return 1e-9 * std::max(box.width(), box.height()); }

/// A line whose ends lie in a disk lies in it; half the edges of bridges end here.
bool is_in_a_disk(const Edge& edge, const Index& index, const std::vector<std::int32_t>& near) {
  if (!edge.straight()) return false;
  for (const auto o : near) {
    const Outline& outline = index.outline[o];
    if (outline.kind == Outline::Kind::disk && contains(outline, edge.a) && contains(outline, edge.b)) return true;
  }
  return false;
}

bool is_inside(const Rectangle& a, const Rectangle& window) {
  return a.x_min > window.x_min && a.x_max < window.x_max && a.y_min > window.y_min && a.y_max < window.y_max;
}

double sector(Vec2 a, Vec2 b, double radius) { return 0.5 * radius * radius * std::atan2(cross(a, b), dot(a, b)); }

/// Signed area common to the disk about the origin and the triangle (origin, a, b).
double triangle_part(Vec2 a, Vec2 b, double radius) {
  const Vec2 d = b - a;
  const double length2 = dot(d, d);
  if (length2 == 0) return 0;
  const double middle = -dot(a, d) / length2;  // foot of the perpendicular, as share of a..b
  const double distance2 = std::pow(cross(a, d), 2) / length2;
  const double half2 = (radius * radius - distance2) / length2;
  if (half2 <= 0) return sector(a, b, radius);
  const double half = std::sqrt(half2);
  const double enter = std::clamp(middle - half, 0.0, 1.0), leave = std::clamp(middle + half, 0.0, 1.0);
  if (enter >= leave) return sector(a, b, radius);
  const Vec2 p = a + enter * d, q = a + leave * d;
  double area = 0.5 * cross(p, q);
  if (enter > 0) area += sector(a, p, radius);
  if (leave < 1) area += sector(q, b, radius);
  return area;
}

}  // namespace

double disk_window_area(Vec2 centre, double radius, const Rectangle& w) {
  const auto [x0, x1, y0, y1] = w + -centre;
  if (x0 >= radius || x1 <= -radius || y0 >= radius || y1 <= -radius) return 0;
  if (x0 <= -radius && x1 >= radius && y0 <= -radius && y1 >= radius) return std::numbers::pi * radius * radius;
  const auto corners = Rectangle{x0, x1, y0, y1}.corners();
  double area = 0;
  for (std::size_t k = 0; k < 4; ++k) area += triangle_part(corners[k], corners[(k + 1) % 4], radius);
  return std::clamp(area, 0.0, std::numbers::pi * radius * radius);
}

double union_area(std::span<const Outline> outlines, const Rectangle& window) {
  // About the window's middle, so that a far origin costs no digits.
  const Vec2 middle = window.middle();
  std::vector<Outline> moved(outlines.begin(), outlines.end());
  for (auto& o : moved) {
    o.centre -= middle;
    for (auto& c : o.corner) c -= middle;
  }
  const Rectangle w = window + -middle;
  Index index(moved, w);
  std::vector<std::int32_t> near;
  std::vector<Part> covered;
  double area = 0;
  for (std::size_t o = 0; o < index.outline.size(); ++o) {
    const auto self = static_cast<std::int32_t>(o);
    index.find(index.boxes[o], near);
    const double step = step_of(index.boxes[o]);
    for (const Edge& edge : edges(index.outline[o])) {
      if (edge.straight() && edge.a.x == edge.b.x && edge.a.y == edge.b.y) continue;
      if (is_in_a_disk(edge, index, near)) continue;
      const Rectangle box = bounds(edge);
      covered.clear();
      if (!is_inside(box, w)) add_parts_outside(edge, w, step, covered);
      for (const auto other : near) {
        if (other == self || !overlap(index.boxes[other], box)) continue;
        add_covered_parts(edge, index.outline[other], other < self ? CoveredSide::either : CoveredSide::outside, step,
                          covered);
        if (!covered.empty() && covered.back().from == 0 && covered.back().to == 1) break;
      }
      double uncovered = 0;
      each_rest(covered, [&](double from, double to) { uncovered += edge.area_under(from, to); });
      area += uncovered;
    }
  }
  const auto corner = w.corners();
  for (std::size_t k = 0; k < 4; ++k) {
    const Edge side = straight_edge(corner[k], corner[(k + 1) & 3]);
    const Rectangle box = bounds(side);
    index.find(box, near);
    covered.clear();
    for (const auto other : near)
      add_covered_parts(side, index.outline[other], CoveredSide::inside, step_of(index.boxes[other]), covered);
    merge(covered);
    for (const Part& part : covered) area += side.area_under(part.from, part.to);
  }
  return area;
}

}  // namespace arenite::geometry
