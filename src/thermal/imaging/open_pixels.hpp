#pragma once
#include <span>
#include <vector>

namespace arenite::imaging {

/// Pixels first .. last of a row.
struct Run {
  int y, first, last;
};

/// Where values are needed: at the open pixels (not 0) and beside them; all rows where `open` is empty.
std::vector<Run> runs_of(std::span<const char> open, int width, int height);

/// Open pixels of a picture halved, with those beside them, since a centre may yet move by a pixel.
std::vector<char> halved_open(std::span<const char> open, int width, int height);

}  // namespace arenite::imaging
