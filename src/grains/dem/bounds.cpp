#include "grains/dem/bounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "grains/dem/forces.hpp"
#include "grains/dem/movers.hpp"

namespace arenite::dem {
namespace {

template <int D> double reference_overlap(const SampleIn<D>& s) {
  double largest = reference_share;
  for (std::size_t p = 0; p < s.list.size(); ++p)
    if (const Kinematics<D> c = slot_kinematics(s, p); c.overlap > 0)
      largest = std::max(largest, c.overlap * c.curvature);
  return largest;
}

template <int D> double tangent_stiffness(const SampleIn<D>& s, double overlap, double stiffness) {
  return s.laws.normal.visit([&](const auto& law) { return law.tangent(overlap, stiffness, 1.0); });
}

/// Share of gamma_s with which sliding is braked where the dashpot along the normal has this share of alpha_n.
template <int D> double viscosity_factor(const SampleIn<D>& s, double damping_factor) {
  return s.contact.takes_moduli() && !s.laws.constant_viscosity ? damping_factor : 1.0;
}

/// Steepest slope of friction in the slip where its spring has this stiffness, N/m.
template <int D> double sliding_slope(const SampleIn<D>& s, double spring) {
  return s.laws.friction.visit([&](const auto& law) { return law.tangent(spring); });
}

template <int D> double sliding_damping(const SampleIn<D>& s, double viscosity) {
  if (!(std::max(s.contact.friction, s.contact.wall_friction.value_or(0)) > 0)) return 0;
  return s.laws.friction.visit([&](const auto& law) { return law.damping(viscosity); });
}

/// Of two equal grains at a reference overlap. Not every law's spring of friction softens with the overlap as the
/// normal one does.
template <int D> ContactSlopes slopes_between_equals(const SampleIn<D>& s, const GrainRecord<D>& d, double overlap) {
  const Coefficients c = s.coefficients.pair(d, d, false);
  const double shear = s.coefficients.largest_shear();
  ContactSlopes slopes;
  s.laws.normal.visit([&](const auto& law) {
    const double factor = s.laws.constant_damping ? 1.0 : law.damping_factor(overlap, 1.0);
    slopes.springs = {law.tangent(overlap, c.stiffness, 1.0),
                      sliding_slope(s, sliding_stiffness(s.laws, law, overlap, c.stiffness, 1.0, shear))};
    slopes.dashpots = {factor * c.damping, sliding_damping(s, viscosity_factor(s, factor) * c.viscosity)};
  });
  if (!s.integration.rotations) return slopes;
  const double area = d.radius * d.radius;
  s.contact.rolling.visit([&](const auto& law) {
    const double stiffness = std::max(law.stiffness(c.stiffness, 0.5 * d.radius),
                                      against_twisting(law).stiffness(c.stiffness, 0.5 * d.radius));
    slopes.springs.rolling = stiffness / area;
    slopes.dashpots.rolling = law.damping(c.damping, 0.5 * d.radius, stiffness, 0.5 * inertia(d)) / area;
  });
  return slopes;
}

/// z contacts with equals, six in the triangular lattice of disks and twelve in that of spheres: translation reaches
/// omega^2 = 2 z/D k/m, rotation in one sense, of a share (D - 1)/D of the contacts, or all in the plane, 2 z k_t
/// r^2/I; dashpots alike.
template <int D> Rates lattice_rates(const SampleIn<D>& s, const GrainRecord<D>& d, double overlap) {
  constexpr double normal = D == 2 ? 6.0 : 8.0, across = D == 2 ? 6.0 : 16.0, around = D == 2 ? 24.0 : 40.0;
  const double turning = s.integration.rotations ? around : across;
  const auto rate = [&](const Slopes& of) {
    return std::max(normal * of.normal, turning * of.sliding + around * of.rolling) / d.mass;
  };
  const ContactSlopes slopes = slopes_between_equals(s, d, overlap);
  return {rate(slopes.springs), rate(slopes.dashpots)};
}

/// Springs or dashpots of one contact along n and t, and the movers that they join; a wall is the one behind the last.
template <int D> struct Pull {
  std::size_t i, j;
  Kinematics<D> at;
  Levers<D> levers;
  double along_n, along_t;
};

/// How the power iteration's grains turn at first.
void turn_alike(double& omega, double rate) { omega = rate; }
void turn_alike(Vec3& /*omega*/, double /*rate*/) {}

/// Largest eigenvalue of M^-1 sum over contacts of (along_n n n + along_t t t), rotations included, by power iteration.
/// In the plane it starts from all grains turning alike, which in a dense packing is close to the fastest mode.
template <int D> double largest_rate(const SampleIn<D>& s, const std::vector<Pull<D>>& pulls) {
  using T = Turning<D>;
  using lane::dot;
  std::vector<Mover<D>> movers(s.count + body_count(s));  // a disk of a body counts for nothing
  each_mover(s, [&](std::size_t k) { movers[k] = mover_at(s, k); });
  const std::size_t n = movers.size();
  std::vector<Motion<D>> v(n + 1), w;
  for (std::size_t k = 0; k < n; ++k) {
    constexpr double first[] = {0.3, -0.25, 0.2}, other[] = {-0.2, 0.15, -0.1};
    v[k].velocity = by_axis<D>([&](std::size_t axis) { return k % (axis + 2) == 0 ? first[axis] : other[axis]; });
    turn_alike(v[k].omega, s.integration.rotations ? 1.0 / movers[k].size : 0.0);
  }
  double rate = 0;
  for (int round = 0; round < 100; ++round) {
    double size = 0;  // v M v, then v scaled to 1
    for (std::size_t k = 0; k < n; ++k)
      size += movers[k].mass * dot(v[k].velocity, v[k].velocity) + dot(movers[k].inertia * v[k].omega, v[k].omega);
    if (!(size > 0)) return 0;
    for (Motion<D>& q : v) q = {q.velocity / std::sqrt(size), q.omega / std::sqrt(size)};
    w.assign(v.size(), {});
    rate = 0;
    for (const Pull<D>& p : pulls) {
      const Vec<D> normal = p.at.normal;
      const Motion<D>&a = v[p.i], &b = v[p.j];
      const Vec<D> u = a.velocity + cross(a.omega, p.levers.i) - b.velocity - cross(b.omega, p.levers.j);
      const T turning = T{} - p.at.arm_i * a.omega - p.at.arm_j * b.omega,
              slide = without_twist(cross(normal, u) + turning, normal);
      const double fn = p.along_n * dot(u, normal);
      const T ft = p.along_t * slide;
      rate += fn * dot(u, normal) + dot(ft, slide);
      const Vec<D> f = fn * normal + cross(ft, normal);
      w[p.i].velocity += f;
      w[p.i].omega -= p.at.arm_i * ft;
      w[p.i].omega += cross(p.levers.i, f);
      w[p.j].velocity -= f;
      w[p.j].omega -= p.at.arm_j * ft;
      w[p.j].omega -= cross(p.levers.j, f);
    }
    for (std::size_t k = 0; k < n; ++k)
      v[k] = {w[k].velocity / movers[k].mass, s.integration.rotations ? w[k].omega / movers[k].inertia : T{}};
  }
  return rate;
}

/// Rates of the contacts that there are; power iteration comes from below, hence the 5 %.
template <int D> Rates network_rates(const SampleIn<D>& s) {
  std::vector<Pull<D>> springs, dashpots;
  for (std::size_t p = 0; p < s.list.size(); ++p) {
    const Kinematics<D> c = slot_kinematics(s, p);
    if (!(c.overlap > 0)) continue;
    const std::size_t wall = s.count + body_count(s);
    Pull<D> pull{moving(s, s.list.i[p]), s.list.j[p] < 0 ? wall : moving(s, s.list.owner[p]), c, levers_of(s, p), 0, 0};
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

}  // namespace

template <int D> double shortest_contact_time(const SampleIn<D>& s) {
  const double overlap = reference_overlap(s);
  const auto tangent = [&](double stiffness) { return tangent_stiffness(s, overlap, stiffness); };
  const double pull = sum_of_parts(s, [](const auto& part) { return part.steepest_slope(); });
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < s.count; ++k) {
    const auto& d = s.record[k];
    if (is_part(s, k)) continue;
    const double pair = 0.5 * d.mass / (pull + tangent(s.coefficients.pair_stiffness(d, d)));
    const double wall = d.mass / tangent(s.coefficients.wall_stiffness(d));
    shortest = std::min(shortest, std::numbers::pi * std::sqrt(std::min(pair, wall)));
  }
  each_part(s, [&](const auto& part) { shortest = std::min(shortest, part.shortest_time(s, tangent)); });
  return shortest;
}

template <int D> StepBounds step_bounds(const SampleIn<D>& s) {
  Rates r = network_rates(s);
  const double overlap = reference_overlap(s);
  each_mover(s, [&](std::size_t k) {
    if (k >= s.count) return;
    const Rates grain = lattice_rates(s, s.record[k], overlap);
    r.frequency_squared = std::max(r.frequency_squared, grain.frequency_squared);
    r.damping = std::max(r.damping, grain.damping);
  });
  const auto slopes = [&](const GrainRecord<D>& d) { return slopes_between_equals(s, d, overlap); };
  each_part(s, [&](const auto& part) { part.raise_rates(s, slopes, r); });
  Rates added;
  each_part(s, [&](const auto& part) {
    const Rates of_part = part.added_rates(s);
    added.frequency_squared += of_part.frequency_squared;
    added.damping += of_part.damping;
  });
  r.frequency_squared += added.frequency_squared;
  r.damping += added.damping;
  const double omega = std::sqrt(r.frequency_squared), lambda = r.damping + s.drag;
  constexpr double margin = 0.9;
  StepBounds bounds;
  const Integrator& scheme = integrator_of(s);
  const double p = scheme.p, q = scheme.q;
  bounds.stiffness = margin * scheme.undamped / omega;
  bounds.damping = margin * 2.0 / (q * lambda + std::sqrt(q * q * lambda * lambda + 4 * p * omega * omega));
  return bounds;
}

template double shortest_contact_time(const SampleIn<2>&);
template double shortest_contact_time(const SampleIn<3>&);
template StepBounds step_bounds(const SampleIn<2>&);
template StepBounds step_bounds(const SampleIn<3>&);

}  // namespace arenite::dem
