#include "grains/dem/setup.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "grains/dem/bodies/bodies.hpp"
#include "grains/dem/bonds.hpp"
#include "grains/dem/neighbours.hpp"
#include "grains/dem/walls.hpp"

namespace arenite::dem {
namespace {

/// Hertz contacts stiffen without end; bounds hold for h/R* up to this, or the largest there is.
double reference_overlap(const Sample& s) {
  double largest = 0.02;
  for (std::size_t p = 0; p < s.list.size(); ++p)
    if (const Kinematics<2> c = slot_kinematics(s, p); c.overlap > 0) largest = std::max(largest, c.overlap * c.curvature);
  return largest;
}

double tangent_stiffness(const Sample& s, double overlap, double stiffness) {
  return s.laws.normal.visit([&](const auto& law) { return law.tangent(overlap, stiffness, 1.0); });
}

/// Share of gamma_s with which sliding is braked where the dashpot along the normal has this share of alpha_n.
double viscosity_factor(const Sample& s, double damping_factor) { return s.contact.takes_moduli() && !s.laws.constant_viscosity ? damping_factor : 1.0; }

/// Steepest slope of friction in the slip where its spring has this stiffness, N/m.
double sliding_slope(const Sample& s, double spring) {
  return s.laws.friction.visit([&](const auto& law) { return law.tangent(spring); });
}

double sliding_damping(const Sample& s, double viscosity) {
  if (!(std::max(s.contact.friction, s.contact.wall_friction.value_or(0)) > 0)) return 0;
  return s.laws.friction.visit([&](const auto& law) { return law.damping(viscosity); });
}

/// Steepest slopes of the forces of a contact, along n, along t, and of rolling resistance over r^2: in its ways, N/m, or in its velocities, N s/m.
struct Slopes {
  double normal = 0, sliding = 0, rolling = 0;
};

/// Those of two equal grains at a reference overlap. Not every law's spring of friction softens with the overlap as the normal one does.
struct ContactSlopes {
  Slopes springs, dashpots;
};

ContactSlopes slopes_between_equals(const Sample& s, const DiskRecord& d, double overlap) {
  const Coefficients c = s.coefficients.pair(d, d, false);
  const double shear = s.coefficients.largest_shear();
  ContactSlopes slopes;
  s.laws.normal.visit([&](const auto& law) {
    const double factor = s.laws.constant_damping ? 1.0 : law.damping_factor(overlap, 1.0);
    slopes.springs = {law.tangent(overlap, c.stiffness, 1.0), sliding_slope(s, sliding_stiffness(s.laws, law, overlap, c.stiffness, 1.0, shear))};
    slopes.dashpots = {factor * c.damping, sliding_damping(s, viscosity_factor(s, factor) * c.viscosity)};
  });
  if (!s.integration.rotations) return slopes;
  const double area = d.radius * d.radius;
  s.contact.rolling.visit([&](const auto& law) {
    const double stiffness = law.stiffness(c.stiffness, 0.5 * d.radius);
    slopes.springs.rolling = stiffness / area;
    slopes.dashpots.rolling = law.damping(c.damping, 0.5 * d.radius, stiffness, 0.5 * inertia(d)) / area;
  });
  return slopes;
}

/// Six contacts with equals, the triangular lattice: translation reaches omega^2 = 6 k/m, rotation in one sense 2 z k_t r^2/I = 24 k_t/m; dashpots
/// alike.
Rates lattice_rates(const Sample& s, const DiskRecord& d, double overlap) {
  const double turning = s.integration.rotations ? 24.0 : 6.0;
  const auto rate = [&](const Slopes& of) { return std::max(6.0 * of.normal, turning * of.sliding + 24.0 * of.rolling) / d.mass; };
  const ContactSlopes slopes = slopes_between_equals(s, d, overlap);
  return {rate(slopes.springs), rate(slopes.dashpots)};
}

/// The same for a body in a crowd of its like. Translation and rotation may act together.
Rates crowded_rates(const Sample& s, const Body& b, double overlap) {
  const DiskRecord& d = s.record[s.part_disk[b.first]];
  const Crowd crowd = crowd_around(s, b);
  const double turning = s.integration.rotations ? 2.0 / b.inertia() : 0.0, area = crowd.contacts * d.radius * d.radius;
  const auto rate = [&](const Slopes& of) {
    return crowd.contacts * (of.normal + of.sliding) / b.mass +
           turning * (of.normal * crowd.normal_levers + of.sliding * crowd.tangential_levers + of.rolling * area);
  };
  const ContactSlopes slopes = slopes_between_equals(s, d, overlap);
  return {rate(slopes.springs), rate(slopes.dashpots)};
}

/// Springs or dashpots of one contact along n and t, and the movers that they join; a wall is the one behind the last.
struct Pull {
  std::size_t i, j;
  Kinematics<2> at;
  Levers levers;
  double along_n, along_t;
};

/// Largest eigenvalue of M^-1 sum over contacts of (along_n n n + along_t t t), rotations included, by power iteration. It starts from all grains
/// turning alike, which in a dense packing is close to the fastest mode.
double largest_rate(const Sample& s, const std::vector<Pull>& pulls) {
  std::vector<Mover> movers(s.count + s.body.size());  // a disk of a body counts for nothing
  each_mover(s, [&](std::size_t k) { movers[k] = mover_at(s, k); });
  const std::size_t n = movers.size();
  std::vector<Motion<2>> v(n + 1), w;
  for (std::size_t k = 0; k < n; ++k) v[k] = {{k % 2 == 0 ? 0.3 : -0.2, k % 3 == 0 ? -0.25 : 0.15}, s.integration.rotations ? 1.0 / movers[k].size : 0.0};
  double rate = 0;
  for (int round = 0; round < 100; ++round) {
    double size = 0;  // v M v, then v scaled to 1
    for (std::size_t k = 0; k < n; ++k) size += movers[k].mass * dot(v[k].velocity, v[k].velocity) + movers[k].inertia * v[k].omega * v[k].omega;
    if (!(size > 0)) return 0;
    for (Motion<2>& q : v) q = {q.velocity / std::sqrt(size), q.omega / std::sqrt(size)};
    w.assign(v.size(), {});
    rate = 0;
    for (const Pull& p : pulls) {
      const Vec2 normal = p.at.normal, t = perpendicular(normal);
      const Motion<2>&a = v[p.i], &b = v[p.j];
      const Vec2 u = a.velocity + a.omega * perpendicular(p.levers.i) - b.velocity - b.omega * perpendicular(p.levers.j);
      const double slide = -a.omega * p.at.arm_i - b.omega * p.at.arm_j;
      const double fn = p.along_n * dot(u, normal), ft = p.along_t * (dot(u, t) + slide);
      rate += fn * dot(u, normal) + ft * (dot(u, t) + slide);
      const Vec2 f = fn * normal + ft * t;
      w[p.i].velocity += f;
      w[p.i].omega -= p.at.arm_i * ft;
      w[p.i].omega += cross(p.levers.i, f);
      w[p.j].velocity -= f;
      w[p.j].omega -= p.at.arm_j * ft;
      w[p.j].omega -= cross(p.levers.j, f);
    }
    for (std::size_t k = 0; k < n; ++k) v[k] = {w[k].velocity / movers[k].mass, s.integration.rotations ? w[k].omega / movers[k].inertia : 0.0};
  }
  return rate;
}

/// Rates of the contacts that there are; power iteration comes from below, hence the 5 %.
Rates network_rates(const Sample& s) {
  std::vector<Pull> springs, dashpots;
  for (std::size_t p = 0; p < s.list.size(); ++p) {
    const Kinematics<2> c = slot_kinematics(s, p);
    if (!(c.overlap > 0)) continue;
    const std::size_t wall = s.count + s.body.size();
    Pull pull{moving(s, s.list.i[p]), s.list.j[p] < 0 ? wall : moving(s, s.list.owner[p]), c, levers_of(s, p), 0, 0};
    s.laws.normal.visit([&](const auto& law) {
      pull.along_n = law.tangent(c.overlap, s.list.stiffness[p], c.curvature);
      pull.along_t = sliding_slope(s, sliding_stiffness(s, law, p, c));
      springs.push_back(pull);
      const double factor = s.laws.constant_damping ? 1.0 : law.damping_factor(c.overlap, c.curvature);
      pull.along_n = factor * s.list.damping[p];
      pull.along_t = sliding_damping(s, viscosity_factor(s, factor) * s.list.viscosity[p]);
      dashpots.push_back(pull);
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
