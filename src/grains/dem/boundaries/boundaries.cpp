#include "grains/dem/boundaries/boundaries.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "grains/dem/forces.hpp"

namespace arenite::dem {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Whether two elements follow each other along one boundary, perhaps with a third between them that was skipped within
/// a step.
bool follow(const Sample& s, std::int32_t j, std::int32_t k) {
  const Boundary& boundary = boundary_of(s, j);
  if (boundary_index(s, k) != boundary_index(s, j)) return false;
  const bool through = goes_through_sides(s.domain, boundary);
  const auto round = static_cast<std::int32_t>(2 * (boundary.points.size() - (through ? 1 : 0)));
  const std::int32_t apart = std::abs(j - k);
  return (boundary.closed || through ? std::min(apart, round - apart) : apart) <= 2;
}

}  // namespace

std::vector<Element> elements_of(const Domain& domain) {
  std::vector<Element> elements;
  for (std::size_t b = 0; b < domain.boundaries.size(); ++b)
    for (std::size_t p = 0; p < domain.boundaries[b].points.size(); ++p)
      for (const bool segment : {false, true})
        elements.push_back({static_cast<std::int32_t>(b), static_cast<std::int32_t>(p), segment});
  return elements;
}

void check_boundaries(Problems& problems, const Domain& domain) {
  const double shortest =
      std::min(domain.periodic[0] ? domain.width() : infinity, domain.periodic[1] ? domain.height() : infinity);
  for (const Boundary& boundary : domain.boundaries) {
    const std::size_t n = boundary.points.size(), least = boundary.closed ? 3 : 2;
    bool sound = std::all_of(boundary.points.begin(), boundary.points.end(), is_finite<2>), fits = true;
    for (std::size_t p = 0; p + (boundary.closed ? 0 : 1) < n; ++p) {
      const Vec2 way = boundary.points[(p + 1) % n] - boundary.points[p];
      sound = sound && way != Vec2{};
      fits = fits && norm(way) <= (1 + 1e-9) * shortest;
    }
    problems.unless(n >= least, "boundary \"{}\" needs {} points or more", boundary.name, least);
    problems.unless(sound, "each point of boundary \"{}\" must differ from the one before", boundary.name);
    problems.unless(
        fits, "no segment of boundary \"{}\" may be longer than the periodic cell, {} m; give it points in between",
        boundary.name, shortest);
  }
  problems.unless(domain.boundaries.empty() || domain.tilt == 0,
                  "boundaries need a periodic cell that has not been sheared");
}

void move_boundaries(Sample& s, double time) {
  for (std::size_t b = 0; b < s.boundary.size(); ++b) {
    Boundary& boundary = s.domain.boundaries[b];
    const Vec2 before = boundary.centre, velocity = s.boundary[b].mass > 0 ? s.boundary[b].rate : boundary.velocity;
    boundary.centre += time * velocity;
    // A turn by twice atan(h), h = tan of half the angle by its series: no cosine, whose last bit depends on the
    // machine, and no change of length.
    const double half = 0.5 * time * boundary.spin, h = half + half * half * half / 3;
    const double cosine = (1 - h * h) / (1 + h * h), sine = 2 * h / (1 + h * h);
    for (Vec2& p : boundary.points) {
      const Vec2 arm = p - before;
      p = boundary.spin == 0 ? p + time * velocity : boundary.centre + cosine * arm + sine * perpendicular(arm);
    }
  }
}

Vec2 force_on(const Sample& s, std::size_t b) {
  return s.boundary[b].force + s.boundary[b].mass * s.gravity + s.domain.boundaries[b].force;
}

Vec2 velocity_of(const Sample& s, std::size_t b) {
  const BoundaryBody& body = s.boundary[b];
  return body.mass > 0 ? body.rate + (s.lag / body.mass) * force_on(s, b) : s.domain.boundaries[b].velocity;
}

void push_boundaries(Sample& s, double kick, double ahead) {
  for (std::size_t b = 0; b < s.boundary.size(); ++b) {
    BoundaryBody& body = s.boundary[b];
    if (!(body.mass > 0)) continue;
    const Vec2 acceleration = 1 / body.mass * force_on(s, b);
    body.rate += kick * acceleration;
    s.domain.boundaries[b].velocity = body.rate + ahead * acceleration;
  }
}

void wrap_boundaries(Domain& domain) {
  for (Boundary& boundary : domain.boundaries) {
    const Vec2 by = domain.way(-domain.cell_of(mean_point(boundary.points)));
    if (by == Vec2{}) continue;
    for (Vec2& p : boundary.points) p += by;
    boundary.centre += by;
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
    for (const Vec2& p : boundary.points)
      fastest = std::max(fastest, norm(boundary.velocity + boundary.spin * perpendicular(p - boundary.centre)));
  return fastest;
}

void hand_over_memories(Sample& s) {
  ContactList& list = s.list;
  if (s.element.empty()) return;
  const auto is_of_boundary = [&](std::size_t p) { return is_boundary(list.j[p]); };
  const std::array memories{&list.memory, &list.normal_memory, &list.rolling_memory, &list.pull};
  const auto remembers = [&](std::size_t p) {
    return std::ranges::any_of(memories, [&](const auto* m) { return p < m->size() && (*m)[p] != 0; });
  };
  for (std::size_t p = list.pairs; p < list.polygons; ++p) {
    if (!is_of_boundary(p) || !remembers(p) || slot_kinematics(s, p).overlap > 0) continue;
    std::size_t q = p;
    while (q > list.pairs && list.i[q - 1] == list.i[p]) --q;
    for (; q < list.polygons && list.i[q] == list.i[p]; ++q) {
      if (q == p || !is_of_boundary(q) || !follow(s, list.j[p], list.j[q]) || remembers(q) ||
          !(slot_kinematics(s, q).overlap > 0))
        continue;
      for (auto* m : memories)
        if (q < m->size()) std::swap((*m)[p], (*m)[q]);
      break;
    }
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
    const SlotForce<2>& f = list.force[p];
    if (!is_boundary(list.j[p]) || !acts(f)) continue;
    Boundary& boundary = s.domain.boundaries[boundary_index(s, list.j[p])];
    boundary.force -= f.on_i;
    boundary.torque += f.torque_j - cross(touched_place(s, p, slot_kinematics(s, p)) - boundary.centre, f.on_i);
  }
}

void check_still_cell(const Sample& s, const WallDrives& drives, bool sheared) {
  if (s.boundary.empty()) return;
  for (int side = 0; side < sides; ++side)
    if (s.domain.is_periodic(side) && drives[side].kind != WallDrive::Kind::fixed)
      throw InputError(
          fmt::format("the {} side is periodic and cannot move, because the boundaries would no longer fit the cell; "
                      "leave it fixed",
                      side_names[side]));
  if (sheared) throw InputError("a periodic cell with boundaries cannot be sheared; move the boundaries, or a wall");
}

void apply_open(Sample& s) {
  for (int side = 0; side < sides; ++side)
    s.domain.wall[side].present = s.listed_domain.wall[side].present =
        s.start.domain.wall[side].present && !s.domain.is_periodic(side) && !s.wall[side].open;
}

}  // namespace arenite::dem
