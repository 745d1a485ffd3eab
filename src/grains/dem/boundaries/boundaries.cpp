#include "grains/dem/boundaries/boundaries.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/error.hpp"
#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "grains/dem/boundaries/elements.hpp"
#include "grains/dem/boundaries/faces.hpp"
#include "grains/dem/forces.hpp"

namespace arenite::dem {
namespace {

template <int D> BoxAround<D> box_around(const std::vector<Vec<D>>& points) {
  BoxAround<D> box{points[0], points[0]};
  for (const Vec<D>& p : points)
    for (int axis = 0; axis < D; ++axis) {
      box.low[axis] = std::min(box.low[axis], p[axis]);
      box.high[axis] = std::max(box.high[axis], p[axis]);
    }
  return box;
}

/// What a list of contacts remembers of each slot, one array a component.
template <int D> std::vector<std::vector<double>*> memories_of(ContactListIn<D>& list) {
  std::vector<std::vector<double>*> memories;
  const auto take = [&](auto& components) {
    for (std::vector<double>& numbers : components.along) memories.push_back(&numbers);
  };
  take(list.memory), take(list.normal_memory), take(list.rolling_memory), take(list.twist_memory);
  return memories;
}

/// tan of half the angle by which something turns in a time, by its series: no cosine, whose last bit depends on the
/// machine. A turn by twice atan of it changes no length.
double tan_of_half(double spin, double time) {
  const double half = 0.5 * time * spin;
  return half + half * half * half / 3;
}

/// Points turn about where the centre was, and go on with it.
void turn_points(Boundary& boundary, Vec2 before, double time) {
  const double h = tan_of_half(boundary.spin, time);
  const double cosine = (1 - h * h) / (1 + h * h), sine = 2 * h / (1 + h * h);
  for (Vec2& p : boundary.points) {
    const Vec2 arm = p - before;
    p = boundary.centre + cosine * arm + sine * perpendicular(arm);
  }
}
void turn_points(BoundaryIn<3>& boundary, Vec3 before, double time) {
  const double spin = norm(boundary.spin), h = tan_of_half(spin, time);
  const Vec3 axis = boundary.spin / spin;
  for (Vec3& p : boundary.points) {
    const Vec3 arm = p - before, aside = cross(axis, arm);
    p = boundary.centre + arm + 2 * h / (1 + h * h) * (aside + h * cross(axis, aside));
  }
}

}  // namespace

template <int D>
void BoundariesIn<D>::check(Problems& problems, const PackingIn<D>& start, const ContactParameters& /*contact*/,
                            const IntegrationParameters& /*integration*/) {
  for (const BoundaryIn<D>& boundary : start.domain.boundaries) check_shape(problems, start.domain, boundary);
  problems.unless(start.domain.boundaries.empty() || start.domain.tilt == 0,
                  "boundaries need a periodic cell that has not been sheared");
}

template <int D> void BoundariesIn<D>::make(SampleIn<D>& s, const PackingIn<D>& /*given*/) {
  element = elements_of(s.domain);
  body.resize(s.domain.boundaries.size());
}

template <int D> double BoundariesIn<D>::way_since_listed(const SampleIn<D>& s) const {
  const DomainIn<D>&then = s.listed_domain, &now = s.domain;
  double farthest = 0;
  for (std::size_t b = 0; b < now.boundaries.size(); ++b)
    for (std::size_t p = 0; p < now.boundaries[b].points.size(); ++p) {
      const Vec<D> way = now.boundaries[b].points[p] - then.boundaries[b].points[p];
      farthest = std::max(farthest, dot(way, way));
    }
  return std::sqrt(farthest);
}

template <int D> void BoundariesIn<D>::check_list(const SampleIn<D>& s) const {
  if (element.empty()) return;
  for (std::size_t p = s.list.pairs; p < s.list.polygons; ++p) {
    if (!is_boundary<D>(s.list.j[p]) || !has_crossed(s, p)) continue;
    const auto id = s.start.grains.id[s.record[s.list.i[p]].grain];
    throw CannotGoOn(fmt::format(
        "grain {} has passed through the boundary \"{}\" at step {}; a smaller time step or a gentler load is needed",
        id, boundary_of(s, s.list.j[p]).name, s.step));
  }
}

template <int D> void BoundariesIn<D>::wrap(SampleIn<D>& s) {
  DomainIn<D>& domain = s.domain;
  for (BoundaryIn<D>& boundary : domain.boundaries) {
    const Vec<D> by = domain.way(-domain.cell_of(mean_point(boundary.points)));
    if (by == Vec<D>{}) continue;
    for (Vec<D>& p : boundary.points) p += by;
    boundary.centre += by;
  }
}

template <int D> void BoundariesIn<D>::number(SampleIn<D>& s) {
  box = mapped(s.domain.boundaries, [](const BoundaryIn<D>& boundary) { return box_around(boundary.points); });
}

template <int D>
void BoundariesIn<D>::find_near(const SampleIn<D>& s, std::size_t disk, std::vector<std::int32_t>& partners) const {
  find_near_elements(s, s.record[disk], partners);
}

template <int D> void BoundariesIn<D>::before_forces(SampleIn<D>& s) {
  ContactListIn<D>& list = s.list;
  if (element.empty()) return;
  const auto is_of_boundary = [&](std::size_t p) { return is_boundary<D>(list.j[p]); };
  const std::vector<std::vector<double>*> memories = memories_of(list);
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

template <int D> void BoundariesIn<D>::add_forces(SampleIn<D>& s, const ThreadPool& /*pool*/) {
  for (BoundaryIn<D>& boundary : s.domain.boundaries) {
    boundary.force = {};
    boundary.torque = {};
  }
  if (element.empty()) return;
  const ContactListIn<D>& list = s.list;
  for (std::size_t p = list.pairs; p < list.size(); ++p) {
    const SlotForce<D>& f = list.force[p];
    if (!is_boundary<D>(list.j[p]) || !acts(f)) continue;
    BoundaryIn<D>& boundary = s.domain.boundaries[boundary_index(s, list.j[p])];
    boundary.force -= f.on_i;
    boundary.torque += f.torque_j - cross(touched_place(s, p, slot_kinematics(s, p)) - boundary.centre, f.on_i);
  }
}

template <int D> bool BoundariesIn<D>::meet(const SampleIn<D>& s, std::size_t slot, Kinematics<D>& c) const {
  if (!is_boundary<D>(s.list.j[slot])) return false;
  c = kinematics_at_element(s, slot);
  return true;
}

template <int D> Turning<D> BoundariesIn<D>::spin_of(const SampleIn<D>& s, std::int32_t partner) const {
  return is_boundary<D>(partner) ? boundary_of(s, partner).spin : Turning<D>{};
}

template <int D> bool BoundariesIn<D>::drives(const SampleIn<D>& s) const {
  for (std::size_t b = 0; b < body.size(); ++b) {
    const BoundaryIn<D>& told = s.domain.boundaries[b];
    if (body[b].mass == 0 && told.present && (told.velocity != Vec<D>{} || told.spin != Turning<D>{})) return true;
  }
  return false;
}

template <int D> void BoundariesIn<D>::kick(SampleIn<D>& s, double kick, double ahead) {
  for (std::size_t b = 0; b < body.size(); ++b) {
    BoundaryBodyIn<D>& of = body[b];
    if (!(of.mass > 0)) continue;
    const Vec<D> acceleration = 1 / of.mass * force_on(s, b);
    of.rate += kick * acceleration;
    s.domain.boundaries[b].velocity = of.rate + ahead * acceleration;
  }
}

template <int D> void BoundariesIn<D>::move(SampleIn<D>& s, double time) {
  for (std::size_t b = 0; b < body.size(); ++b) {
    BoundaryIn<D>& boundary = s.domain.boundaries[b];
    const Vec<D> before = boundary.centre, velocity = body[b].mass > 0 ? body[b].rate : boundary.velocity;
    boundary.centre += time * velocity;
    if (boundary.spin == Turning<D>{})
      for (Vec<D>& p : boundary.points) p += time * velocity;
    else turn_points(boundary, before, time);
  }
}

template <int D> void BoundariesIn<D>::bring_to_now(const SampleIn<D>& s, DomainIn<D>& domain) const {
  for (std::size_t b = 0; b < body.size(); ++b) domain.boundaries[b].velocity = velocity_of(s, b);
}

template <int D> void BoundariesIn<D>::add_energy(const SampleIn<D>& s, Energies& energies) const {
  for (std::size_t b = 0; b < body.size(); ++b)
    if (const Vec<D> v = velocity_of(s, b); body[b].mass > 0) energies.kinetic += 0.5 * body[b].mass * dot(v, v);
}

template <int D> Vec<D> force_on(const SampleIn<D>& s, std::size_t b) {
  const BoundaryBodyIn<D>& body = the<BoundariesIn<D>>(s).body[b];
  return body.force + body.mass * s.gravity + s.domain.boundaries[b].force;
}

template <int D> Vec<D> velocity_of(const SampleIn<D>& s, std::size_t b) {
  const BoundaryBodyIn<D>& body = the<BoundariesIn<D>>(s).body[b];
  return body.mass > 0 ? body.rate + (s.lag / body.mass) * force_on(s, b) : s.domain.boundaries[b].velocity;
}

template <int D> void BoundariesIn<D>::go_to_present(SampleIn<D>& s, const DomainIn<D>& now) {
  for (std::size_t b = 0; b < body.size(); ++b)
    body[b].rate = s.domain.boundaries[b].velocity = now.boundaries[b].velocity;
}

template <int D> double BoundariesIn<D>::fastest_point(const SampleIn<D>& s) const {
  double fastest = 0;
  for (const BoundaryIn<D>& boundary : s.domain.boundaries)
    for (const Vec<D>& p : boundary.points)
      fastest = std::max(fastest, norm(boundary.velocity + cross(boundary.spin, p - boundary.centre)));
  return fastest;
}

template struct BoundariesIn<2>;
template struct BoundariesIn<3>;
#define ARENITE_OF(D)                                           \
  template Vec<D> force_on<D>(const SampleIn<D>&, std::size_t); \
  template Vec<D> velocity_of<D>(const SampleIn<D>&, std::size_t);
ARENITE_OF(2)
ARENITE_OF(3)
#undef ARENITE_OF

}  // namespace arenite::dem
