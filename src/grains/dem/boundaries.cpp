#include "grains/dem/boundaries.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "grains/dem/forces.hpp"

namespace arenite::dem {
namespace {

bool is_finite(Vec2 v) { return std::isfinite(v.x) && std::isfinite(v.y); }

/// The two ends of the segment that begins at a point.
struct Ends {
  Vec2 from, to;
};
Ends segment_at(const Boundary& boundary, std::size_t point) { return {boundary.points[point], boundary.points[(point + 1) % boundary.points.size()]}; }

/// The nearest point of an element to a place.
Vec2 nearest_of(const Boundary& boundary, const Element& element, Vec2 place) {
  const auto [a, b] = segment_at(boundary, static_cast<std::size_t>(element.point));
  if (!element.segment) return a;
  const Vec2 along = b - a;
  return a + std::clamp(dot(place - a, along) / dot(along, along), 0.0, 1.0) * along;
}

/// Whether a place lies beyond the segments that meet in a point.
bool is_beyond(const Boundary& boundary, std::size_t point, Vec2 place) {
  const std::size_t n = boundary.points.size();
  const Vec2 here = boundary.points[point], way = place - here;
  const bool before = boundary.closed || point > 0, after = boundary.closed || point + 1 < n;
  if (before && dot(way, here - boundary.points[(point + n - 1) % n]) < 0) return false;
  return !after || dot(way, boundary.points[(point + 1) % n] - here) <= 0;
}

}  // namespace

std::vector<Element> elements_of(const Domain& domain) {
  std::vector<Element> elements;
  for (std::size_t b = 0; b < domain.boundaries.size(); ++b)
    for (std::size_t p = 0; p < domain.boundaries[b].points.size(); ++p)
      for (const bool segment : {false, true}) elements.push_back({static_cast<std::int32_t>(b), static_cast<std::int32_t>(p), segment});
  return elements;
}

void check_boundaries(Problems& problems, const Domain& domain) {
  for (const Boundary& boundary : domain.boundaries) {
    const std::size_t n = boundary.points.size(), least = boundary.closed ? 3 : 2;
    problems.unless(n >= least, "boundary \"{}\" needs {} points or more", boundary.name, least);
    bool sound = std::all_of(boundary.points.begin(), boundary.points.end(), is_finite);
    for (std::size_t p = 0; p + (boundary.closed ? 0 : 1) < n; ++p) sound = sound && boundary.points[p] != boundary.points[(p + 1) % n];
    problems.unless(sound, "each point of boundary \"{}\" must be a place other than the one before", boundary.name);
  }
  problems.unless(domain.boundaries.empty() || (!domain.periodic_x && !domain.periodic_y),
                  "boundaries need a container with four walls; set periodic_x and periodic_y to false");
}

NearElements::NearElements(const Sample& sample) : sample_(sample) {
  for (const Boundary& boundary : sample.domain.boundaries) {
    Box box{boundary.points.front(), boundary.points.front()};
    for (const Vec2& p : boundary.points) {
      box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
      box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
    }
    box_.push_back(box);
  }
}

void NearElements::find(const DiskRecord& d, std::vector<std::int32_t>& near) const {
  near.clear();
  const double reach = d.radius + sample_.skin;
  const Vec2 place{d.x, d.y};
  std::size_t first = 0;
  for (std::size_t b = 0; b < box_.size(); ++b) {
    const Boundary& boundary = sample_.domain.boundaries[b];
    const Box& box = box_[b];
    const std::size_t end = first + 2 * boundary.points.size();
    const bool far = d.x < box.low.x - reach || d.x > box.high.x + reach || d.y < box.low.y - reach || d.y > box.high.y + reach;
    for (std::size_t e = first; boundary.present && !far && e < end - (boundary.closed ? 0 : 1); ++e) {
      const Vec2 way = place - nearest_of(boundary, sample_.element[e], place);
      if (dot(way, way) < reach * reach) near.push_back(static_cast<std::int32_t>(e));
    }
    first = end;
  }
}

Kinematics element_kinematics(const Sample& s, const DiskRecord& d, std::int32_t number) {
  Kinematics c;
  const Element& element = s.element[static_cast<std::size_t>(number)];
  const Boundary& boundary = s.domain.boundaries[static_cast<std::size_t>(element.boundary)];
  const auto point = static_cast<std::size_t>(element.point);
  const Vec2 place{d.x, d.y};
  const auto [a, b] = segment_at(boundary, point);
  const Vec2 along = b - a;
  Vec2 foot = a;
  if (element.segment) {
    const double share = dot(place - a, along) / dot(along, along);
    if (!(share > 0 && share < 1)) return c;
    foot = a + share * along;
  } else if (!is_beyond(boundary, point, place)) {
    return c;
  }
  c.branch = place - foot;
  const double distance = norm(c.branch);
  c.overlap = d.radius - distance;
  if (!(c.overlap > 0)) return c;
  c.normal = distance > 0 ? c.branch / distance : perpendicular(along) / norm(along);
  lean_on(c, d, distance, Vec2{d.vx, d.vy} - boundary.velocity - boundary.spin * perpendicular(foot - boundary.centre), s.contact.arms);
  return c;
}

void move_boundaries(Domain& domain, double time) {
  for (Boundary& boundary : domain.boundaries) {
    const Vec2 before = boundary.centre;
    boundary.centre += time * boundary.velocity;
    // A turn by twice atan(h), h = tan of half the angle by its series: no cosine, whose last bit depends on the machine, and no change of length.
    const double half = 0.5 * time * boundary.spin, h = half + half * half * half / 3;
    const double cosine = (1 - h * h) / (1 + h * h), sine = 2 * h / (1 + h * h);
    for (Vec2& p : boundary.points) {
      const Vec2 arm = p - before;
      p = boundary.spin == 0 ? p + time * boundary.velocity : boundary.centre + cosine * arm + sine * perpendicular(arm);
    }
  }
}

double farthest_moved(const Domain& then, const Domain& now) {
  double farthest = 0;
  for (std::size_t b = 0; b < now.boundaries.size(); ++b)
    for (std::size_t p = 0; p < now.boundaries[b].points.size(); ++p) {
      const Vec2 way = now.boundaries[b].points[p] - then.boundaries[b].points[p];
      farthest = std::max(farthest, dot(way, way));
    }
  return std::sqrt(farthest);
}

double fastest_point(const Domain& domain) {
  double fastest = 0;
  for (const Boundary& boundary : domain.boundaries)
    for (const Vec2& p : boundary.points) fastest = std::max(fastest, norm(boundary.velocity + boundary.spin * perpendicular(p - boundary.centre)));
  return fastest;
}

namespace {

/// Whether two elements follow each other along one boundary, perhaps with a third between them that was skipped within a step.
bool follow(const Sample& s, std::int32_t j, std::int32_t k) {
  const Boundary& boundary = boundary_of(s, j);
  if (boundary_index(s, k) != boundary_index(s, j)) return false;
  const auto round = static_cast<std::int32_t>(2 * boundary.points.size());
  const std::int32_t apart = std::abs(j - k);
  return (boundary.closed ? std::min(apart, round - apart) : apart) <= 2;
}

}  // namespace

void hand_over_memories(Sample& s) {
  ContactList& list = s.list;
  if (s.element.empty()) return;
  const auto is_of_boundary = [&](std::size_t p) { return list.j[p] < wall_partner(top); };
  const auto memories = [&](std::size_t p) {
    std::array<double*, 3> all{&list.memory[p], nullptr, nullptr};
    if (!list.normal_memory.empty()) all[1] = &list.normal_memory[p];
    if (!list.rolling_memory.empty()) all[2] = &list.rolling_memory[p];
    return all;
  };
  const auto remembers = [&](std::size_t p) {
    const auto all = memories(p);
    return std::any_of(all.begin(), all.end(), [](const double* m) { return m && *m != 0; });
  };
  for (std::size_t p = list.pairs; p < list.size(); ++p) {
    if (!is_of_boundary(p) || !remembers(p) || slot_kinematics(s, p).overlap > 0) continue;
    std::size_t q = p;
    while (q > list.pairs && list.i[q - 1] == list.i[p]) --q;
    for (; q < list.size() && list.i[q] == list.i[p]; ++q) {
      if (q == p || !is_of_boundary(q) || !follow(s, list.j[p], list.j[q]) || remembers(q) || !(slot_kinematics(s, q).overlap > 0)) continue;
      const auto from = memories(p), to = memories(q);
      for (std::size_t m = 0; m < from.size(); ++m)
        if (from[m]) std::swap(*from[m], *to[m]);
      break;
    }
  }
}

namespace {

/// On which side of a segment a place is, +1 or -1; 0 where it lies beyond an end.
int side_of(const Ends& segment, Vec2 place) {
  const Vec2 along = segment.to - segment.from, way = place - segment.from;
  const double share = dot(way, along);
  if (!(share > 0 && share < dot(along, along))) return 0;
  return cross(along, way) > 0 ? 1 : -1;
}

}  // namespace

void check_crossings(const Sample& s) {
  if (s.element.empty()) return;
  for (std::size_t p = s.list.pairs; p < s.list.size(); ++p) {
    if (s.list.j[p] >= wall_partner(top)) continue;
    const Element& element = s.element[static_cast<std::size_t>(-5 - s.list.j[p])];
    const auto b = static_cast<std::size_t>(element.boundary), point = static_cast<std::size_t>(element.point);
    const auto k = static_cast<std::size_t>(s.list.i[p]);
    const Boundary& now = s.domain.boundaries[b];
    if (!element.segment || !now.present) continue;
    const int before = side_of(segment_at(s.listed_domain.boundaries[b], point), {s.listed_x[k], s.listed_y[k]});
    if (before * side_of(segment_at(now, point), {s.record[k].x, s.record[k].y}) >= 0) continue;
    const auto id = s.start.grains.id[static_cast<std::size_t>(s.record[k].grain)];
    throw CannotGoOn(
        fmt::format("grain {} has gone through the boundary \"{}\" at step {}; a smaller time step or a gentler load is needed", id, now.name, s.step));
  }
}

void sum_boundary_forces(Sample& s) {
  for (Boundary& boundary : s.domain.boundaries) {
    boundary.force = {};
    boundary.torque = 0;
  }
  if (s.element.empty()) return;
  const ContactList& list = s.list;
  for (std::size_t p = list.pairs; p < list.size(); ++p) {
    const SlotForce& f = list.force[p];
    if (list.j[p] >= wall_partner(top) || !acts(f)) continue;
    Boundary& boundary = s.domain.boundaries[boundary_index(s, list.j[p])];
    const DiskRecord& d = s.record[static_cast<std::size_t>(list.i[p])];
    const Vec2 force{f.fx, f.fy}, foot = Vec2{d.x, d.y} - slot_kinematics(s, p).branch;
    boundary.force -= force;
    boundary.torque += f.torque_j - cross(foot - boundary.centre, force);
  }
}

void apply_open(Sample& s) {
  for (std::size_t side = 0; side < 4; ++side) {
    const bool periodic = side < bottom ? s.domain.periodic_x : s.domain.periodic_y;
    s.domain.wall[side].present = s.listed_domain.wall[side].present = s.start.domain.wall[side].present && !periodic && !s.wall[side].open;
  }
}

}  // namespace arenite::dem
