#pragma once
#include "core/threads.hpp"
#include "grains/dem/sample.hpp"

namespace arenite::dem {

/// A step of all disks in one sweep of the kernel. To be made before the walls move, run after.
class DiskSweep {
 public:
  explicit DiskSweep(Sample& sample);
  /// Moves the disks and what goes with the cell. False if the contact list has become stale.
  bool run(Kernel::Sweep loop, const Team& team);

  SweepTask task;  ///< `kick` and `ahead` are the integrator's to fill in

 private:
  Sample& sample_;
  CellFrame before_;
};

}  // namespace arenite::dem
