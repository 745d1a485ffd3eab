#pragma once
#include <array>
#include <cstdint>
#include <vector>

namespace arenite::statics {

/// Cuts what reaches far at its necks: of the labels `first` to `end` - 1 of voxels, of which a sample has `count`
/// along each axis, x first; parts that come off are numbered from `end` on. Returns the end of all labels. What is
/// porous is often one grain, whose parts turn and shift about the necks between them: modes that a coarse level on
/// cells alone, which go across necks, does not have.
std::int32_t cut_at_necks(std::vector<std::int32_t>& label, const std::array<int, 3>& count, std::int32_t first,
                          std::int32_t end);

}  // namespace arenite::statics
