#include "model/film.hpp"

namespace arenite {

void Film::read(std::int64_t first, std::size_t count, FrameBlock& block) {
  const auto begin = first * static_cast<std::ptrdiff_t>(about.pixels());
  const auto end = begin + static_cast<std::ptrdiff_t>(count * about.pixels());
  block.first = first;
  block.frames = count;
  block.level.clear();
  block.value.clear();
  if (about.floating) block.value.assign(value.begin() + begin, value.begin() + end);
  else block.level.assign(level.begin() + begin, level.begin() + end);
}

}  // namespace arenite
