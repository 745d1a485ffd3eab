#include "grains/dem/parts/energy_balance.hpp"

#include <algorithm>
#include <utility>

#include "grains/dem/movers.hpp"

namespace arenite::dem {
namespace {

/// Sums of the mean force over the two times, times the velocities of the second.
template <int D> WorkTerms products(const SampleIn<D>& s, const ForcesAndRates<D>& p, const ForcesAndRates<D>& q) {
  using lane::dot;
  WorkTerms w;
  const Vec<D> gravity = p.gravity + q.gravity;
  for (std::size_t k = 0; k < q.disk.size(); ++k) {
    const auto &a = p.disk[k], &b = q.disk[k];
    const Vec<D> velocity = 0.5 * b.own.velocity;
    w.dashpots += dot(a.dash.force + b.dash.force, velocity);
    w.friction += dot(a.slip.force + b.slip.force, velocity);
    if (s.integration.rotations) {
      const Turning<D> omega = 0.5 * b.own.omega;
      w.dashpots += dot(a.dash.torque + b.dash.torque, omega);
      w.friction += dot(a.slip.torque + b.slip.torque, omega);
    }
    w.drag += dot(a.drag + b.drag, velocity);
    w.gravity += b.mass * dot(gravity, velocity);
  }
  const auto add_edge = [&w](const auto& a, const auto& b) {
    const double rate = 0.5 * b.rate;
    w.dashpots += (a.dash + b.dash) * rate;
    w.friction += (a.slip + b.slip) * rate;
    w.walls += b.servo ? (a.drive + b.drive) * rate : -(a.force + b.force) * rate;
    w.servo += (a.damping + b.damping) * rate;
  };
  for (std::size_t n = 0; n < q.edge.size(); ++n) add_edge(p.edge[n], q.edge[n]);
  for (std::size_t n = 0; n < q.boundary.size(); ++n) add_edge(p.boundary[n], q.boundary[n]);
  for (std::size_t n = 0; n < q.node.size(); ++n) add_edge(p.node[n], q.node[n]);
  return w;
}

void add(WorkTerms& sum, double factor, const WorkTerms& w) {
  for (const auto term : work_terms) sum.*term += factor * w.*term;
}

/// Work of the step from the powers at its end (`p`) and before.
template <int D> WorkTerms integrate(const EnergyBalanceIn<D>& balance, const WorkTerms& p, double dt) {
  static constexpr double weight[3][4] = {{1, 1}, {5, 8, -1}, {9, 19, -5, 1}}, over[] = {2, 12, 24};
  const int order = std::clamp(balance.known, 1, 3);
  WorkTerms w;
  add(w, weight[order - 1][0] * dt / over[order - 1], p);
  for (int k = 1; k <= order; ++k) add(w, weight[order - 1][k] * dt / over[order - 1], balance.powers[k - 1]);
  return w;
}

}  // namespace

template <int D> void EnergyBalanceIn<D>::begin(SampleIn<D>& s) {
  if (open || !s.integration.track_energy) return;
  last = forces_and_rates(s);
  powers = {};
  add(powers[0], 1, products(s, last, last));
  known = 1;
  open = true;
}

template <int D> void EnergyBalanceIn<D>::go_on(SampleIn<D>& s) {
  if (!open) return;
  const auto stored = powers;
  const int number = known;
  open = false;
  begin(s);
  powers = stored;
  known = number;
}

template <int D> void EnergyBalanceIn<D>::after_forces(SampleIn<D>& s) {
  if (!s.integration.track_energy) return;
  ForcesAndRates<D> now = forces_and_rates(s);
  WorkTerms work;
  if (integrator_of(s).corrects()) {
    WorkTerms power;
    add(power, 1, products(s, now, now));
    work = integrate(*this, power, s.dt);
    powers = {power, powers[0], powers[1]};
    known = known < 3 ? known + 1 : 3;
  } else {
    add(work, s.dt, products(s, last, now));
  }
  s.tally.dissipated_normal -= work.dashpots + (now.normal_springs - last.normal_springs);
  s.tally.dissipated_friction -= work.friction + (now.springs - last.springs);
  s.tally.dissipated_drag -= work.drag + work.servo;
  s.tally.work_gravity += work.gravity;
  s.tally.work_walls += work.walls;
  last = std::move(now);
}

template struct EnergyBalanceIn<2>;
template struct EnergyBalanceIn<3>;

}  // namespace arenite::dem
