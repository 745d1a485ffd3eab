#pragma once
#include <cstdint>
#include <vector>

#include "grains/dem/parts/part.hpp"

namespace arenite::dem {

/// A grain that goes with a rough wall: its centre in the wall's own coordinates, which start at `slid` along the wall
/// and at its plane.
struct HeldGrain {
  std::int32_t grain = 0, side = 0;  ///< the caller's index
  Vec2 place;                        ///< m
};

/// Walls that hold the grains nearest to them.
struct RoughWalls : PartOf<2> {
  std::vector<HeldGrain> held;     ///< sorted by grain
  std::vector<std::int32_t> disk;  ///< their inner numbers; renewed with the list
  std::vector<double> angle;       ///< and their angles, which do not change

  /// Of a grain (caller's index); nullptr of one that goes with no wall.
  const HeldGrain* find(std::int32_t grain) const;
  int holding_side(std::int32_t grain) const {
    const HeldGrain* of = held.empty() ? nullptr : find(grain);
    return of ? of->side : -1;
  }
  void number(Sample& sample);
  void renew(Sample& sample);
  /// Puts the grains where their walls are, with their velocity.
  void hold(Sample& sample) const;
  bool follow(Sample& sample, const SweepTask<2>& /*task*/, const ThreadPool& /*pool*/) {
    hold(sample);
    return true;
  }
  void add_to_walls(Sample& sample) const;
  template <class Members> void transfer(Sample& /*sample*/, Members& members) { members(held); }
};

/// Walls, by side, that hold the grains nearer than half their radius; those of walls that are not named are let go.
void set_rough(Sample& sample, const BySide<bool>& rough, const ThreadPool& pool = ThreadPool());

}  // namespace arenite::dem
