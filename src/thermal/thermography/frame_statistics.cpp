#include "thermal/thermography/frame_statistics.hpp"

#include <algorithm>
#include <cmath>

namespace arenite::thermography {
namespace {

struct Sums {
  std::vector<double> sum, differences;
  std::vector<float> before;
};

template <class T>
void add_frame(const T* pixel, bool first, Sums& sums, FrameStatistics& s) {
  const std::size_t n = s.mean.size();
  for (std::size_t i = 0; i < n; ++i) {
    const auto x = static_cast<float>(pixel[i]);
    const double d = first ? 0 : static_cast<double>(x) - static_cast<double>(sums.before[i]);
    sums.sum[i] += static_cast<double>(x);
    sums.differences[i] += d * d;
    sums.before[i] = x;
    s.least[i] = first ? x : std::min(s.least[i], x);
    s.most[i] = first ? x : std::max(s.most[i], x);
  }
}

}  // namespace

FrameStatistics frame_statistics(FilmSource& film, std::size_t most_frames) {
  const FilmInfo& info = film.info();
  const std::size_t n = info.pixels(), all = static_cast<std::size_t>(info.frames);
  FrameStatistics s{info.width, info.height, most_frames == 0 ? all : std::min(all, most_frames), {}, {}, {}, {}};
  for (auto* array : {&s.mean, &s.noise, &s.least, &s.most}) array->resize(n);
  Sums sums{std::vector<double>(n), std::vector<double>(n), std::vector<float>(n)};
  constexpr std::size_t most_pixels = std::size_t{1} << 21;
  const std::size_t at_once = std::max<std::size_t>(1, most_pixels / std::max<std::size_t>(1, n));
  FrameBlock block;
  for (std::size_t f = 0; f < s.frames; f += at_once) {
    film.read(static_cast<std::int64_t>(f), std::min(at_once, s.frames - f), block);
    for (std::size_t k = 0; k < block.frames; ++k) {
      if (block.level.empty()) add_frame(block.value.data() + k * n, f + k == 0, sums, s);
      else add_frame(block.level.data() + k * n, f + k == 0, sums, s);
    }
  }
  const auto count = static_cast<double>(s.frames);
  for (std::size_t i = 0; i < n; ++i) {
    s.mean[i] = static_cast<float>(sums.sum[i] / count);
    s.noise[i] = s.frames > 1 ? static_cast<float>(std::sqrt(sums.differences[i] / (2 * (count - 1)))) : 0;
  }
  return s;
}

Doubtful doubtful(const FrameStatistics& s, int bits) {
  constexpr std::size_t least_frames = 8;  // fewer agree by chance
  Doubtful found;
  const float top = bits > 0 && bits <= 16 ? static_cast<float>((1 << bits) - 1) : INFINITY;
  for (std::size_t i = 0; i < s.mean.size(); ++i) {
    if (s.frames >= least_frames && s.least[i] == s.most[i]) ++found.constant;
    if (s.most[i] >= top) ++found.saturated;
  }
  return found;
}

}  // namespace arenite::thermography
