#include "grains/dem/laws/laws.hpp"

namespace arenite::dem {

ContactLaws choose_laws(const ContactParameters& contact, double lead, double lag) {
  ContactLaws laws;
  if (contact.normal == NormalLaw::hertz) laws.normal = Hertz{contact.normal_damping.has_value()};
  if (contact.adhesion != Adhesion::none)
    laws.adhesion = GeometricalAdhesion{contact.friction_cap == FrictionCap::raised_by_adhesion ? 1.0 : -1.0};
  if (contact.friction_law == FrictionLaw::cundall_strack)
    laws.friction = CundallStrack{contact.tangential_stiffness_ratio, lead, lag};
  return laws;
}

}  // namespace arenite::dem
