#include "grains/dem/setup.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/error.hpp"
#include "core/problems.hpp"
#include "grains/dem/bodies/bodies.hpp"
#include "grains/dem/boundaries/boundaries.hpp"
#include "grains/dem/forces.hpp"
#include "grains/dem/neighbours.hpp"
#include "grains/dem/walls.hpp"

namespace arenite::dem {
namespace {

bool positive(double v) { return std::isfinite(v) && v > 0; }
bool not_negative(double v) { return std::isfinite(v) && v >= 0; }

void check_parameters(Problems& problems, const Packing& start, const ContactParameters& contact, const IntegrationParameters& integration) {
  problems.unless(contact.restitution > 0 && contact.restitution <= 1, "restitution {} must be above 0 and at most 1", contact.restitution);
  problems.unless(not_negative(contact.friction), "friction {} must be a number >= 0", contact.friction);
  problems.unless(not_negative(contact.wall_friction.value_or(0)), "wall friction {} must be a number >= 0", contact.wall_friction.value_or(0));
  problems.unless(not_negative(contact.normal_damping.value_or(0)), "normal damping {} N s/m must be >= 0", contact.normal_damping.value_or(0));
  problems.unless(not_negative(contact.sliding_viscosity.value_or(0)), "sliding viscosity {} N s/m must be >= 0", contact.sliding_viscosity.value_or(0));
  problems.unless(positive(contact.tangential_stiffness_ratio), "tangential stiffness ratio {} must be above 0", contact.tangential_stiffness_ratio);
  problems.unless(not_negative(contact.surface_energy), "surface energy {} N/m must be >= 0", contact.surface_energy);
  problems.unless(positive(integration.safety), "safety {} must be above 0", integration.safety);
  problems.unless(not_negative(integration.drag), "drag {} 1/s must be >= 0", integration.drag);
  problems.unless(integration.threads >= 1, "threads {} must be 1 or more", integration.threads);
  const auto n = static_cast<std::int32_t>(start.grains.size());
  for (const Bond& bond : start.bonds)
    problems.unless(bond.i >= 0 && bond.i < bond.j && bond.j < n && bond.length > 0, "bond ({}, {}) must join two of the {} grains, the lower first", bond.i,
                    bond.j, n);
  for (const auto& [a, b] : contact.glued_pairs)
    problems.unless(a >= 0 && b >= 0 && a < n && b < n && a != b, "glued pair ({}, {}) must name two of the {} grains", a, b, n);
}

/// What a law of E and nu needs of a material.
void check_moduli(Problems& problems, const Material& m, const NormalLaw& law) {
  const bool both = m.youngs_modulus && m.poisson;
  problems.unless(both, "material \"{}\" has no {}, which the normal law \"{}\" needs", m.name, m.youngs_modulus ? "poisson" : "youngs_modulus", law.word());
  problems.unless(!m.youngs_modulus || positive(*m.youngs_modulus), "youngs_modulus {} Pa of material \"{}\" must be above 0", m.youngs_modulus.value_or(0),
                  m.name);
  const double nu = m.poisson.value_or(0);
  problems.unless(nu >= 0 && nu <= 0.5, "poisson {} of material \"{}\" must lie between 0 and 0.5", nu, m.name);
}

void check_packing(Problems& problems, const Packing& start, const ContactParameters& contact) {
  const Domain& domain = start.domain;
  problems.unless(start.grains.size() > 0, "the packing has no grains");
  problems.unless(positive(domain.width()) && positive(domain.height()), "the container must have a width and a height above 0");
  problems.unless(positive(domain.thickness), "thickness {} m must be above 0", domain.thickness);
  for (const auto& m : start.materials) {
    problems.unless(positive(m.density), "density {} kg/m^3 of material \"{}\" must be above 0", m.density, m.name);
    if (contact.takes_moduli()) check_moduli(problems, m, contact.normal);
    else problems.unless(positive(m.stiffness), "stiffness {} N/m of material \"{}\" must be above 0", m.stiffness, m.name);
  }
  check_boundaries(problems, domain);
  const Grains& g = start.grains;
  for (std::size_t k = 0; k < g.size(); ++k) {
    problems.unless(positive(g.radius[k]), "radius {} m of grain {} must be above 0", g.radius[k], g.id[k]);
    problems.unless(std::isfinite(g.position[k].x + g.position[k].y + g.velocity[k].x + g.velocity[k].y + g.omega[k]),
                    "grain {} has a coordinate or velocity that is not a number", g.id[k]);
    problems.unless(g.material[k] >= 0 && static_cast<std::size_t>(g.material[k]) < start.materials.size(),
                    "material {} of grain {} is not among the {} materials", g.material[k], g.id[k], start.materials.size());
    bool inside = true;
    for (int side = 0; side < sides; ++side) inside = inside && (!domain.wall[side].present || domain.depth(side, g.position[k]) >= 0);
    problems.unless(inside, "the centre of grain {} is outside of the container", g.id[k]);
  }
}

void place_disks(Sample& s) {
  const Grains& g = s.start.grains;
  s.count = g.size();
  s.record.resize(s.count);
  const CellMotion<2> cell = cell_motion(s.domain);
  for (auto* a : motion_arrays(s)) a->assign(s.count, 0.0);
  for (std::size_t k = 0; k < s.count; ++k) {
    const double r = g.radius[k];
    s.omega[k] = s.integration.rotations ? g.omega[k] : 0.0;
    s.record[k] = {g.position[k], g.velocity[k], s.omega[k], r, 0, g.material[k], static_cast<std::int32_t>(k)};
    s.record[k].mass = own_mass(s, static_cast<std::int32_t>(k));
    s.velocity.put(k, g.velocity[k] - cell.at(g.position[k]));
    s.angle[k] = g.angle[k];
    s.largest_radius = std::max(s.largest_radius, r);
  }
  const std::vector<double>& radius = s.part.empty() ? g.radius : s.given.radius;
  s.skin = 0.15 * std::accumulate(radius.begin(), radius.end(), 0.0) / static_cast<double>(radius.size());
}

void check_cell(const Sample& s) {
  Problems problems;
  const double needed = std::max(2.0 * reach_of(s), cell_for_bodies(s));
  problems.unless(!s.domain.periodic[0] || s.domain.width() >= needed, "a periodic cell {} m wide is too narrow for its grains; {} m would do",
                  s.domain.width(), needed);
  problems.unless(!s.domain.periodic[1] || s.domain.height() >= needed, "a periodic cell {} m high is too low for its grains; {} m would do", s.domain.height(),
                  needed);
  problems.raise();
}

void choose_step(Sample& s) {
  const StepBounds bounds = step_bounds(s);
  const auto& asked = s.integration.time_step;
  s.dt = asked.value_or(std::min(s.integration.safety * shortest_contact_time(s), bounds.largest()));
  if (!positive(s.dt)) throw InputError(fmt::format("time step {} s must be above 0", s.dt));
  if (s.dt > bounds.largest())
    throw InputError(
        fmt::format("integration.time_step of {:.4g} s is too long for this packing: {} would make it unstable; "
                    "{:.4g} s would do, or leave the key out",
                    s.dt, bounds.damping < bounds.stiffness ? "damping (dashpots and drag)" : "the stiffness of its contacts", 0.999 * bounds.largest()));
  s.dt_at_start = s.dt;
}

/// What the contacts of the packing left in the memories of the laws, so that a stage goes on with the friction that it found.
void recall_contacts(Sample& s) {
  if (!remembers(s.laws)) return;
  const Contacts& c = s.start.contacts;
  std::vector<std::pair<std::uint64_t, std::size_t>> met;
  for (std::size_t q = 0; q < c.size(); ++q) met.emplace_back(pair_key(c.i[q], c.j[q]), q);
  std::sort(met.begin(), met.end());
  s.laws.visit([&]<class N, class A, class F>(const N& normal, const A& adhesion, const F& friction) {
    for (std::size_t p = 0; p < s.list.size(); ++p) {
      const std::int32_t j = s.list.j[p];
      const std::uint64_t key = pair_key(grain_of(s, s.record[s.list.i[p]].grain), j < 0 ? j : grain_of(s, s.record[s.list.owner[p]].grain));
      auto found = std::lower_bound(met.begin(), met.end(), std::pair{key, std::size_t{0}});
      while (found != met.end() && found->first == key && !is_of_slot(s, c, found->second, p)) ++found;
      if (found == met.end() || found->first != key) continue;
      const std::size_t q = found->second;
      const double k = s.list.stiffness[p], kt = sliding_stiffness(s, normal, p, slot_kinematics(s, p));
      if constexpr (F::remembers)
        if (c.ft[q] != 0 && std::isfinite(c.ft[q]) && kt > 0) s.list.memory[p] = friction.recall(c.ft[q], kt);
      if constexpr (N::remembers)
        if (const Kinematics<2> at = slot_kinematics(s, p); at.overlap > 0 && std::isfinite(c.fn[q]))
          s.list.normal_memory[p] = normal.recall(c.fn[q] + adhesion.attraction(at.overlap, s.list.strength[p]) + pull_of(s, p), at.overlap, k, at.curvature);
    }
  });
}

/// Bonds of the packing go on where the law has any.
void recall_bonds(Sample& s) {
  if (s.contact.has_bonds()) s.bonds = s.start.bonds;
  s.start.bonds.clear();
}

/// The periodic sides have no walls; their `wall` entries are the edges of the cell.
void clear_periodic_walls(Domain& domain) {
  for (int side = 0; side < sides; ++side) {
    Wall& wall = domain.wall[side];
    wall = {wall.present && !domain.is_periodic(side), wall.position};
  }
}

}  // namespace

ContactLaws choose_laws(const ContactParameters& contact, double lead, double lag) {
  return {contact.normal,
          contact.adhesion,
          contact.friction_law,
          lead,
          lag,
          contact.tangential_stiffness_ratio,
          contact.friction_cap == FrictionCap::raised_by_adhesion ? 1.0 : -1.0,
          contact.normal_damping.has_value(),
          contact.normal_damping.has_value() || contact.sliding_viscosity.has_value()};
}

ContactLaws laws_between_steps(const Sample& s) {
  const double lead = integrator_of(s).lead;
  return choose_laws(s.contact, lead * s.dt, (1.0 - lead) * s.dt);
}

double time_of(const Sample& s) { return s.time_before + static_cast<double>(s.step - s.steps_before) * s.dt; }

void change_step(Sample& s, double dt) {
  s.time_before = time_of(s);
  s.steps_before = s.step;
  s.dt = dt;
  s.laws = laws_between_steps(s);
}

void allow_step(Sample& s, const char* what) {
  const double largest = step_bounds(s).largest();
  if (!(s.dt > largest)) return;
  if (s.integration.time_step)
    throw InputError(
        fmt::format("integration.time_step of {:.4g} s is beyond what this sample allows with {}; {:.4g} s would do", s.dt, what, 0.999 * largest));
  change_step(s, 0.999 * largest);
}

void apply_friction(Sample& s, std::optional<double> override_mu) {
  s.friction = override_mu.value_or(s.contact.friction);
  s.wall_friction = override_mu.value_or(s.contact.wall_friction.value_or(s.contact.friction));
}

Sample make_sample(const Packing& start, const ContactParameters& contact, const IntegrationParameters& integration) {
  Problems problems;
  check_parameters(problems, start, contact, integration);
  check_packing(problems, start, contact);
  check_shapes(problems, start, contact, integration);
  problems.raise();

  Sample s;
  s.start = disks_of(start);
  s.contact = contact;
  s.integration = integration;
  s.kernel = &find_kernel(integration.kernel);
  s.coefficients = CoefficientTable(start.materials, start.grains, contact);
  for (auto& [a, b] : s.contact.glued_pairs)
    if (b < a) std::swap(a, b);
  std::sort(s.contact.glued_pairs.begin(), s.contact.glued_pairs.end());
  apply_friction(s, std::nullopt);
  s.drag = integration.drag;
  s.domain = start.domain;
  clear_periodic_walls(s.domain);
  s.element = elements_of(s.domain);
  s.boundary.resize(s.domain.boundaries.size());
  make_bodies(s, start.grains);
  place_disks(s);
  recall_bonds(s);
  set_up_cohesion(s);
  check_cell(s);
  s.laws = choose_laws(contact, 0.0, 0.0);
  tune_servo(s);
  rebuild_list(s);
  choose_step(s);
  bond_touching_pairs(s);
  recall_cohesion(s);
  recall_contacts(s);
  s.laws = choose_laws(contact, 0.0, (1.0 - integrator_of(s).lead) * s.dt);  // the springs do not move before the first step
  compute_forces(s);
  sum_edge_forces(s);
  s.laws = laws_between_steps(s);
  return s;
}

}  // namespace arenite::dem
