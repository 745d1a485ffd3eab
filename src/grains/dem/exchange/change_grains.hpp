#pragma once
#include <cstdint>
#include <vector>

#include "grains/dem/sample.hpp"

namespace arenite::dem {

/// A grain that comes into a sample, not turning.
struct NewGrain {
  Vec2 place, velocity;  ///< m, m/s
  double radius = 0;     ///< m
  std::int32_t material = 0;
};

/// A grain that is taken out and put back elsewhere, not turning.
struct MovedGrain {
  std::int32_t disk = 0;  ///< inner number
  Vec2 place, velocity;   ///< m, m/s
};

/// All that happens to the grains of a sample at one time.
struct GrainChanges {
  std::vector<std::int32_t> removed;  ///< inner numbers
  std::vector<MovedGrain> moved;
  std::vector<NewGrain> added;
  bool is_none() const { return removed.empty() && moved.empty() && added.empty(); }
};

/// Takes grains out and puts others in, between two steps, and lists the contacts anew; those of all other grains go
/// on. Grains keep their order and their ids; those added follow them, and these and the ones moved get ids that none
/// had before. What they bring and take in kinetic, elastic and adhesive energy is booked as exchanged. All grains must
/// be disks, without bonds and glue, and none be held by a wall.
void change_grains(Sample& sample, const GrainChanges& changes, const ThreadPool& pool = ThreadPool());

}  // namespace arenite::dem
