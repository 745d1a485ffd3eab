#pragma once
#include <vector>

#include "model/packing.hpp"

namespace arenite::elasticity {

/// Stress of every grain as its normal forces make it, -sum fn/(2 pi R L), Pa, tension positive: the mean over the disk
/// whose rim carries them, which is what pixels show. (A stress by branch vectors has arms shortened by the overlaps.)
std::vector<double> stress_of_disks(const Packing& packing);

/// Change of that stress of every grain from a state of low load (null: none at all) to one of high load of the same
/// grains, Pa: what a film shows peak to peak.
std::vector<double> stress_change(const Packing* low, const Packing& high);

}  // namespace arenite::elasticity
