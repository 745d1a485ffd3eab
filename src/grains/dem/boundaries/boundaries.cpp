#include "grains/dem/boundaries/boundaries.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include "core/error.hpp"
#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "grains/dem/boundaries/elements.hpp"
#include "grains/dem/conditions.hpp"
#include "grains/dem/forces.hpp"
#include "grains/dem/measure.hpp"
#include "grains/dem/movers.hpp"
#include "grains/dem/neighbours.hpp"

namespace arenite::dem {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Whether two elements follow each other along one boundary, perhaps with a third between them that was skipped within
/// a step.
bool are_neighbours(const Sample& s, std::int32_t j, std::int32_t k) {
  const Boundary& boundary = boundary_of(s, j);
  if (boundary_index(s, k) != boundary_index(s, j)) return false;
  const bool through = goes_through_sides(s.domain, boundary);
  const auto round = static_cast<std::int32_t>(2 * (boundary.points.size() - (through ? 1 : 0)));
  const std::int32_t apart = std::abs(j - k);
  return (boundary.closed || through ? std::min(apart, round - apart) : apart) <= 2;
}

/// How each boundary is to move.
std::vector<BoundaryMotion> motions_of(const std::vector<Boundary>& boundaries,
                                       const std::vector<BoundaryMotion>& named) {
  std::vector<BoundaryMotion> motions;
  for (const Boundary& boundary : boundaries) motions.push_back({boundary.name, {}, 0, mean_point(boundary.points)});
  for (const BoundaryMotion& motion : named) {
    const std::size_t at = index_of(boundaries, motion.name);
    if (at == boundaries.size())
      throw InputError(fmt::format("boundary \"{}\" is to move, but does not exist", motion.name));
    const auto mean = motions[at].centre;
    motions[at] = motion;
    if (!motion.centre) motions[at].centre = mean;
  }
  return motions;
}

BoundaryMotion motion_now(const Sample& s, std::size_t b) {
  const Boundary& now = s.domain.boundaries[b];
  const BoundaryBody& body = the<Boundaries>(s).body[b];
  return {now.name,   now.velocity, now.spin,
          now.centre, !now.present, body.mass > 0 ? std::optional(body.mass) : std::nullopt,
          body.force};
}

}  // namespace

void Boundaries::check(Problems& problems, const Packing& start, const ContactParameters& /*contact*/,
                       const IntegrationParameters& /*integration*/) {
  const Domain& domain = start.domain;
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

void Boundaries::make(Sample& s, const Packing& /*given*/) {
  element = elements_of(s.domain);
  body.resize(s.domain.boundaries.size());
}

double Boundaries::way_since_listed(const Sample& s) const {
  const Domain &then = s.listed_domain, &now = s.domain;
  double farthest = 0;
  for (std::size_t b = 0; b < now.boundaries.size(); ++b)
    for (std::size_t p = 0; p < now.boundaries[b].points.size(); ++p) {
      const Vec2 way = now.boundaries[b].points[p] - then.boundaries[b].points[p];
      farthest = std::max(farthest, dot(way, way));
    }
  return std::sqrt(farthest);
}

void Boundaries::check_list(const Sample& s) const { check_crossings(s); }

void Boundaries::wrap(Sample& s) {
  Domain& domain = s.domain;
  for (Boundary& boundary : domain.boundaries) {
    const Vec2 by = domain.way(-domain.cell_of(mean_point(boundary.points)));
    if (by == Vec2{}) continue;
    for (Vec2& p : boundary.points) p += by;
    boundary.centre += by;
  }
}

void Boundaries::number(Sample& s) {
  box = mapped(s.domain.boundaries, [](const Boundary& boundary) { return geometry::bounds(boundary.points); });
}

void Boundaries::find_near(const Sample& s, std::size_t disk, std::vector<std::int32_t>& partners) const {
  find_near_elements(s, s.record[disk], partners);
}

void Boundaries::before_forces(Sample& s) {
  ContactList& list = s.list;
  if (element.empty()) return;
  const auto is_of_boundary = [&](std::size_t p) { return is_boundary(list.j[p]); };
  const std::array memories{&list.memory, &list.normal_memory, &list.rolling_memory};
  const auto remembers = [&](std::size_t p) {
    return std::ranges::any_of(memories, [&](const auto* m) { return p < m->size() && (*m)[p] != 0; });
  };
  for (std::size_t p = list.pairs; p < list.polygons; ++p) {
    if (!is_of_boundary(p) || !remembers(p) || slot_kinematics(s, p).overlap > 0) continue;
    std::size_t q = p;
    while (q > list.pairs && list.i[q - 1] == list.i[p]) --q;
    for (; q < list.polygons && list.i[q] == list.i[p]; ++q) {
      if (q == p || !is_of_boundary(q) || !are_neighbours(s, list.j[p], list.j[q]) || remembers(q) ||
          !(slot_kinematics(s, q).overlap > 0))
        continue;
      for (auto* m : memories)
        if (q < m->size()) std::swap((*m)[p], (*m)[q]);
      break;
    }
  }
}

void Boundaries::add_forces(Sample& s, const ThreadPool& /*pool*/) {
  for (Boundary& boundary : s.domain.boundaries) {
    boundary.force = {};
    boundary.torque = 0;
  }
  if (element.empty()) return;
  const ContactList& list = s.list;
  for (std::size_t p = list.pairs; p < list.size(); ++p) {
    const SlotForce<2>& f = list.force[p];
    if (!is_boundary(list.j[p]) || !acts(f)) continue;
    Boundary& boundary = s.domain.boundaries[boundary_index(s, list.j[p])];
    boundary.force -= f.on_i;
    boundary.torque += f.torque_j - cross(touched_place(s, p, slot_kinematics(s, p)) - boundary.centre, f.on_i);
  }
}

bool Boundaries::meet(const Sample& s, std::size_t slot, Kinematics<2>& c) const {
  const std::int32_t j = s.list.j[slot];
  if (!is_boundary(j)) return false;
  c = element_kinematics(s, touching_disk(s, slot), element_of(j), slot >= s.list.polygons);
  return true;
}

double Boundaries::spin_of(const Sample& s, std::int32_t partner) const {
  return is_boundary(partner) ? boundary_of(s, partner).spin : 0;
}

bool Boundaries::drives(const Sample& s) const {
  for (std::size_t b = 0; b < body.size(); ++b) {
    const Boundary& told = s.domain.boundaries[b];
    if (body[b].mass == 0 && told.present && (told.velocity != Vec2{} || told.spin != 0)) return true;
  }
  return false;
}

void Boundaries::kick(Sample& s, double kick, double ahead) {
  for (std::size_t b = 0; b < body.size(); ++b) {
    BoundaryBody& of = body[b];
    if (!(of.mass > 0)) continue;
    const Vec2 acceleration = 1 / of.mass * force_on(s, b);
    of.rate += kick * acceleration;
    s.domain.boundaries[b].velocity = of.rate + ahead * acceleration;
  }
}

void Boundaries::move(Sample& s, double time) {
  for (std::size_t b = 0; b < body.size(); ++b) {
    Boundary& boundary = s.domain.boundaries[b];
    const Vec2 before = boundary.centre, velocity = body[b].mass > 0 ? body[b].rate : boundary.velocity;
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

void Boundaries::bring_to_now(const Sample& s, Domain& domain) const {
  for (std::size_t b = 0; b < body.size(); ++b) domain.boundaries[b].velocity = velocity_of(s, b);
}

void Boundaries::add_energy(const Sample& s, Energies& energies) const {
  for (std::size_t b = 0; b < body.size(); ++b)
    if (const Vec2 v = velocity_of(s, b); body[b].mass > 0) energies.kinetic += 0.5 * body[b].mass * dot(v, v);
}

Vec2 force_on(const Sample& s, std::size_t b) {
  return the<Boundaries>(s).body[b].force + the<Boundaries>(s).body[b].mass * s.gravity + s.domain.boundaries[b].force;
}

Vec2 velocity_of(const Sample& s, std::size_t b) {
  const BoundaryBody& body = the<Boundaries>(s).body[b];
  return body.mass > 0 ? body.rate + (s.lag / body.mass) * force_on(s, b) : s.domain.boundaries[b].velocity;
}

void Boundaries::go_to_present(Sample& s, const Domain& now) {
  for (std::size_t b = 0; b < body.size(); ++b)
    body[b].rate = s.domain.boundaries[b].velocity = now.boundaries[b].velocity;
}

double Boundaries::fastest_point(const Sample& s) const {
  double fastest = 0;
  for (const Boundary& boundary : s.domain.boundaries)
    for (const Vec2& p : boundary.points)
      fastest = std::max(fastest, norm(boundary.velocity + boundary.spin * perpendicular(p - boundary.centre)));
  return fastest;
}

void check_still_cell(const Sample& s, const WallDrives& drives, bool sheared) {
  if (the<Boundaries>(s).body.empty()) return;
  for (int side = 0; side < sides; ++side)
    if (s.domain.is_periodic(side) && drives[side].kind != WallDrive::Kind::fixed)
      throw InputError(
          fmt::format("the {} side is periodic and cannot move, because the boundaries would no longer fit the cell; "
                      "leave it fixed",
                      side_names[side]));
  if (sheared) throw InputError("a periodic cell with boundaries cannot be sheared; move the boundaries, or a wall");
}

void set_boundaries(Sample& s, const std::vector<BoundaryMotion>& named, const ThreadPool& pool) {
  auto& boundaries = s.domain.boundaries;
  std::vector<BoundaryMotion> motions = motions_of(boundaries, named);
  for (const Membrane& m : the<Membranes>(s).list) motions[m.boundary] = motion_now(s, m.boundary);
  bool changed = false, others_there = false;
  for (std::size_t b = 0; b < motions.size(); ++b) {
    changed |= motions[b] != motion_now(s, b);
    others_there |= motions[b].absent == boundaries[b].present;
    if (motions[b].mass && !integrator_of(s).moves_bodies)
      throw InputError(fmt::format("boundary \"{}\" has a mass, which {} cannot move; use {}", motions[b].name,
                                   integrator_of(s).word.word, integrators_of_bodies("")));
  }
  if (!changed) return;
  synchronise(s);
  book_change(s, &Energies::work_walls, &Energies::kinetic, [&] {
    for (std::size_t b = 0; b < motions.size(); ++b) {
      const BoundaryMotion& motion = motions[b];
      const bool goes_on = motion.mass && the<Boundaries>(s).body[b].mass > 0;
      if (!goes_on) boundaries[b].velocity = motion.velocity;
      the<Boundaries>(s).body[b] = {motion.mass.value_or(0), motion.force, boundaries[b].velocity};
      boundaries[b].spin = motion.spin;
      boundaries[b].centre = *motion.centre;
      boundaries[b].present = !motion.absent;
    }
  });
  if (others_there) list_anew(s, pool);
  else the<Boundaries>(s).add_forces(s);
}

}  // namespace arenite::dem
