#pragma once
#include "grains/dem/parts/bond_list.hpp"

namespace arenite::dem {

/// The grains at the ends of a bond of spheres.
template <int D> struct BeamEnds {};
template <> struct BeamEnds<3> : RoundEnds<double> {};

/// Where a bond's grains are now, and how it is strained.
template <int D> struct BeamMotionIn : BeamEnds<D> {
  Vec<D> branch, normal;  ///< from the meant image of j to i
  double distance = 0;
  BeamStrainIn<D> strain;
};
using BeamMotion = BeamMotionIn<2>;
BeamMotion beam_motion(const Sample& sample, const BondSlot& slot);
BeamMotionIn<3> beam_motion(const SampleIn<3>& sample, const BondSlotIn<3>& slot);

/// A bond's force on i and its torques, from what the beam answers with; in space the gradient of its energy.
SlotForce<2> beam_slot_force(const BondSlot& slot, const BeamMotion& motion, const BeamForce<double>& force);
SlotForce<3> beam_slot_force(const BondSlotIn<3>& slot, const BeamMotionIn<3>& motion, const RoundForce& force);
/// What its dashpots have in that.
template <int D>
BeamForceIn<D> beam_dashpots(const SampleIn<D>& sample, const BondSlotIn<D>& slot, const BeamMotionIn<D>& motion);

/// Rate of the strain where i moves past the meant image of j so, m/s, and both turn.
BeamStrain<double> strain_rate(const BondSlot& slot, const BeamMotion& motion, Vec2 velocity, double turning_i,
                               double turning_j);
RoundStrain strain_rate(const BondSlotIn<3>& slot, const BeamMotionIn<3>& motion, Vec3 velocity, Vec3 turning_i,
                        Vec3 turning_j);

/// What a bond says of its force now.
void put_forces(const BondSlot& slot, const BeamMotion& motion, const BeamForce<double>& force, Bond& bond);
void put_forces(const BondSlotIn<3>& slot, const BeamMotionIn<3>& motion, const RoundForce& force, BondIn<3>& bond);

}  // namespace arenite::dem
