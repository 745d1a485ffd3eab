#pragma once
#include "grains/dem/parts/part.hpp"

namespace arenite::dem {

/// Refuses what is not written for spheres.
struct SpheresAlone : PartOf<3> {
  static void check(Problems& problems, const PackingIn<3>& start, const ContactParameters& contact,
                    const IntegrationParameters& integration);
};

}  // namespace arenite::dem
