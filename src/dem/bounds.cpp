#include "dem/bounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <tuple>

namespace arenite::dem {

namespace {

/// Hertz contacts stiffen without end; their bounds are taken at this h/R* at least.
constexpr double hertz_overlap = 0.02;

double tangent_stiffness(const Sample& s, double stiffness) {
  return std::visit([&](const auto& law) { return law.tangent(hertz_overlap, stiffness, 1.0); }, s.laws.normal);
}

double damping_factor(const Sample& s) {
  return std::visit([](const auto& law) { return law.damping_factor(hertz_overlap, 1.0); }, s.laws.normal);
}

struct Rates {
  double frequency_squared = 0, damping = 0;
};

/// Six contacts with equals, the triangular lattice: translation reaches omega^2 = 6 k/m, rotation in one sense
/// 2 z k_t r^2/I = 24 k_t/m; dashpots alike.
Rates lattice_rates(const Sample& s, const DiskRecord& d) {
  const Coefficients c = s.coefficients.pair(d.material, d.material, d.mass, d.mass, d.radius, d.radius, false);
  const double k = tangent_stiffness(s, c.stiffness);
  const double turning = s.integration.rotations ? 24.0 : 6.0;
  const double ratio = std::visit([](const auto& law) { return law.stiffness_ratio(); }, s.laws.friction);
  const bool slides = s.contact.friction_law != FrictionLaw::none && std::max(s.friction, s.wall_friction) > 0;
  const double normal_damping = 6.0 * damping_factor(s) * c.damping;
  return {std::max(6.0 * k, turning * ratio * k) / d.mass,
          std::max(normal_damping, slides ? turning * c.viscosity : 0.0) / d.mass};
}

}  // namespace

double shortest_contact_time(const Sample& s) {
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < s.count; ++k) {
    const auto& d = s.record[k];
    const double pair = 0.5 * d.mass / tangent_stiffness(s, s.coefficients.pair_stiffness(d.material, d.material));
    const double wall = d.mass / tangent_stiffness(s, s.coefficients.wall_stiffness(d.material));
    shortest = std::min(shortest, std::numbers::pi * std::sqrt(std::min(pair, wall)));
  }
  return shortest;
}

StepBounds step_bounds(const Sample& s) {
  Rates r;
  for (std::size_t k = 0; k < s.count; ++k) {
    const Rates grain = lattice_rates(s, s.record[k]);
    r.frequency_squared = std::max(r.frequency_squared, grain.frequency_squared);
    r.damping = std::max(r.damping, grain.damping);
  }
  const double omega = std::sqrt(r.frequency_squared), lambda = r.damping + s.drag;
  constexpr double margin = 0.9;
  StepBounds bounds;
  if (s.integration.integrator == IntegratorKind::gear5) {
    bounds.stiffness = margin * 0.4 / omega;
    bounds.damping = margin * 0.164 / lambda;
  } else {
    // The growing mode flips sign every step: (omega dt)^2/4 + q lambda dt = 1 with q = 1 where forces see the velocity
    // at the end of the step and q = 1/2 where they see that of its middle.
    const double q = s.integration.integrator == IntegratorKind::velocity_verlet ? lambda : 0.5 * lambda;
    bounds.stiffness = margin * 2.0 / omega;
    bounds.damping = margin * 2.0 / (q + std::sqrt(q * q + omega * omega));
  }
  return bounds;
}

}  // namespace arenite::dem
