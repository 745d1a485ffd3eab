#pragma once
#include <vector>

#include "grains/dem/bodies/bodies.hpp"

namespace arenite::dem {

/// The places where disks may touch polygons, by disk.
std::vector<Foot> find_feet(const Sample& sample, const ThreadPool& pool);

/// The points of boundaries that jut out towards polygons, with their feet. Throws InputError or CannotGoOn for a point
/// that lies within a polygon.
std::vector<Foot> find_point_feet(const Sample& sample);

/// Puts the feet's records where they are now.
void refresh_feet(Sample& sample);

}  // namespace arenite::dem
