#include "grains/fields/free_surface.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

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

/// Grains that hang together, turned so that gravity points down.
struct Body {
  std::vector<Vec2> centre;
  std::vector<double> radius;
};

std::vector<std::size_t> largest_set(const Grains& g, double gap) {
  const geometry::Rectangle box = geometry::bounds(g.position);
  const double rim = *std::max_element(g.radius.begin(), g.radius.end()) + gap;
  JoinedSets sets(g.size());
  for (const auto& p : geometry::close_pairs(
           g.position, g.radius, {{box.x_min - rim, box.y_min - rim}, {box.width() + 2 * rim, box.height() + 2 * rim}},
           gap))
    sets.join(p.i, p.j);
  std::vector<std::vector<std::size_t>> members(g.size());
  for (std::size_t k = 0; k < g.size(); ++k) members[sets.find(static_cast<std::int32_t>(k))].push_back(k);
  return *std::max_element(members.begin(), members.end(),
                           [](const auto& a, const auto& b) { return a.size() < b.size(); });
}

Body body_of(const Packing& packing, Vec2 up, double gap) {
  Body body;
  const Grains& g = packing.grains;
  for (const std::size_t k : largest_set(g, gap)) {
    body.centre.push_back({cross(g.position[k], up), dot(g.position[k], up)});
    body.radius.push_back(g.radius[k]);
  }
  return body;
}

/// The upper rim in the middle of columns of this width; none where a column has no grain.
void trace_rim(const Body& body, double width, FreeSurface& surface) {
  const auto columns = static_cast<std::size_t>(std::max(1.0, std::floor((surface.right - surface.left) / width)));
  std::vector<double> rim(columns, -std::numeric_limits<double>::infinity());
  for (std::size_t k = 0; k < body.centre.size(); ++k) {
    const double first = (body.centre[k].x - body.radius[k] - surface.left) / width - 0.5,
                 last = (body.centre[k].x + body.radius[k] - surface.left) / width - 0.5;
    for (auto c = static_cast<std::ptrdiff_t>(std::max(0.0, std::ceil(first)));
         c <= last && c < static_cast<std::ptrdiff_t>(columns); ++c) {
      const double off = surface.left + (static_cast<double>(c) + 0.5) * width - body.centre[k].x;
      auto& highest = rim[c];
      highest =
          std::max(highest, body.centre[k].y + std::sqrt(std::max(0.0, body.radius[k] * body.radius[k] - off * off)));
    }
  }
  for (std::size_t c = 0; c < columns; ++c) {
    if (!std::isfinite(rim[c])) continue;
    surface.place.push_back(surface.left + (static_cast<double>(c) + 0.5) * width);
    surface.height.push_back(rim[c]);
  }
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

FreeSurface find_free_surface(const Packing& packing, Vec2 gravity, double gap) {
  const double g = norm(gravity);
  if (!(g > 0) || !std::isfinite(g))
    throw InputError("gravity has no direction, so there is no surface; give one, for example straight down");
  if (packing.grains.size() == 0) throw InputError("there are no grains that could have a surface");
  if (!(gap >= 0))
    throw refusal("a gap of {:g} diameters between connected grains is not possible; give 0 or more", gap);
  FreeSurface surface;
  for (const double r : packing.grains.radius) surface.diameter += 2 * r / static_cast<double>(packing.grains.size());
  const Body body = body_of(packing, -1.0 / g * gravity, gap * surface.diameter);
  surface.grains = body.centre.size();
  const geometry::Rectangle around = geometry::bounds(body.centre, body.radius);
  surface.left = around.x_min, surface.right = around.x_max, surface.bottom = around.y_min, surface.top = around.y_max;
  trace_rim(body, surface.diameter, surface);
  if (!surface.place.empty()) measure_flanks(surface);
  return surface;
}

bool in_drum(const Domain& domain) {
  return std::ranges::any_of(domain.boundaries, [](const Boundary& b) { return b.present && b.closed && b.spin != 0; });
}

}  // namespace arenite::fields
