#include "grains/dem/membranes/membranes.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <tuple>
#include <utility>

#include "core/error.hpp"
#include "grains/dem/boundaries/elements.hpp"
#include "grains/dem/conditions.hpp"
#include "grains/dem/integrators/time_step.hpp"
#include "grains/dem/movers.hpp"
#include "grains/dem/neighbours.hpp"

namespace arenite::dem {
namespace {

const std::vector<Vec2>& points_of(const Sample& s, const Membrane& m) {
  return s.domain.boundaries[m.boundary].points;
}

/// The platen that a node is held by; for those between, the upper one.
int platen_of(const Membrane& m, std::size_t node) { return 2 * (1 - axis_of(m.side)) + (node > 0 ? 1 : 0); }

/// Of the sides of a membrane that is put on now.
void require_place(const Sample& s, int side) {
  const auto refuse = [&](const std::string& why) {
    throw InputError(fmt::format("the {} side cannot be a membrane: {}", side_names[side], why));
  };
  if (s.domain.is_cell()) refuse("the container is periodic");
  if (!integrator_of(s).moves_bodies)
    refuse(fmt::format("{} cannot move it; use {}", integrator_of(s).word.word, integrators_of_bodies("")));
  if (std::ranges::any_of(grains_of(s).shapes.filled, [](std::uint8_t filled) { return filled != 0; }))
    refuse("its nodes would cut into polygons; take disks or clumps");
  const int low = 2 * (1 - axis_of(side));
  for (const int platen : {low, low + 1})
    if (!s.domain.wall[platen].present)
      refuse(fmt::format("there is no wall at the {} to hold it", side_names[platen]));
  if (index_of(s.domain.boundaries, membrane_name(side)) < s.domain.boundaries.size())
    refuse(fmt::format("a boundary is called {} already", membrane_name(side)));
}

/// In a straight line where its wall is.
Membrane flat_membrane(const Sample& s, int side, const SkinParameters& of, std::vector<Vec2>& points) {
  const auto disks = std::span(s.record).first(s.count);
  const double smallest = std::ranges::min_element(disks, {}, &DiskRecord::radius)->radius;
  double lightest = std::numeric_limits<double>::infinity();
  each_mover(s, [&](std::size_t k) { lightest = std::min(lightest, mover_at(s, k).mass); });
  Membrane m;
  m.side = side;
  m.node_mass = of.node_mass.value_or(lightest);
  m.slides = of.ends == SkinEnds::sliding;
  m.may_stretch = of.largest_strain;
  const double length = s.domain.length(side), spacing = of.spacing.value_or(smallest);
  const auto segments = static_cast<std::size_t>(std::max(2.0, std::ceil(length / spacing - 1e-9)));
  m.skin.stiffness = of.stiffness * s.domain.thickness;
  m.skin.rest = length / static_cast<double>(segments);
  m.skin.towards = dot(inward_normal(side), perpendicular(of_side(side, 0, 1))) > 0 ? 1 : -1;
  const double from = s.domain.wall[platen_of(m, 0)].position;
  for (std::size_t k = 0; k <= segments; ++k)
    points.push_back(of_side(side, s.domain.wall[side].position, from + static_cast<double>(k) * m.skin.rest));
  m.rate.assign(segments + 1, {});
  m.velocity = m.of_grains = m.rate;
  return m;
}

void press(const Sample& s, Membrane& m, double pressure, double damping) {
  m.skin.pressure = pressure * s.domain.thickness;
  if (m.skin.dashpot == 0)
    m.skin.dashpot = damping * std::sqrt((m.skin.stiffness / m.skin.rest + m.skin.pressure) * m.node_mass);
}

void number_membranes(Membranes& all) {
  std::size_t first = 0;
  for (Membrane& m : all.list) {
    m.first = first;
    first += m.nodes();
  }
}

}  // namespace

std::string membrane_name(int side) { return fmt::format("{}_membrane", side_names[side]); }

const Membrane* Membranes::of_boundary(std::size_t boundary) const {
  const auto at = std::ranges::find(list, boundary, &Membrane::boundary);
  return at == list.end() ? nullptr : &*at;
}

const Membrane* Membranes::on_side(int side) const {
  const auto at = std::ranges::find(list, side, &Membrane::side);
  return at == list.end() ? nullptr : &*at;
}

TouchedSkin touched_skin(const Sample& s, std::size_t slot, const Kinematics<2>& c) {
  const Element& element = touched_element(s, s.list.j[slot]);
  TouchedSkin touched{the<Membranes>(s).of_boundary(static_cast<std::size_t>(element.boundary)),
                      static_cast<std::size_t>(element.point), static_cast<std::size_t>(element.point), 0};
  if (!touched.of || !element.segment) return touched;
  const std::vector<Vec2>& points = points_of(s, *touched.of);
  touched.next = touched.node + 1;
  const Vec2 along = points[touched.next] - points[touched.node],
             way = touching_disk(s, slot).place - c.branch - points[touched.node];
  touched.share = std::clamp(dot(way, along) / dot(along, along), 0.0, 1.0);
  return touched;
}

void Membranes::add_forces(Sample& s, const ThreadPool& /*pool*/) {
  if (list.empty()) return;
  for (Membrane& m : list) {
    m.of_grains.assign(m.nodes(), Vec2{});
    find_forces(m.skin, points_of(s, m), m.velocity, m.own);
    for (std::size_t k = 0; k < m.nodes(); ++k) m.own.braked[k] -= (s.drag * m.node_mass) * m.velocity[k];
  }
  for (std::size_t p = s.list.pairs; p < s.list.size(); ++p) {
    const SlotForce<2>& f = s.list.force[p];
    if (!is_boundary(s.list.j[p]) || !acts(f)) continue;
    const TouchedSkin at = touched_skin(s, p, slot_kinematics(s, p));
    if (!at.of) continue;
    Membrane& m = list[static_cast<std::size_t>(at.of - list.data())];
    m.of_grains[at.node] -= (1 - at.share) * f.on_i;
    m.of_grains[at.next] -= at.share * f.on_i;
  }
}

void Membranes::add_to_walls(Sample& s) const {
  for (const Membrane& m : list) {
    Vec2 sum;
    for (const Vec2& force : m.of_grains) sum += force;
    s.domain.wall[m.side].force = -dot(sum, inward_normal(m.side));
    s.domain.wall[m.side].shear_force = along(m.side, sum);
  }
}

/// A contact of a grain and a node is counted twice with either of them, so that neither depends on the other; a node
/// with two contacts on either segment.
void Membranes::raise_rates(const Sample& s, const SlopesOf<2>& slopes, Rates& rates) const {
  if (list.empty()) return;
  Slopes springs, dashpots;
  for (std::size_t k = 0; k < s.count; ++k) {
    const DiskRecord& d = s.record[k];
    const ContactSlopes between = slopes(d);
    const double stiffer = s.coefficients.wall_stiffness(d) / s.coefficients.pair_stiffness(d, d);
    for (const auto& [most, of, factor] : {std::tuple{&springs, between.springs, stiffer},
                                           std::tuple{&dashpots, between.dashpots, std::sqrt(2 * stiffer)}})
      most->normal = std::max(most->normal, factor * std::max(of.normal, of.sliding));
  }
  for (const Membrane& m : list) {
    constexpr double contacts = 4, twice = 2, neighbours = 4;
    const double spring = twice * contacts * springs.normal + neighbours * m.skin.stiffness / m.skin.rest +
                          2 * m.skin.pressure,
                 dashpot = twice * contacts * dashpots.normal + neighbours * m.skin.dashpot;
    rates.frequency_squared = std::max(rates.frequency_squared, spring / m.node_mass);
    rates.damping = std::max(rates.damping, dashpot / m.node_mass);
  }
}

void Membranes::kick(Sample& s, double kick, double ahead) {
  for (Membrane& m : list)
    for (std::size_t k = 0; k < m.nodes(); ++k) {
      const int platen = platen_of(m, k);
      const Wall& wall = s.domain.wall[platen];
      const WallBody& body = s.wall[platen];
      const Vec2 acceleration = 1 / m.node_mass * m.force(k), held = of_side(platen, body.rate, body.drive.slide),
                 seen = of_side(platen, wall.velocity, body.drive.slide);
      for (const int axis : {0, 1}) {
        const bool free = m.is_free(k, axis);
        m.rate[k][axis] = free ? m.rate[k][axis] + kick * acceleration[axis] : held[axis];
        m.velocity[k][axis] = free ? m.rate[k][axis] + ahead * acceleration[axis] : seen[axis];
      }
    }
}

void Membranes::move(Sample& s, double time) {
  for (Membrane& m : list) {
    Boundary& boundary = s.domain.boundaries[m.boundary];
    std::vector<Vec2>& points = boundary.points;
    for (std::size_t k = 0; k < m.nodes(); ++k) points[k] += time * m.rate[k];
    const int axis = 1 - axis_of(m.side);
    for (const std::size_t end : {std::size_t{0}, m.nodes() - 1})
      points[end][axis] = s.domain.wall[platen_of(m, end)].position;
    s.domain.wall[m.side].position = mean_place(points, axis_of(m.side));
    boundary.centre = mean_point(points);
    m.stretched = std::max(m.stretched, largest_strain(m.skin, points));
  }
}

void Membranes::add_energy(const Sample& s, Energies& energies) const {
  for (const Membrane& m : list) {
    energies.elastic += energy_of(m.skin, points_of(s, m));
    for (std::size_t k = 0; k < m.nodes(); ++k)
      for (const int axis : {0, 1}) {
        const double v = m.rate[k][axis] + s.lag / m.node_mass * m.force(k)[axis];
        if (m.is_free(k, axis)) energies.kinetic += 0.5 * m.node_mass * v * v;
      }
  }
}

bool Membranes::lets_drift(const Sample& s, int axis) const {
  const Membrane *low = on_side(2 * axis), *high = on_side(2 * axis + 1);
  const int below = 2 * (1 - axis), above = below + 1;  // platens, which friction or a rough face makes hold the grains
  const auto holds = [&](int side) {
    return s.domain.wall[side].present && (s.wall_friction > 0 || s.wall[side].rough);
  };
  return low && high && low->slides && high->slides && s.domain.boundaries.size() == list.size() &&
         (axis == 0 ? s.gravity.x : s.gravity.y) == 0 && !holds(below) && !holds(above);
}

void Membranes::note_present(const Sample& s) {
  for (Membrane& m : list)
    for (std::size_t k = 0; k < m.nodes(); ++k)
      for (const int axis : {0, 1})
        if (m.is_free(k, axis)) m.rate[k][axis] += s.lag / m.node_mass * m.force(k)[axis];
}

bool Membranes::is_any(const Sample& s) { return std::ranges::any_of(s.wall, &WallBody::skin); }

void Membranes::make_room(Sample& s, std::uint64_t count) {
  if (count > sides) throw InputError("the stored state has more membranes than sides");
  for (Domain* domain : {&s.domain, &s.listed_domain})
    domain->boundaries.resize(domain->boundaries.size() - std::min(list.size(), domain->boundaries.size()));
  list.assign(count, {});
}

void Membranes::add_boundaries(Sample& s) {
  for (Membrane& m : list) {
    m.boundary = s.domain.boundaries.size();
    Boundary boundary;
    boundary.name = membrane_name(m.side);
    boundary.points.resize(m.nodes());
    for (Domain* domain : {&s.domain, &s.listed_domain}) domain->boundaries.push_back(boundary);
  }
  number_membranes(*this);
  the<Boundaries>(s).element = elements_of(s.domain);
  the<Boundaries>(s).body.resize(s.domain.boundaries.size());
}

Vec2 mean_forces(const Sample& s) {
  Vec2 mean;
  for (int side = 0; side < sides; ++side)
    if (!the<Membranes>(s).on_side(side)) mean[axis_of(side)] += 0.5 * s.domain.wall[side].force;
  const Vec2 middle = 0.5 * (s.domain.corner(0) + s.domain.corner(1));
  for (const Membrane& m : the<Membranes>(s).list)
    for (std::size_t k = 0; k < m.nodes(); ++k)
      for (const int axis : {0, 1})
        mean[axis] += (points_of(s, m)[k] - middle)[axis] * m.of_grains[k][axis] / s.domain.extent(axis);
  return mean;
}

void press_membrane(Sample& s, int side, double pressure) {
  std::ranges::find(the<Membranes>(s).list, side, &Membrane::side)->skin.pressure = pressure * s.domain.thickness;
}

void set_membranes(Sample& s, const BySide<std::optional<double>>& pressure, const SkinParameters& of,
                   const ThreadPool& pool) {
  Membranes& all = the<Membranes>(s);
  bool changes = false, is_new = false;
  for (int side = 0; side < sides; ++side) {
    const Membrane* there = all.on_side(side);
    if (there && !pressure[side])
      throw InputError(fmt::format("the {} side is a membrane and cannot become a wall again; give it its pressure",
                                   side_names[side]));
    if (!pressure[side]) continue;
    if (!there) require_place(s, side);
    is_new = is_new || !there;
    changes = changes || !there || there->skin.pressure != *pressure[side] * s.domain.thickness;
  }
  if (!changes) return;
  synchronise(s);
  for (int side = 0; side < sides; ++side) {
    if (!pressure[side]) continue;
    if (const Membrane* there = all.on_side(side)) {
      press(s, all.list[static_cast<std::size_t>(there - all.list.data())], *pressure[side], of.damping);
      continue;
    }
    Boundary boundary;
    Membrane m = flat_membrane(s, side, of, boundary.points);
    press(s, m, *pressure[side], of.damping);
    find_forces(m.skin, boundary.points, m.velocity, m.own);
    boundary.name = membrane_name(side);
    boundary.centre = mean_point(boundary.points);
    m.boundary = s.domain.boundaries.size();
    for (Domain* domain : {&s.domain, &s.listed_domain}) domain->boundaries.push_back(boundary);
    s.wall[side].skin = true;
    all.list.push_back(std::move(m));
  }
  number_membranes(all);
  if (!is_new) return all.add_forces(s);
  the<Boundaries>(s).element = elements_of(s.domain);
  the<Boundaries>(s).body.resize(s.domain.boundaries.size());
  list_anew(s, pool);
  allow_step(s, "membranes; a larger membrane.node_mass lengthens it");
}

}  // namespace arenite::dem
