#pragma once
#include "grains/dem/bodies/bodies.hpp"

namespace arenite::dem {

/// Contacts in six directions around each of a body's disks, less those within it, or of polygons that meet each side
/// with a side of their own, two at either end; and the sums of their squared levers along n and t, m^2.
struct Crowd {
  double contacts = 0, normal_levers = 0, tangential_levers = 0;
};
Crowd crowd_around(const Sample& sample, const Body& body);

/// The least mass that a contact of a body feels, its rotation included, kg.
double lightest_mass(const Sample& sample, const Body& body);

}  // namespace arenite::dem
