#pragma once
#include <cstdint>
#include <vector>

#include "grains/dem/parts/part.hpp"

namespace arenite::dem {

/// A grain that goes with a rough wall: its centre in the wall's own coordinates, which start at `slid` along the wall
/// and at its plane.
template <int D> struct HeldGrainIn {
  std::int32_t grain = 0, side = 0;  ///< the caller's index
  Vec<D> place;                      ///< m
};

/// Walls that hold the grains nearest to them.
template <int D> struct RoughWallsIn : PartOf<D> {
  std::vector<HeldGrainIn<D>> held;  ///< sorted by grain
  std::vector<std::int32_t> disk;    ///< their inner numbers; renewed with the list
  Turnings<D> angle;                 ///< and their angles, which do not change

  /// Of a grain (caller's index); nullptr of one that goes with no wall.
  const HeldGrainIn<D>* find(std::int32_t grain) const;
  int holding_side(std::int32_t grain) const {
    const HeldGrainIn<D>* of = held.empty() ? nullptr : find(grain);
    return of ? of->side : -1;
  }
  void number(SampleIn<D>& sample);
  void renew(SampleIn<D>& sample);
  /// Puts the grains where their walls are, with their velocity.
  void hold(SampleIn<D>& sample) const;
  bool follow(SampleIn<D>& sample, const SweepTask<D>& /*task*/, const ThreadPool& /*pool*/) {
    hold(sample);
    return true;
  }
  void add_to_walls(SampleIn<D>& sample) const;
  template <class Members> void transfer(SampleIn<D>& /*sample*/, Members& members) { members(held); }
};
using RoughWalls = RoughWallsIn<2>;

/// Rough walls hold the grains that have less than this share of their radius between them and the wall.
inline constexpr double rough_reach = 0.5;

/// Walls, by side, that hold the grains nearest to them; those of walls that are not named are let go.
template <int D>
void set_rough(SampleIn<D>& sample, const ByAnySide<bool>& rough, const ThreadPool& pool = ThreadPool());

}  // namespace arenite::dem
