#pragma once
#include <cstdint>
#include <vector>

#include "model/phase_map.hpp"

namespace arenite::report {

/// Which nodes of a large map the page draws: every `stride`-th in both directions, from the middle of the first block.
/// A map of up to about a million nodes is drawn whole.
struct Thinning {
  int stride = 1;
  int width = 0, height = 0;          ///< nodes that are left
  std::vector<std::size_t> node;      ///< their indices in the map

  explicit Thinning(const PhaseMap& map, std::size_t most = 1'200'000);

  template <class T>
  std::vector<T> of(const std::vector<T>& values) const {
    if (stride == 1) return values;
    std::vector<T> kept(node.size());
    for (std::size_t k = 0; k < node.size(); ++k) kept[k] = values[node[k]];
    return kept;
  }
};

}  // namespace arenite::report
