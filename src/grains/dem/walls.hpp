#pragma once
#include <algorithm>
#include <array>
#include <cmath>

#include "grains/dem/sample.hpp"

namespace arenite::dem {

/// Gives force-controlled walls (or edges of a periodic cell) their mass and impedance from the sample.
///
/// A force-controlled wall obeys m q'' = F_target - F_grains - c (q' - w), q its way into the sample. There are two
/// states of a sample, which want different walls.
///
/// Nothing drives it, so it comes to rest: w = 0. A sample of mass M that is as stiff as a crystal of its grains
/// carries waves with the impedance Z = sqrt(K M), K = k W/H (in space k A/(d H), with the face A and the mean diameter
/// d): a wall damped by c = Z swallows the waves that reach
/// it, so the sample comes to rest in about one passage instead of ringing. But a loose sample under a small force F
/// yields rather than rings, and then Z would brake it: grains rearrange at speeds of about I sqrt(P/rho) = I sqrt(F
/// H/M), so c is at most F over that speed. I is `inertial_number` of the sample, 0.01 unless a stage says otherwise
/// (measured on laboratory sample 8: a third fewer steps to rest under 100 N; beyond 0.01 a sudden load overshoots by
/// more than a fifth). c is that, times the share of the target that the grains carry already (at most 1): a wall
/// that touches nothing yet is not braked. m is M/20, or a few layers of grains where that is more: light beside the
/// sample, heavy enough that no wall is the stiffest oscillator, so it never limits the time step.
///
/// Something drives it on, so the wall has to follow (is_driven): c must not hang on the force of now, for a wall
/// that is braked more on its way out than in presses harder than it is told; and w is the slow mean of q', w' = (q'
/// - w)/tau, tau = ten passages of a wave, 10 M/Z, so that no steady motion is braked. What brakes and what is heavy
/// about a wall shows in the force (its variance in a flow is as m), so m is as small as leaves grains the stiffest
/// oscillators: one layer of grains at a wall; for a cell, whose every strip yields, two grains. I is at least 1, and
/// ten times the speed of what drives over sqrt(F H/M), so that c takes at most about a hundredth of F where the
/// volume of a flow changes by a tenth of its strain. c is also at most Z sqrt(m/M), which damps the wall on its
/// sample critically.
template <int D> void tune_servo(SampleIn<D>& sample);

/// Does so again where something begins to drive the sample, or ceases to.
template <int D> void follow_driving(SampleIn<D>& sample);

/// Kinetic energy of force-controlled walls, J.
template <int D> double servo_energy(const SampleIn<D>& sample);

/// Rate of the drag that damps the sample's slowest wave critically, 2 omega with omega = (pi/2) Z/M for a quarter of a
/// wave between a wall that holds and one that presses, Z as in tune_servo, 1/s. Packings are softer than crystals.
template <int D> double critical_drag(const SampleIn<D>& sample);

/// What drives the walls from the next step on. A wall that becomes fixed or velocity-driven takes its velocity at
/// once, one that becomes force-controlled goes on from the velocity that it has.
template <int D> void set_drives(SampleIn<D>& sample, const WallDrivesIn<D>& drives);

/// How fast the sample yields to its force-controlled sides.
template <int D> void set_inertial_number(SampleIn<D>& sample, double number);

/// Walls, by side, that are taken away; one comes back only where no grain lies beyond it (InputError).
template <int D> void set_open(SampleIn<D>& sample, const ByAnySide<bool>& open, const ThreadPool& pool = ThreadPool());
/// Walls are absent where they are open, else as they were given.
template <int D> void apply_open(SampleIn<D>& sample) {
  for (int side = 0; side < sides_in<D>; ++side)
    sample.domain.wall[side].present = sample.listed_domain.wall[side].present =
        sample.start.domain.wall[side].present && !sample.domain.is_periodic(side) && !sample.wall[side].open;
}

/// Something moves as it is told, or a programme runs: the force-controlled walls have to follow, not to come to rest.
template <int D> bool is_driven(const SampleIn<D>& s) {
  if (any_part(s, [&](const auto& part) { return part.drives(s); })) return true;
  const auto moves = [](const auto& body) {
    return body.drive.kind == DriveKind::velocity || body.drive.slide != Along<D>{};
  };
  return s.shear_rate != 0 || std::ranges::any_of(s.wall, moves);
}

/// Of what lies along a side.
inline double size_of(double along) { return std::abs(along); }
inline double size_of(Vec3 along) { return norm(along); }

/// How fast one side of the sample passes another, m/s, where sides or the cell drive it.
template <int D> double driving_speed(const SampleIn<D>& s) {
  double speed = std::abs(s.shear_rate) * s.domain.extent(1);
  for (const auto& body : s.wall) {
    if (body.drive.kind == DriveKind::velocity) speed = std::max(speed, std::abs(body.drive.value));
    speed = std::max(speed, size_of(body.drive.slide));
  }
  return speed;
}

/// c of a force-controlled wall of a sample that is driven, N s/m.
template <int D> double following_damping(const SampleIn<D>& s, std::size_t side) {
  const auto& body = s.wall[side];
  const double target = std::max(body.drive.value, 0.0), length = s.domain.extent(axis_of(static_cast<int>(side)));
  const double yielding = std::max(1.0, s.inertial_number) * std::sqrt(target * length / body.sample_mass);
  const double speed = std::max(yielding, 10 * driving_speed(s));
  return speed > 0 ? std::min(body.impedance * std::sqrt(body.mass / body.sample_mass), target / speed) : 0;
}

/// c at which a loaded wall moves no faster than the stage's inertial number allows where the sample does not bear it,
/// N s/m.
template <int D> double yielding_damping(const SampleIn<D>& s, std::size_t side) {
  const auto& body = s.wall[side];
  const double length = s.domain.extent(axis_of(static_cast<int>(side)));
  return std::sqrt(std::max(body.drive.value, 0.0) * body.sample_mass / length) / s.inertial_number;
}

/// c of a force-controlled wall, N s/m.
template <int D> double servo_damping(const SampleIn<D>& s, std::size_t side) {
  if (is_driven(s)) return following_damping(s, side);
  const auto& body = s.wall[side];
  const double carried = std::max(s.domain.wall[side].force, 0.0);
  const double share = carried >= body.drive.value ? 1.0 : carried / body.drive.value;
  return std::min(body.impedance, yielding_damping(s, side)) * share;
}

/// Braking force on a force-controlled wall at this velocity, N along its axis; 0 unless force-controlled.
template <int D> double servo_braking(const SampleIn<D>& s, std::size_t side, double velocity) {
  if (s.wall[side].drive.kind != DriveKind::force) return 0;
  return -servo_damping(s, side) * (velocity - s.wall[side].drift);
}

/// Acceleration of wall `side` from the present forces, m/s^2; 0 unless force-controlled. It and `velocity` are along
/// the wall's axis.
template <int D> double wall_acceleration(const SampleIn<D>& s, std::size_t side, double velocity) {
  const auto& body = s.wall[side];
  if (body.drive.kind != DriveKind::force) return 0;
  const double push = body.drive.value - s.domain.wall[side].force;
  return (inward_sign(side) * push + servo_braking(s, side, velocity)) / body.mass;
}

/// Those of all walls from one state: it hangs on the sample's lengths, so none is moved before the last is known.
template <int D> std::array<double, sides_in<D>> wall_accelerations(const SampleIn<D>& s) {
  std::array<double, sides_in<D>> all{};
  for (int side = 0; side < sides_in<D>; ++side) all[side] = wall_acceleration(s, side, s.domain.wall[side].velocity);
  return all;
}

/// Lets the walls' drift follow their velocity over the step just made.
template <int D> void follow_drift(SampleIn<D>& s) {
  if (!is_driven(s)) return;
  for (int side = 0; side < sides_in<D>; ++side) {
    auto& body = s.wall[side];
    if (body.drive.kind != DriveKind::force) continue;
    const double passages = 10.0 * body.sample_mass / body.impedance;
    body.drift += s.dt / passages * (s.domain.wall[side].velocity - body.drift);
  }
}

}  // namespace arenite::dem
