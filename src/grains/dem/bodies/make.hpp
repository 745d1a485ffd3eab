#pragma once
#include "grains/dem/bodies/bodies.hpp"

namespace arenite::dem {

void check_shapes(Problems& problems, const Packing& start, const ContactParameters& contact,
                  const IntegrationParameters& integration);

/// The packing with each disk of its grains as a grain; itself where all grains are disks. Contacts stay as they are.
Packing disks_of(const Packing& packing);

/// Makes the bodies of a sample whose `start` is made by disks_of; none where all grains are disks.
void make_bodies(Sample& sample, const Grains& given);

}  // namespace arenite::dem
