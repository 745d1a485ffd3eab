#pragma once
#include "grains/dem/bodies/bodies.hpp"

namespace arenite::dem {

/// On a body by its disks' contacts.
Load<2> load_of(const Sample& sample, const Body& body);

/// Finds the inner numbers of the disks, and their levers.
void number_parts(Sample& sample);

/// Puts the disks of a body where it is, with its velocity.
void place_parts_of(Sample& sample, const Body& body);

/// False if the list has become stale.
bool move_bodies(Sample& sample, const SweepTask<2>& task, const ThreadPool& pool);

/// Wraps the bodies' centres and their disks into a periodic cell.
void wrap_bodies(Sample& sample);

}  // namespace arenite::dem
