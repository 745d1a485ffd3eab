#pragma once
#include <vector>

#include "core/threads.hpp"
#include "geometry/rotation.hpp"
#include "grains/dem/contact_list.hpp"

namespace arenite::dem {

/// How grains are turned, which their bonds go by. An angle says so of disks; spheres of a bonded sample, whose angles
/// are no more than integrals of how fast they turn, have a rotation each.
template <int D> struct Attitudes;
template <> struct Attitudes<2> {
  void follow(const Sample& /*sample*/, const ThreadPool& /*pool*/) {}
  bool fit(std::size_t /*grains*/) const { return true; }
  template <class Members> void transfer(Members& /*members*/) {}
};
template <> struct Attitudes<3> {
  std::vector<geometry::Rotation> now;  ///< since the first bonds were made, by grain of `start`
  std::vector<Vec3> seen;               ///< their angles then

  /// Turns them by what the angles have become since they were last seen.
  void follow(const SampleIn<3>& sample, const ThreadPool& pool);
  bool fit(std::size_t grains) const { return now.size() == seen.size() && (now.empty() || now.size() == grains); }
  template <class Members> void transfer(Members& members) { members(now, seen); }
};

}  // namespace arenite::dem
