#include "grains/dem/setup.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/problems.hpp"
#include "grains/dem/advance.hpp"
#include "grains/dem/conditions.hpp"
#include "grains/dem/forces.hpp"
#include "grains/dem/glue.hpp"
#include "grains/dem/integrators/time_step.hpp"
#include "grains/dem/neighbours.hpp"

namespace arenite::dem {
namespace {

bool positive(double v) { return std::isfinite(v) && v > 0; }
bool not_negative(double v) { return std::isfinite(v) && v >= 0; }

template <int D>
void check_parameters(Problems& problems, const PackingIn<D>& start, const ContactParameters& contact,
                      const IntegrationParameters& integration) {
  problems.unless(contact.restitution > 0 && contact.restitution <= 1, "restitution {} must be above 0 and at most 1",
                  contact.restitution);
  problems.unless(not_negative(contact.friction), "friction {} must be a number >= 0", contact.friction);
  problems.unless(not_negative(contact.wall_friction.value_or(0)), "wall friction {} must be a number >= 0",
                  contact.wall_friction.value_or(0));
  problems.unless(not_negative(contact.normal_damping.value_or(0)), "normal damping {} N s/m must be >= 0",
                  contact.normal_damping.value_or(0));
  problems.unless(not_negative(contact.sliding_viscosity.value_or(0)), "sliding viscosity {} N s/m must be >= 0",
                  contact.sliding_viscosity.value_or(0));
  problems.unless(positive(contact.tangential_stiffness_ratio), "tangential stiffness ratio {} must be above 0",
                  contact.tangential_stiffness_ratio);
  problems.unless(not_negative(contact.surface_energy), "surface energy {} N/m must be >= 0", contact.surface_energy);
  problems.unless(positive(integration.safety), "safety {} must be above 0", integration.safety);
  problems.unless(not_negative(integration.drag), "drag {} 1/s must be >= 0", integration.drag);
  problems.unless(integration.threads >= 1, "threads {} must be 1 or more", integration.threads);
  const auto n = static_cast<std::int32_t>(start.grains.size());
  for (const BondIn<D>& bond : start.bonds)
    problems.unless(bond.i >= 0 && bond.i < bond.j && bond.j < n && bond.length > 0,
                    "bond ({}, {}) must join two of the {} grains, the lower first", bond.i, bond.j, n);
  for (const auto& [a, b] : contact.glued_pairs)
    problems.unless(a >= 0 && b >= 0 && a < n && b < n && a != b, "glued pair ({}, {}) must name two of the {} grains",
                    a, b, n);
}

/// What a law of E and nu needs of a material.
void check_moduli(Problems& problems, const Material& m, const NormalLaw& law) {
  const bool both = m.youngs_modulus && m.poisson;
  problems.unless(both, "material \"{}\" has no {}, which the normal law \"{}\" needs", m.name,
                  m.youngs_modulus ? "poisson" : "youngs_modulus", law.word());
  problems.unless(!m.youngs_modulus || positive(*m.youngs_modulus),
                  "youngs_modulus {} Pa of material \"{}\" must be above 0", m.youngs_modulus.value_or(0), m.name);
  const double nu = m.poisson.value_or(0);
  problems.unless(nu >= 0 && nu <= 0.5, "poisson {} of material \"{}\" must lie between 0 and 0.5", nu, m.name);
}

void check_thickness(Problems& problems, const Domain& domain) {
  problems.unless(positive(domain.thickness), "thickness {} m must be above 0", domain.thickness);
}
void check_thickness(Problems& /*problems*/, const DomainIn<3>& /*domain*/) {}

template <int D> void check_packing(Problems& problems, const PackingIn<D>& start, const ContactParameters& contact) {
  const DomainIn<D>& domain = start.domain;
  problems.unless(start.grains.size() > 0, "the packing has no grains");
  bool extended = true;
  for (int axis = 0; axis < D; ++axis) extended = extended && positive(domain.extent(axis));
  problems.unless(extended, "the container must have a width and a height above 0");
  for (const auto& m : start.materials) {
    problems.unless(positive(m.density), "density {} kg/m^3 of material \"{}\" must be above 0", m.density, m.name);
    if (contact.takes_moduli()) check_moduli(problems, m, contact.normal);
    else
      problems.unless(positive(m.stiffness), "stiffness {} N/m of material \"{}\" must be above 0", m.stiffness,
                      m.name);
  }
  const GrainsIn<D>& g = start.grains;
  for (std::size_t k = 0; k < g.size(); ++k) {
    problems.unless(positive(g.radius[k]), "radius {} m of grain {} must be above 0", g.radius[k], g.id[k]);
    problems.unless(is_finite(g.position[k]) && is_finite(g.velocity[k]) && is_finite(g.omega[k]),
                    "grain {} has a coordinate or velocity that is not a number", g.id[k]);
    problems.unless(g.material[k] >= 0 && static_cast<std::size_t>(g.material[k]) < start.materials.size(),
                    "material {} of grain {} is not among the {} materials", g.material[k], g.id[k],
                    start.materials.size());
    bool inside = true;
    for (int side = 0; side < sides_in<D>; ++side)
      inside = inside && (!domain.wall[side].present || domain.depth(side, g.position[k]) >= 0);
    problems.unless(inside, "the centre of grain {} is outside of the container", g.id[k]);
  }
}

template <int D> void place_disks(SampleIn<D>& s) {
  const GrainsIn<D>& g = s.start.grains;
  s.count = g.size();
  s.record.resize(s.count);
  const CellMotion<D> cell = cell_motion(s.domain);
  each_motion_array(s, [&](auto& a) { a.assign(s.count, 0.0); });
  for (std::size_t k = 0; k < s.count; ++k) {
    const double r = g.radius[k];
    const Turning<D> omega = s.integration.rotations ? g.omega[k] : Turning<D>{};
    s.omega.put(k, omega);
    s.record[k] = {g.position[k], g.velocity[k], omega, r, 0, g.material[k], static_cast<std::int32_t>(k)};
    s.record[k].mass = own_mass(s, static_cast<std::int32_t>(k));
    s.velocity.put(k, g.velocity[k] - cell.at(g.position[k]));
    s.angle.put(k, g.angle[k]);
    s.largest_radius = std::max(s.largest_radius, r);
  }
  const std::vector<double>& radius = grains_of(s).radius;
  s.skin = largest_skin * std::accumulate(radius.begin(), radius.end(), 0.0) / static_cast<double>(radius.size());
}

template <int D> void check_cell(const SampleIn<D>& s) {
  constexpr std::array<std::array<const char*, 2>, 3> words{{{"wide", "narrow"}, {"high", "low"}, {"deep", "flat"}}};
  Problems problems;
  double needed = 2.0 * reach_of(s);
  each_part(s, [&](const auto& part) { needed = std::max(needed, part.least_cell(s)); });
  for (int axis = 0; axis < D; ++axis)
    problems.unless(!s.domain.periodic[axis] || s.domain.extent(axis) >= needed,
                    "a periodic cell {} m {} is too {} for its grains; {} m would do", s.domain.extent(axis),
                    words[axis][0], words[axis][1], needed);
  problems.raise();
}

/// Whether a contact of the caller's packing is the one of a slot that joins the same grains.
template <int D> bool is_of_slot(const SampleIn<D>& s, const ContactsIn<D>& c, std::size_t q, std::size_t slot) {
  if (has_disks_only(s) || c.off_i.empty()) return true;
  auto [i, j] = levers_of(s, slot);
  if (s.list.j[slot] >= 0 && grain_of(s, s.record[s.list.i[slot]].grain) != c.i[q]) std::swap(i, j);
  const double near = 1e-6 * grains_of(s).radius[c.i[q]];
  return norm(i - c.off_i[q]) <= near && norm(j - c.off_j[q]) <= near;
}

/// The slip that has this force; of a slip along several ways it points along the force.
template <class F> double slip_of(const F& friction, double force, double stiffness) {
  return friction.recall(force, stiffness);
}
template <class F> Vec3 slip_of(const F& friction, Vec3 force, double stiffness) {
  return friction.recall(norm(force), stiffness) / norm(force) * force;
}

/// What the contacts of the packing left in the memories of the laws, so that a stage goes on with the friction that it
/// found.
template <int D> void recall_contacts(SampleIn<D>& s) {
  if (!remembers(s.laws)) return;
  const ContactsIn<D>& c = s.start.contacts;
  std::vector<std::pair<std::uint64_t, std::size_t>> met;
  for (std::size_t q = 0; q < c.size(); ++q) met.emplace_back(pair_key(c.i[q], c.j[q]), q);
  std::sort(met.begin(), met.end());
  s.laws.visit([&]<class N, class A, class F>(const N& normal, const A& adhesion, const F& friction) {
    for (std::size_t p = 0; p < s.list.size(); ++p) {
      const std::int32_t j = s.list.j[p];
      const std::uint64_t key =
          pair_key(grain_of(s, s.record[s.list.i[p]].grain), j < 0 ? j : grain_of(s, s.record[s.list.owner[p]].grain));
      auto found = std::lower_bound(met.begin(), met.end(), std::pair{key, std::size_t{0}});
      while (found != met.end() && found->first == key && !is_of_slot(s, c, found->second, p)) ++found;
      if (found == met.end() || found->first != key) continue;
      const std::size_t q = found->second;
      const Kinematics<D> at = slot_kinematics(s, p);
      const double kt = sliding_stiffness(s, normal, p, at);
      if constexpr (F::remembers)
        if (c.ft[q] != Turning<D>{} && is_finite(c.ft[q]) && kt > 0)
          s.list.memory.put(p, slip_of(friction, c.ft[q], kt));
      if constexpr (N::remembers)
        if (at.overlap > 0 && std::isfinite(c.fn[q])) {
          double pull = 0;
          each_part(s, [&](const auto& part) { pull += part.pull_of(p); });
          s.list.normal_memory[p] = normal.recall(c.fn[q] + adhesion.attraction(at.overlap, s.list.strength[p]) + pull,
                                                  at.overlap, s.list.stiffness[p], at.curvature);
        }
    }
  });
}

}  // namespace

template <int D>
SampleIn<D> make_sample(const PackingIn<D>& start, const ContactParameters& contact,
                        const IntegrationParameters& integration, const KernelIn<D>& kernel) {
  Problems problems;
  check_parameters(problems, start, contact, integration);
  check_packing(problems, start, contact);
  check_thickness(problems, start.domain);
  SampleIn<D> s;
  each_part(s, [&](const auto& part) { part.check(problems, start, contact, integration); });
  problems.raise();

  s.start = start;
  s.contact = contact;
  s.integration = integration;
  s.kernel = &kernel;
  s.coefficients = CoefficientTable(start.materials, start.grains.material, contact);
  for (auto& [a, b] : s.contact.glued_pairs)
    if (b < a) std::swap(a, b);
  std::sort(s.contact.glued_pairs.begin(), s.contact.glued_pairs.end());
  apply_friction(s, std::nullopt);
  s.drag = integration.drag;
  s.domain = start.domain;
  for (int side = 0; side < sides_in<D>;
       ++side)  // periodic sides have no walls; their `wall` entries are the edges of the cell
    s.domain.wall[side] = {s.domain.wall[side].present && !s.domain.is_periodic(side), s.domain.wall[side].position};
  each_part(s, [&](auto& part) { part.make(s, start); });
  place_disks(s);
  each_part(s, [&](auto& part) { part.set_up(s); });
  check_cell(s);
  s.laws = choose_laws(contact, 0.0, 0.0);
  rebuild_list(s);
  choose_step(s);
  glue_touching_pairs(s);
  each_part(s, [&](auto& part) { part.recall(s); });
  recall_contacts(s);
  s.laws =
      choose_laws(contact, 0.0, (1.0 - integrator_of(s).lead) * s.dt);  // the springs do not move before the first step
  compute_forces(s);
  sum_edge_forces(s);
  s.laws = laws_between_steps(s);
  return s;
}

template Sample make_sample(const Packing&, const ContactParameters&, const IntegrationParameters&, const Kernel&);
template SampleIn<3> make_sample(const PackingIn<3>&, const ContactParameters&, const IntegrationParameters&,
                                 const KernelIn<3>&);

}  // namespace arenite::dem
