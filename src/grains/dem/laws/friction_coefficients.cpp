#include "grains/dem/laws/friction_coefficients.hpp"

namespace arenite::dem {

void declare_friction(ParameterVisitor& v, double& friction, std::optional<double>& wall_friction) {
  v.number({"friction", "Coefficient mu between grains."}, friction, "", range::not_negative);
  v.number({"wall_friction", "Coefficient mu at the walls; unless given, that of the grains."}, wall_friction, "",
           range::not_negative);
}

}  // namespace arenite::dem
