#include "dem/laws/laws.hpp"

namespace arenite::dem {

ContactLaws choose_laws(const ContactParameters& contact, double time_step, bool mid_step_velocities) {
  ContactLaws laws;
  if (contact.normal == NormalLaw::hertz) laws.normal = Hertz{contact.normal_damping.has_value()};
  if (contact.adhesion != Adhesion::none)
    laws.adhesion = GeometricalAdhesion{contact.friction_cap == FrictionCap::raised_by_adhesion ? 1.0 : -1.0};
  if (contact.friction_law == FrictionLaw::cundall_strack) {
    const double lead = mid_step_velocities ? 1.0 : 0.5;
    laws.friction = CundallStrack{contact.tangential_stiffness_ratio, lead * time_step, (1.0 - lead) * time_step};
  }
  return laws;
}

}  // namespace arenite::dem
