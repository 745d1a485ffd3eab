#include "grains/fields/free_surface.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "core/joined_sets.hpp"
#include "core/problems.hpp"
#include "geometry/close_pairs.hpp"
#include "statistics/correlation.hpp"
#include "statistics/jackknife.hpp"

namespace arenite::fields {
namespace {

constexpr std::size_t blocks = 8;         // of neighbouring columns, for the error of a slope
constexpr std::size_t least_columns = 8;  // that a line is laid through
constexpr double low = 0.2,
                 high =
                     0.8;  // part of a flank's height that it is laid through: neither the rounded top nor the thin toe
constexpr double least_drop = 4;  // mean diameters that a flank falls at least

/// Grains that hang together, turned so that gravity points down; in space with their places along the depth.
struct Body {
  std::vector<Vec2> centre;
  std::vector<double> aside, radius;
};

template <int D> std::vector<std::size_t> largest_set(const GrainsIn<D>& g, double gap) {
  geometry::Box<D> box = geometry::around<D>(g.position);
  const double rim = *std::max_element(g.radius.begin(), g.radius.end()) + gap;
  for (int axis = 0; axis < D; ++axis) box.corner[axis] -= rim, box.size[axis] += 2 * rim;
  JoinedSets sets(g.size());
  for (const auto& p : geometry::close_pairs<D>(g.position, g.radius, box, gap)) sets.join(p.i, p.j);
  std::vector<std::vector<std::size_t>> members(g.size());
  for (std::size_t k = 0; k < g.size(); ++k) members[sets.find(static_cast<std::int32_t>(k))].push_back(k);
  return *std::max_element(members.begin(), members.end(),
                           [](const auto& a, const auto& b) { return a.size() < b.size(); });
}

double aside_of(Vec2 /*place*/) { return 0; }
double aside_of(Vec3 place) { return place.z; }

template <int D> Body body_of(const GrainsIn<D>& g, Vec2 up, double gap) {
  Body body;
  for (const std::size_t k : largest_set(g, gap)) {
    const Vec2 place{g.position[k].x, g.position[k].y};
    body.centre.push_back({cross(place, up), dot(place, up)});
    body.aside.push_back(aside_of(g.position[k]));
    body.radius.push_back(g.radius[k]);
  }
  return body;
}

/// Rows of columns of a width that a body is seen from above by.
struct Raster {
  double left = 0, back = 0, width = 0;
  std::size_t columns = 1, rows = 1;
};

/// Columns from one to the other, the second left out.
struct Span {
  std::size_t from = 0, to = 1;
};

/// Those of so many, of a width from an origin on, whose middles lie within a radius of a place.
Span within(double place, double radius, double origin, double width, std::size_t count) {
  const double first = (place - radius - origin) / width - 0.5, last = (place + radius - origin) / width - 0.5;
  return {static_cast<std::size_t>(std::max(0.0, std::ceil(first))),
          static_cast<std::size_t>(std::clamp(std::floor(last) + 1, 0.0, static_cast<double>(count)))};
}

/// The highest rim in the middle of each column of each row, row after row; -infinity where there is no grain.
std::vector<double> highest_rims(const Body& body, const Raster& on) {
  std::vector<double> rim(on.columns * on.rows, -std::numeric_limits<double>::infinity());
  for (std::size_t k = 0; k < body.centre.size(); ++k) {
    const Vec2 centre = body.centre[k];
    const double r = body.radius[k];
    const Span columns = within(centre.x, r, on.left, on.width, on.columns),
               rows = on.rows == 1 ? Span{} : within(body.aside[k], r, on.back, on.width, on.rows);
    for (std::size_t row = rows.from; row < rows.to; ++row)
      for (std::size_t c = columns.from; c < columns.to; ++c) {
        const double off = on.left + (static_cast<double>(c) + 0.5) * on.width - centre.x,
                     deep = on.rows == 1 ? 0 : on.back + (static_cast<double>(row) + 0.5) * on.width - body.aside[k],
                     up = r * r - off * off - deep * deep;
        double& highest = rim[row * on.columns + c];
        if (up >= 0 || on.rows == 1) highest = std::max(highest, centre.y + std::sqrt(std::max(0.0, up)));
      }
  }
  return rim;
}

/// The upper rim in the middle of columns of a width, mean over the depth; none where a column has no grain.
void trace_rim(const Body& body, const Raster& on, FreeSurface& surface) {
  const std::vector<double> rim = highest_rims(body, on);
  for (std::size_t c = 0; c < on.columns; ++c) {
    double sum = 0;
    std::size_t known = 0;
    for (std::size_t row = 0; row < on.rows; ++row)
      if (const double height = rim[row * on.columns + c]; std::isfinite(height)) sum += height, ++known;
    if (known == 0) continue;
    surface.place.push_back(on.left + (static_cast<double>(c) + 0.5) * on.width);
    surface.height.push_back(sum / static_cast<double>(known));
  }
}

/// So many columns of a width as fit.
std::size_t columns_of(double length, double width) {
  return static_cast<std::size_t>(std::max(1.0, std::floor(length / width)));
}

/// Between which places along the depth a body lies.
std::pair<double, double> depth_of(const Body& body) {
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (std::size_t k = 0; k < body.radius.size(); ++k) {
    low = std::min(low, body.aside[k] - body.radius[k]);
    high = std::max(high, body.aside[k] + body.radius[k]);
  }
  return {low, high};
}

void put_depth(const Packing& /*packing*/, const Body& /*body*/, Raster& /*raster*/, FreeSurface& /*surface*/) {}
void put_depth(const PackingIn<3>& packing, const Body& body, Raster& raster, FreeSurface& surface) {
  const auto [low, high] = depth_of(body);
  const double between = packing.domain.wall[front].position - packing.domain.wall[back].position;
  raster.back = low;
  raster.rows = columns_of(high - low, raster.width);
  surface.fills_depth = between - (high - low) < surface.diameter;
}

/// Angle by which the profile falls along `sign` x between two columns, first and last of a flank.
Flank flank_between(const FreeSurface& s, std::size_t first, std::size_t last, double sign) {
  Flank flank;
  const auto part = std::span(s.height).subspan(first, last + 1 - first);
  const double foot = std::ranges::min(part), drop = std::ranges::max(part) - foot;
  if (drop < least_drop * s.diameter) return flank;
  // From the last column above the part to the first below it, so that a bump of one grain does not tear it.
  const auto share = [&](std::size_t c) { return (s.height[c] - foot) / drop; };
  const std::size_t from = sign > 0 ? first : last, to = sign > 0 ? last : first;
  const auto next = [&](std::size_t c) { return sign > 0 ? c + 1 : c - 1; };
  std::size_t begin = from, end = to;
  for (std::size_t c = from; c != to; c = next(c))
    if (share(c) > high) begin = c;
  for (std::size_t c = begin; c != to; c = next(c))
    if (share(c) < low) {
      end = c;
      break;
    }
  statistics::Items items;
  for (std::size_t c = std::min(begin, end); c <= std::max(begin, end); ++c) items.push_back(c);
  flank.columns = items.size();
  if (items.size() < least_columns) return flank;
  std::vector<int> block(s.height.size(), 0);
  for (std::size_t k = 0; k < items.size(); ++k) block[items[k]] = static_cast<int>(k * blocks / items.size());
  const auto slope = [&](const statistics::Items& some) {
    std::vector<double> x, y;
    for (const std::size_t c : some) x.push_back(s.place[c]), y.push_back(s.height[c]);
    return std::vector<double>{std::atan(-sign * statistics::fit_line(x, y).slope)};
  };
  flank.angle = statistics::jackknife(items, block, slope).front();
  return flank;
}

void measure_flanks(FreeSurface& s) {
  const auto begin = s.height.begin(), top = std::max_element(begin, s.height.end());
  const auto apex = static_cast<std::size_t>(top - begin);
  const auto foot_left = static_cast<std::size_t>(std::min_element(begin, top + 1) - begin);
  const auto foot_right = static_cast<std::size_t>(std::min_element(top, s.height.end()) - begin);
  if (foot_left < apex) s.left_flank = flank_between(s, foot_left, apex, -1);
  if (foot_right > apex) s.right_flank = flank_between(s, apex, foot_right, 1);
  double sum = 0, value = 0, square = 0;
  for (const Flank* flank : {&s.left_flank, &s.right_flank}) {
    if (!std::isfinite(flank->angle.value)) continue;
    const auto weight = static_cast<double>(flank->columns);
    sum += weight;
    value += weight * flank->angle.value;
    square += weight * weight * flank->angle.error * flank->angle.error;
  }
  if (sum > 0) s.angle = {value / sum, std::sqrt(square) / sum};
}

}  // namespace

template <int D> FreeSurface find_free_surface(const PackingIn<D>& packing, Vec2 gravity, double gap) {
  const double g = norm(gravity);
  if (!(g > 0) || !std::isfinite(g))
    throw InputError("gravity has no direction, so there is no surface; give one, for example straight down");
  if (packing.grains.size() == 0) throw InputError("there are no grains that could have a surface");
  if (!(gap >= 0))
    throw refusal("a gap of {:g} diameters between connected grains is not possible; give 0 or more", gap);
  FreeSurface surface;
  for (const double r : packing.grains.radius) surface.diameter += 2 * r / static_cast<double>(packing.grains.size());
  const Body body = body_of(packing.grains, -1.0 / g * gravity, gap * surface.diameter);
  surface.grains = body.centre.size();
  const geometry::Rectangle around = geometry::bounds(body.centre, body.radius);
  surface.left = around.x_min, surface.right = around.x_max, surface.bottom = around.y_min, surface.top = around.y_max;
  Raster raster{.left = surface.left, .width = surface.diameter};
  raster.columns = columns_of(surface.right - surface.left, raster.width);
  put_depth(packing, body, raster, surface);
  trace_rim(body, raster, surface);
  if (!surface.place.empty() && surface.fills_depth) measure_flanks(surface);
  return surface;
}
template FreeSurface find_free_surface(const Packing&, Vec2, double);
template FreeSurface find_free_surface(const PackingIn<3>&, Vec2, double);

double way_of_front(bool to_right, const FreeSurface& then, const FreeSurface& now) {
  return to_right ? now.right - then.right : then.left - now.left;
}

Front farther_front(const FreeSurface& then, const FreeSurface& now) {
  const double right = way_of_front(true, then, now), left = way_of_front(false, then, now);
  return {right >= left, std::max(right, left)};
}

bool in_drum(const Domain& domain) {
  return std::ranges::any_of(domain.boundaries, [](const Boundary& b) { return b.present && b.closed && b.spin != 0; });
}

bool in_drum(const DomainIn<3>& domain) {
  return std::ranges::any_of(domain.boundaries, [](const auto& b) { return b.present && b.spin.z != 0; });
}

}  // namespace arenite::fields
