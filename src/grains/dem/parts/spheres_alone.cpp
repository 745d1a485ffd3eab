#include "grains/dem/parts/spheres_alone.hpp"

#include "core/problems.hpp"

namespace arenite::dem {

void SpheresAlone::check(Problems& problems, const PackingIn<3>& start, const ContactParameters& /*contact*/,
                         const IntegrationParameters& /*integration*/) {
  problems.unless(start.contacts.size() == 0 && start.grains.shapes.empty(),
                  "contacts that a packing holds, and shapes, are of the plane");
}

}  // namespace arenite::dem
