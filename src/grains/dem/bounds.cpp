#include "grains/dem/setup.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "grains/dem/bodies/bodies.hpp"
#include "grains/dem/bonds.hpp"
#include "grains/dem/forces.hpp"
#include "grains/dem/integrators/integrators.hpp"
#include "grains/dem/neighbours.hpp"
#include "grains/dem/walls.hpp"

namespace arenite::dem {
namespace {

/// Hertz contacts stiffen without end; bounds hold for h/R* up to this, or the largest there is.
double reference_overlap(const Sample& s) {
  double largest = 0.02;
  for (std::size_t p = 0; p < s.list.size(); ++p)
    if (const Kinematics c = slot_kinematics(s, p); c.overlap > 0) largest = std::max(largest, c.overlap * c.curvature);
  return largest;
}

double tangent_stiffness(const Sample& s, double overlap, double stiffness) {
  return s.laws.normal.visit([&](const auto& law) { return law.tangent(overlap, stiffness, 1.0); });
}

double damping_factor(const Sample& s, double overlap) {
  return s.laws.constant_damping ? 1.0 : s.laws.normal.visit([&](const auto& law) { return law.damping_factor(overlap, 1.0); });
}

/// Share of gamma_s with which sliding is braked where the dashpot along the normal has this share of alpha_n.
double viscosity_factor(const Sample& s, double damping_factor) { return s.contact.takes_moduli() && !s.laws.constant_viscosity ? damping_factor : 1.0; }

/// Steepest slope of friction in the slip where its spring has this stiffness, N/m.
double sliding_slope(const Sample& s, double spring) {
  return s.laws.friction.visit([&](const auto& law) { return law.tangent(spring); });
}

/// The same of a contact at a reference overlap. Not every law's spring of friction softens with the overlap as the normal one does.
double sliding_slope(const Sample& s, double overlap, double stiffness) {
  const double shear = s.coefficients.largest_shear();
  return sliding_slope(s, s.laws.normal.visit([&](const auto& law) { return sliding_stiffness(s.laws, law, overlap, stiffness, 1.0, shear); }));
}

double sliding_damping(const Sample& s, double viscosity) {
  if (!(std::max(s.contact.friction, s.contact.wall_friction.value_or(0)) > 0)) return 0;
  return s.laws.friction.visit([&](const auto& law) { return law.damping(viscosity); });
}

Coefficients coefficients_of_equals(const Sample& s, const DiskRecord& d) { return s.coefficients.pair(d, d, false); }

/// Rolling resistance of two equal grains, over r^2.
struct Rolling {
  double stiffness, damping;
};

Rolling rolling_of(const Sample& s, const DiskRecord& d, const Coefficients& c) {
  if (!s.integration.rotations) return {0, 0};
  const double area = d.radius * d.radius;
  return s.contact.rolling.visit([&](const auto& law) {
    const double stiffness = law.stiffness(c.stiffness, 0.5 * d.radius);
    return Rolling{stiffness / area, law.damping(c.damping, 0.5 * d.radius, stiffness, 0.5 * inertia(d)) / area};
  });
}

/// Six contacts with equals, the triangular lattice: translation reaches omega^2 = 6 k/m, rotation in one sense 2 z k_t r^2/I = 24 k_t/m; dashpots
/// alike.
Rates lattice_rates(const Sample& s, const DiskRecord& d, double overlap) {
  const Coefficients c = coefficients_of_equals(s, d);
  const double k = tangent_stiffness(s, overlap, c.stiffness);
  const double turning = s.integration.rotations ? 24.0 : 6.0;
  const double factor = damping_factor(s, overlap), normal_damping = 6.0 * factor * c.damping;
  const Rolling rolling = rolling_of(s, d, c);
  return {std::max(6.0 * k, turning * sliding_slope(s, overlap, c.stiffness) + 24.0 * rolling.stiffness) / d.mass,
          std::max(normal_damping, turning * sliding_damping(s, viscosity_factor(s, factor) * c.viscosity) + 24.0 * rolling.damping) / d.mass};
}

/// The same for a body in a crowd of its like. Translation and rotation may act together.
Rates crowded_rates(const Sample& s, const Body& b, double overlap) {
  const DiskRecord& d = s.record[s.part_disk[b.first]];
  const Coefficients c = coefficients_of_equals(s, d);
  const double k = tangent_stiffness(s, overlap, c.stiffness), factor = damping_factor(s, overlap), normal_damping = factor * c.damping;
  const double along = sliding_slope(s, overlap, c.stiffness), sliding = sliding_damping(s, viscosity_factor(s, factor) * c.viscosity);
  const Crowd crowd = crowd_around(s, b);
  const Rolling rolling = rolling_of(s, d, c);
  const double turning = s.integration.rotations ? 2.0 / b.inertia() : 0.0, area = crowd.contacts * d.radius * d.radius;
  const auto rate = [&](double normal, double tangential, double roll) {
    return crowd.contacts * (normal + tangential) / b.mass + turning * (normal * crowd.normal_levers + tangential * crowd.tangential_levers + roll * area);
  };
  return {rate(k, along, rolling.stiffness), rate(normal_damping, sliding, rolling.damping)};
}

/// Rates of one contact's springs or dashpots along n and t.
struct Pull {
  std::size_t slot;
  Kinematics at;
  double along_n, along_t;
};

/// Largest eigenvalue of M^-1 sum over contacts of (along_n n n + along_t t t), rotations included, by power iteration. It starts from all grains
/// turning alike, which in a dense packing is close to the fastest mode.
double largest_rate(const Sample& s, const std::vector<Pull>& pulls) {
  std::vector<Mover> movers(s.count + s.body.size());  // a disk of a body counts for nothing
  each_mover(s, [&](std::size_t k) { movers[k] = mover_at(s, k); });
  std::vector<Motion> v(movers.size()), w;
  for (std::size_t k = 0; k < v.size(); ++k)
    v[k] = {{k % 2 == 0 ? 0.3 : -0.2, k % 3 == 0 ? -0.25 : 0.15}, s.integration.rotations ? 1.0 / movers[k].size : 0.0};
  double rate = 0;
  for (int round = 0; round < 100; ++round) {
    double size = 0;  // v M v, then v scaled to 1
    for (std::size_t k = 0; k < v.size(); ++k) size += movers[k].mass * dot(v[k].velocity, v[k].velocity) + movers[k].inertia * v[k].omega * v[k].omega;
    if (!(size > 0)) return 0;
    for (Motion& q : v) q = {q.velocity / std::sqrt(size), q.omega / std::sqrt(size)};
    w.assign(v.size(), {});
    rate = 0;
    for (const Pull& p : pulls) {
      const std::size_t i = moving(s, s.list.i[p.slot]);
      const bool wall = s.list.j[p.slot] < 0;
      const std::size_t j = wall ? i : moving(s, s.list.owner[p.slot]);
      const Vec2 normal = p.at.normal, t = perpendicular(normal);
      Vec2 u = v[i].velocity;
      double slide = -v[i].omega * p.at.arm_i;
      if (!s.part.empty()) u += v[i].omega * perpendicular(own_lever(s, p.slot));
      if (!wall) {
        u -= v[j].velocity;
        slide -= v[j].omega * p.at.arm_j;
        if (!s.part.empty()) u -= v[j].omega * perpendicular(partner_lever(s, p.slot));
      }
      const double fn = p.along_n * dot(u, normal), ft = p.along_t * (dot(u, t) + slide);
      rate += fn * dot(u, normal) + ft * (dot(u, t) + slide);
      const Vec2 f = fn * normal + ft * t;
      w[i].velocity += f;
      w[i].omega -= p.at.arm_i * ft;
      if (!s.part.empty()) w[i].omega += cross(own_lever(s, p.slot), f);
      if (wall) continue;
      w[j].velocity -= f;
      w[j].omega -= p.at.arm_j * ft;
      if (!s.part.empty()) w[j].omega -= cross(partner_lever(s, p.slot), f);
    }
    for (std::size_t k = 0; k < v.size(); ++k) v[k] = {w[k].velocity / movers[k].mass, s.integration.rotations ? w[k].omega / movers[k].inertia : 0.0};
  }
  return rate;
}

/// Rates of the contacts that there are; power iteration comes from below, hence the 5 %.
Rates network_rates(const Sample& s) {
  std::vector<Pull> springs, dashpots;
  for (std::size_t p = 0; p < s.list.size(); ++p) {
    const Kinematics c = slot_kinematics(s, p);
    if (!(c.overlap > 0)) continue;
    s.laws.normal.visit([&](const auto& law) {
      const double k = law.tangent(c.overlap, s.list.stiffness[p], c.curvature);
      springs.push_back({p, c, k, sliding_slope(s, sliding_stiffness(s, law, p, c))});
      const double factor = s.laws.constant_damping ? 1.0 : law.damping_factor(c.overlap, c.curvature);
      dashpots.push_back({p, c, factor * s.list.damping[p], sliding_damping(s, viscosity_factor(s, factor) * s.list.viscosity[p])});
    });
  }
  return {1.05 * largest_rate(s, springs), 1.05 * largest_rate(s, dashpots)};
}

/// What pulls of cohesion add to the squared frequency of the lightest grain with six neighbours, 1/s^2.
double cohesion_rate(const Sample& s) {
  double lightest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < s.count; ++k) lightest = std::min(lightest, s.record[k].mass);
  return 6.0 * s.cohesion.steepest / lightest;
}

}  // namespace

double shortest_contact_time(const Sample& s) {
  const double overlap = reference_overlap(s), pull = s.cohesion.steepest;
  double shortest = shortest_bond_time(s);
  for (std::size_t k = 0; k < s.count; ++k) {
    const auto& d = s.record[k];
    if (is_part(s, k)) continue;
    const double pair = 0.5 * d.mass / (pull + tangent_stiffness(s, overlap, s.coefficients.pair_stiffness(d, d)));
    const double wall = d.mass / tangent_stiffness(s, overlap, s.coefficients.wall_stiffness(d));
    shortest = std::min(shortest, std::numbers::pi * std::sqrt(std::min(pair, wall)));
  }
  for (const Body& b : s.body) {
    const auto& d = s.record[s.part_disk[b.first]];
    const double pair = 0.5 / tangent_stiffness(s, overlap, s.coefficients.pair_stiffness(d, d));
    const double wall = 1 / tangent_stiffness(s, overlap, s.coefficients.wall_stiffness(d));
    shortest = std::min(shortest, std::numbers::pi * std::sqrt(lightest_mass(s, b) * std::min(pair, wall)));
  }
  return shortest;
}

StepBounds step_bounds(const Sample& s) {
  Rates r = network_rates(s);
  const double overlap = reference_overlap(s);
  each_mover(s, [&](std::size_t k) {
    const Rates grain = k < s.count ? lattice_rates(s, s.record[k], overlap) : crowded_rates(s, s.body[k - s.count], overlap);
    r.frequency_squared = std::max(r.frequency_squared, grain.frequency_squared);
    r.damping = std::max(r.damping, grain.damping);
  });
  const Rates bonds = bond_rates(s);
  r.frequency_squared += bonds.frequency_squared + cohesion_rate(s);
  r.damping += bonds.damping;
  const double omega = std::sqrt(r.frequency_squared), lambda = r.damping + s.drag;
  constexpr double margin = 0.9;
  StepBounds bounds;
  const Integrator& scheme = integrator_of(s);
  const double p = scheme.p, q = scheme.q;
  bounds.stiffness = margin * scheme.undamped / omega;
  bounds.damping = margin * 2.0 / (q * lambda + std::sqrt(q * q * lambda * lambda + 4 * p * omega * omega));
  return bounds;
}

}  // namespace arenite::dem
