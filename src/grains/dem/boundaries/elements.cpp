#include "grains/dem/boundaries/elements.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/problems.hpp"
#include "geometry/rectangle.hpp"

namespace arenite::dem {
namespace {

/// The two ends of the segment that begins at a point.
struct Ends {
  Vec2 from, to;
};
Ends segment_at(const Boundary& boundary, std::size_t point) {
  return {boundary.points[point], boundary.points[(point + 1) % boundary.points.size()]};
}

/// The nearest point of an element to a place.
Vec2 nearest_of(const Boundary& boundary, const Element& element, Vec2 place) {
  const auto [a, b] = segment_at(boundary, element.point);
  return element.segment ? geometry::nearest_on_segment(a, b, place) : a;
}

/// A place as the image of an element that is nearest to it sees it; itself where nothing is periodic.
Vec2 seen_from(const Domain& domain, const Boundary& boundary, const Element& element, Vec2 place) {
  if (!domain.is_cell()) return place;
  const auto [a, b] = segment_at(boundary, element.point);
  const Vec2 middle = element.segment ? 0.5 * (a + b) : a, near = middle + domain.nearest_image(place - middle);
  Vec2 best = near;
  double least = std::numeric_limits<double>::infinity();
  domain.each_near_cell([&](Cells<2> cell) {
    const Vec2 image = near + domain.way(cell), way = image - nearest_of(boundary, element, image);
    if (dot(way, way) < least) least = dot(way, way), best = image;
  });
  return best;
}

/// The ways along a boundary to a point and on from it; 0 where it begins or ends.
struct Ways {
  Vec2 in, out;
};
Ways ways_at(const Domain& domain, const Boundary& boundary, std::size_t point) {
  const std::vector<Vec2>& p = boundary.points;
  const std::size_t n = p.size();
  const bool through = goes_through_sides(domain, boundary);
  Ways ways;
  if (point > 0 || boundary.closed) ways.in = p[point] - p[(point + n - 1) % n];
  else if (through) ways.in = p[n - 1] - p[n - 2];
  if (point + 1 < n || boundary.closed) ways.out = p[(point + 1) % n] - p[point];
  else if (through) ways.out = p[1] - p[0];
  return ways;
}

/// Whether a place lies beyond the segments that meet in a point.
bool is_beyond(const Domain& domain, const Boundary& boundary, std::size_t point, Vec2 place) {
  const Vec2 way = place - boundary.points[point];
  const Ways ways = ways_at(domain, boundary, point);
  if (ways.in != Vec2{} && dot(way, ways.in) < 0) return false;
  return ways.out == Vec2{} || dot(way, ways.out) <= 0;
}

/// A place as a segment sees it: how far along, of its length, and how far aside, in its length, left above 0.
Vec2 as_seen(const Ends& segment, Vec2 place) {
  const Vec2 along = segment.to - segment.from, way = place - segment.from;
  return Vec2{dot(way, along), cross(along, way)} / dot(along, along);
}

/// Whether the way from one place to the other, both as a segment sees them, leads through it or one of its ends.
bool leads_through(Vec2 from, Vec2 to) {
  if (!(from.y * to.y < 0)) return false;
  const double share = from.x + from.y / (from.y - to.y) * (to.x - from.x);
  constexpr double rounding = 1e-9;  // without it the way through a corner would miss both segments
  return share >= -rounding && share <= 1 + rounding;
}

}  // namespace

void check_shape(Problems& problems, const Domain& domain, const Boundary& boundary) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double shortest =
      std::min(domain.periodic[0] ? domain.width() : infinity, domain.periodic[1] ? domain.height() : infinity);
  const std::size_t n = boundary.points.size(), least = boundary.closed ? 3 : 2;
  bool sound = std::all_of(boundary.points.begin(), boundary.points.end(), is_finite<2>), fits = true;
  for (std::size_t p = 0; p + (boundary.closed ? 0 : 1) < n; ++p) {
    const Vec2 way = boundary.points[(p + 1) % n] - boundary.points[p];
    sound = sound && way != Vec2{};
    fits = fits && norm(way) <= (1 + 1e-9) * shortest;
  }
  problems.unless(n >= least, "boundary \"{}\" needs {} points or more", boundary.name, least);
  problems.unless(sound, "each point of boundary \"{}\" must differ from the one before", boundary.name);
  problems.unless(fits,
                  "no segment of boundary \"{}\" may be longer than the periodic cell, {} m; give it points in between",
                  boundary.name, shortest);
}

std::vector<Element> elements_of(const Domain& domain) {
  std::vector<Element> elements;
  for (std::size_t b = 0; b < domain.boundaries.size(); ++b)
    for (std::size_t p = 0; p < domain.boundaries[b].points.size(); ++p)
      for (const bool segment : {false, true})
        elements.push_back({static_cast<std::int32_t>(b), static_cast<std::int32_t>(p), segment});
  return elements;
}

bool goes_through_sides(const Domain& domain, const Boundary& boundary) {
  if (boundary.closed || !domain.is_cell()) return false;
  const Vec2 way = boundary.points.back() - boundary.points.front();
  const double width = domain.width(), height = domain.height();
  const auto is_side = [](double part, double side) { return std::abs(std::abs(part) - side) <= 1e-9 * side; };
  const bool x = domain.periodic[0] && is_side(way.x, width), y = domain.periodic[1] && is_side(way.y, height);
  return (x || y) && (x || std::abs(way.x) <= 1e-9 * width) && (y || std::abs(way.y) <= 1e-9 * height);
}

bool are_neighbours(const Sample& s, std::int32_t j, std::int32_t k) {
  const Boundary& boundary = boundary_of(s, j);
  if (boundary_index(s, k) != boundary_index(s, j)) return false;
  const bool through = goes_through_sides(s.domain, boundary);
  const auto round = static_cast<std::int32_t>(2 * (boundary.points.size() - (through ? 1 : 0)));
  const std::int32_t apart = std::abs(j - k);
  return (boundary.closed || through ? std::min(apart, round - apart) : apart) <= 2;
}

bool juts_out(const Domain& domain, const Boundary& boundary, std::size_t point, Vec2 place) {
  const Ways ways = ways_at(domain, boundary, point);
  if (ways.in == Vec2{} || ways.out == Vec2{}) return true;
  const double turn = cross(ways.in, ways.out), sense = turn > 0 ? 1 : -1;
  if (std::abs(turn) <= 1e-9 * norm(ways.in) * norm(ways.out)) return dot(ways.in, ways.out) < 0;
  const Vec2 way = place - boundary.points[point];
  return sense * cross(ways.in, way) < 0 || sense * cross(ways.out, way) < 0;
}

void find_near_elements(const Sample& s, const DiskRecord& d, std::vector<std::int32_t>& near) {
  const std::vector<BoxAround<2>>& boxes = the<Boundaries>(s).box;
  const Domain& domain = s.domain;
  const double reach = d.radius + s.skin;
  std::size_t first = 0;
  for (std::size_t b = 0; b < boxes.size(); ++b) {
    const Boundary& boundary = domain.boundaries[b];
    const BoxAround<2>& box = boxes[b];
    const std::size_t end = first + 2 * boundary.points.size();
    const bool far_x = !domain.periodic[0] && (d.place.x < box.low.x - reach || d.place.x > box.high.x + reach);
    const bool far_y = !domain.periodic[1] && (d.place.y < box.low.y - reach || d.place.y > box.high.y + reach);
    // An open boundary has no segment behind its last point, which is the first one's image where the boundary goes
    // through the sides.
    const std::size_t last = end - (boundary.closed ? 0 : goes_through_sides(domain, boundary) ? 2 : 1);
    for (std::size_t e = first; boundary.present && !far_x && !far_y && e < last; ++e) {
      const Vec2 seen = seen_from(domain, boundary, the<Boundaries>(s).element[e], d.place),
                 way = seen - nearest_of(boundary, the<Boundaries>(s).element[e], seen);
      if (dot(way, way) < reach * reach) near.push_back(boundary_partner(static_cast<int>(e)));
    }
    first = end;
  }
}

Kinematics<2> element_kinematics(const Sample& s, const DiskRecord& d, std::int32_t number, bool as_point) {
  Kinematics<2> c;
  const Element& element = the<Boundaries>(s).element[number];
  const Boundary& boundary = s.domain.boundaries[element.boundary];
  const Vec2 place = seen_from(s.domain, boundary, element, d.place);
  const auto [a, b] = segment_at(boundary, element.point);
  const Vec2 along = b - a;
  Vec2 foot = a;
  double share = 0;
  if (element.segment) {
    share = dot(place - a, along) / dot(along, along);
    if (!(share > 0 && share < 1)) return c;
    foot = a + share * along;
  } else if (!as_point && !is_beyond(s.domain, boundary, element.point, place)) {
    return c;
  }
  c.branch = place - foot;
  const double distance = norm(c.branch);
  c.overlap = d.radius - distance;
  if (!(c.overlap > 0)) return c;
  c.normal = distance > 0 ? c.branch / distance : perpendicular(along) / norm(along);
  const Membrane* skin = the<Membranes>(s).of_boundary(static_cast<std::size_t>(element.boundary));
  const Vec2 velocity = skin ? velocity_at(*skin, static_cast<std::size_t>(element.point), share)
                             : boundary.velocity + boundary.spin * perpendicular(foot - boundary.centre);
  lean_on(c, d, distance, d.velocity - velocity, s.contact.arms);
  return c;
}

Vec2 touched_place(const Sample& s, std::size_t slot, const Kinematics<2>& c) {
  return seen_from(s.domain, boundary_of(s, s.list.j[slot]), touched_element(s, s.list.j[slot]),
                   touching_disk(s, slot).place) -
         c.branch;
}

bool has_crossed(const Sample& s, std::size_t slot) {
  const Element& element = touched_element(s, s.list.j[slot]);
  const std::int32_t k = s.list.i[slot];
  const Boundary &now = s.domain.boundaries[element.boundary], &then = s.listed_domain.boundaries[element.boundary];
  if (!element.segment || !now.present) return false;
  const Vec2 listed = s.listed[k], before = seen_from(s.domain, then, element, listed);
  const Vec2 place = before + (s.record[k].place - listed);
  return leads_through(as_seen(segment_at(then, element.point), before),
                       as_seen(segment_at(now, element.point), place));
}

}  // namespace arenite::dem
