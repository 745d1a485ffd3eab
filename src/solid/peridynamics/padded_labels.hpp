#pragma once
#include <cstddef>
#include <cstdint>

#include "core/pages.hpp"
#include "model/phase_map.hpp"
#include "solid/statics/grid.hpp"

namespace arenite::peridynamics {

/// 0: void, 1: matrix, 2 and more: a grain; of a map of the plane or of space, padded.
template <class Map> Buffer<std::int32_t> padded_labels(const Map& map, const statics::Grid& grid) {
  Buffer<std::int32_t> labels(grid.padded_size());
  std::size_t k = 0;
  grid.each([&](std::ptrdiff_t i, int) {
    labels[i] = map.phase[k] == Phase::particle ? map.grain[k] + 2 : static_cast<std::int32_t>(map.phase[k]);
    ++k;
  });
  return labels;
}

}  // namespace arenite::peridynamics
