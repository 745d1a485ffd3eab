#include "grains/dem/parts/beam_motion.hpp"

#include <cmath>

#include "grains/dem/sample.hpp"

namespace arenite::dem {
namespace {

template <int D> BeamMotionIn<D> motion_between(const SampleIn<D>& s, const BondSlotIn<D>& b) {
  BeamMotionIn<D> m;
  m.branch = s.record[b.i].place - s.record[b.j].place - s.domain.way(b.shift);
  m.distance = norm(m.branch);
  m.normal = m.branch / m.distance;
  return m;
}

/// How the twist about the normal grows as i turns, as j turns the other way, and as the normal does.
struct TwistSlopes {
  Vec3 by_i, by_j, by_normal;
};
TwistSlopes twist_slopes(const BeamMotionIn<3>& m) {
  const Vec3 v = m.between.sine;
  const double w = m.between.cosine, p = dot(v, m.normal), square = w * w + p * p;
  const Vec3 middle = w * w * m.normal + p * v, aside = w * cross(v, m.normal);
  return {(middle + aside) / square, (middle - aside) / square, 2 * w / square * v};
}

}  // namespace

BeamMotion beam_motion(const Sample& s, const BondSlot& b) {
  BeamMotion m = motion_between(s, b);
  const double turned = std::atan2(cross(b.normal, m.normal), dot(b.normal, m.normal));
  const double turn_i = s.angle[b.i] - b.angle_i - turned, turn_j = s.angle[b.j] - b.angle_j - turned;
  m.strain = b.strain(m.distance, turn_i, turn_j);
  return m;
}

BeamMotionIn<3> beam_motion(const SampleIn<3>& s, const BondSlotIn<3>& b) {
  BeamMotionIn<3> m = motion_between(s, b);
  const auto& now = the<BondsIn<3>>(s).attitudes.now;
  const geometry::Rotation turn_i = now[s.record[b.i].grain] * b.back_i, turn_j = now[s.record[b.j].grain] * b.back_j;
  m.along_i = turned(turn_i, b.normal);
  m.along_j = turned(turn_j, b.normal);
  m.between = turn_i * inverse(turn_j);
  if (m.between.cosine < 0) m.between = {-m.between.cosine, -m.between.sine};
  const Vec3 bent_i = cross(m.normal, m.along_i), bent_j = cross(m.normal, m.along_j);
  m.strain = {m.distance - b.length, b.arm_i * bent_i + b.arm_j * bent_j, bent_i - bent_j,
              2 * std::atan2(dot(m.between.sine, m.normal), m.between.cosine)};
  return m;
}

SlotForce<2> beam_slot_force(const BondSlot& b, const BeamMotion& m, const BeamForce<double>& f) {
  const auto [on_i, torque_i, torque_j] = b.pull(f, m.normal, f.shear * b.length / m.distance);
  return {on_i, torque_i, torque_j};
}

SlotForce<3> beam_slot_force(const BondSlotIn<3>& b, const BeamMotionIn<3>& m, const RoundForce& f) {
  const Vec3 on_bent_i = b.arm_i * f.shear + f.moment, on_bent_j = b.arm_j * f.shear - f.moment;
  const TwistSlopes twist = twist_slopes(m);
  const Vec3 by_normal = cross(m.along_i, on_bent_i) + cross(m.along_j, on_bent_j) + f.twist * twist.by_normal;
  return {-f.tension * m.normal - without_twist(by_normal, m.normal) / m.distance,
          -cross(m.along_i, cross(on_bent_i, m.normal)) - f.twist * twist.by_i,
          -cross(m.along_j, cross(on_bent_j, m.normal)) + f.twist * twist.by_j};
}

BeamStrain<double> strain_rate(const BondSlot& b, const BeamMotion& m, Vec2 velocity, double turning_i,
                               double turning_j) {
  return b.rate(dot(velocity, m.normal), cross(m.normal, velocity) / m.distance, turning_i, turning_j);
}

RoundStrain strain_rate(const BondSlotIn<3>& b, const BeamMotionIn<3>& m, Vec3 velocity, Vec3 turning_i,
                        Vec3 turning_j) {
  const Vec3 line = cross(m.normal, velocity) / m.distance, against = turning_i - turning_j;
  return {dot(velocity, m.normal), without_twist(b.arm_i * turning_i + b.arm_j * turning_j - b.length * line, m.normal),
          without_twist(against, m.normal), dot(against, m.normal)};
}

template <int D> BeamForceIn<D> beam_dashpots(const SampleIn<D>& s, const BondSlotIn<D>& b, const BeamMotionIn<D>& m) {
  const GrainRecord<D>&a = s.record[b.i], &c = s.record[b.j];
  return b.dashpots.force(strain_rate(b, m, a.velocity - c.velocity - image_velocity(s, b.shift), a.omega, c.omega));
}

void put_forces(const BondSlot& b, const BeamMotion& m, const BeamForce<double>& f, Bond& bond) {
  bond.fn = -f.tension;
  bond.ft = f.shear * b.length / m.distance;
  bond.moment = -f.moment;
}

void put_forces(const BondSlotIn<3>& b, const BeamMotionIn<3>& m, const RoundForce& f, BondIn<3>& bond) {
  const Vec3 on_i = beam_slot_force(b, m, f).on_i;
  bond.fn = dot(on_i, m.normal);
  bond.ft = cross(m.normal, on_i);
  bond.moment = -(f.moment + f.twist * m.normal);
}

template BeamForce<double> beam_dashpots(const Sample&, const BondSlot&, const BeamMotion&);
template RoundForce beam_dashpots(const SampleIn<3>&, const BondSlotIn<3>&, const BeamMotionIn<3>&);

}  // namespace arenite::dem
