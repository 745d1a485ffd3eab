#include "report/thinned_map.hpp"

#include <algorithm>

namespace arenite::report {

Thinning::Thinning(const PhaseMap& map, std::size_t most) {
  const auto left = [](int nodes, int by) { return std::max(1, nodes / by); };
  while (static_cast<std::size_t>(left(map.width, stride)) * static_cast<std::size_t>(left(map.height, stride)) > most) ++stride;
  width = map.width > 0 ? left(map.width, stride) : 0;
  height = map.height > 0 ? left(map.height, stride) : 0;
  const int first = stride / 2;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      node.push_back(map.index(std::min(map.width - 1, first + x * stride), std::min(map.height - 1, first + y * stride)));
}

}  // namespace arenite::report
