#include "thermal/imaging/open_pixels.hpp"

#include <algorithm>
#include <cstddef>

namespace arenite::imaging {

std::vector<Run> runs_of(std::span<const char> open, int width, int height) {
  std::vector<Run> runs;
  for (int y = 0; y < height; ++y) {
    if (open.empty()) {
      runs.push_back({y, 0, width - 1});
      continue;
    }
    const auto wanted = [&](int x) {
      for (int j = std::max(0, y - 1); j <= std::min(height - 1, y + 1); ++j)
        for (int i = std::max(0, x - 1); i <= std::min(width - 1, x + 1); ++i)
          if (open[static_cast<std::size_t>(i) + static_cast<std::size_t>(width) * static_cast<std::size_t>(j)] != 0) return true;
      return false;
    };
    for (int x = 0; x < width; ++x) {
      if (!wanted(x)) continue;
      if (!runs.empty() && runs.back().y == y && runs.back().last == x - 1) runs.back().last = x;
      else runs.push_back({y, x, x});
    }
  }
  return runs;
}

std::vector<char> halved_open(std::span<const char> open, int width, int height) {
  const int w = width / 2, h = height / 2;
  std::vector<char> half(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), 0);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      if (open[static_cast<std::size_t>(x) + static_cast<std::size_t>(width) * static_cast<std::size_t>(y)] == 0) continue;
      for (int j = std::max(0, y / 2 - 1); j <= std::min(h - 1, y / 2 + 1); ++j)
        for (int i = std::max(0, x / 2 - 1); i <= std::min(w - 1, x / 2 + 1); ++i) half[static_cast<std::size_t>(i) + static_cast<std::size_t>(w) * static_cast<std::size_t>(j)] = 1;
    }
  return half;
}

}  // namespace arenite::imaging
