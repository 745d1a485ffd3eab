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
  const geometry::Rotation &of_i = now[s.record[b.i].grain], &of_j = now[s.record[b.j].grain];
  m.along_i = turned(of_i, b.along_i);
  m.along_j = turned(of_j, b.along_j);
  m.between = of_i * geometry::Rotation{b.rest_cosine, b.rest_sine} * inverse(of_j);
  if (m.between.cosine < 0) m.between = {-m.between.cosine, -m.between.sine};
  const double twist = 2 * std::atan2(dot(m.between.sine, m.normal), m.between.cosine);
  m.strain = b.strain(m.distance, m.normal, m, twist);
  return m;
}

SlotForce<2> beam_slot_force(const BondSlot& b, const BeamMotion& m, const BeamForce<double>& f) {
  const auto [on_i, torque_i, torque_j] = b.pull(f, m.normal, f.shear * b.length / m.distance);
  return {on_i, torque_i, torque_j};
}

SlotForce<3> beam_slot_force(const BondSlotIn<3>& b, const BeamMotionIn<3>& m, const RoundForce& f) {
  const auto [on_i, torque_i, torque_j] = b.pull(f, m.normal, 1 / m.distance, m);
  return {on_i, torque_i, torque_j};
}

BeamStrain<double> strain_rate(const BondSlot& b, const BeamMotion& m, Vec2 velocity, double turning_i,
                               double turning_j) {
  return b.rate(dot(velocity, m.normal), cross(m.normal, velocity) / m.distance, turning_i, turning_j);
}

RoundStrain strain_rate(const BondSlotIn<3>& b, const BeamMotionIn<3>& m, Vec3 velocity, Vec3 turning_i,
                        Vec3 turning_j) {
  return b.rate(m.normal, 1 / m.distance, velocity, turning_i, turning_j);
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
