#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "core/mapped.hpp"
#include "thermal/imaging/grain_search.hpp"

namespace arenite::imaging {
namespace {

constexpr int bins = 256;
constexpr double least_share = 0.01, deepest_valley = 0.5;
using Histogram = std::array<double, bins>;

struct Scale {
  double low, width;  ///< of the first bin, of a bin
};

Histogram histogram_of(const FloatImage& image, const Scale& scale) {
  Histogram count{};
  for (const float v : image.value) {
    const double bin = (static_cast<double>(v) - scale.low) / scale.width;
    ++count[static_cast<std::size_t>(std::clamp(bin, 0.0, bins - 1.0))];
  }
  Histogram smooth{};
  for (int b = 0; b < bins; ++b)
    for (int d = -6; d <= 6; ++d)
      if (b + d >= 0 && b + d < bins) smooth[static_cast<std::size_t>(b)] += count[static_cast<std::size_t>(b + d)] * std::exp(-d * d / 8.0) / 5.013;
  return smooth;
}

/// Bins of maxima between which the histogram falls to the given share of the lower one.
std::vector<std::size_t> peaks_of(const Histogram& count) {
  std::vector<std::size_t> peaks;
  double valley = 0;
  for (std::size_t b = 0; b < bins; ++b) {
    const bool top = (b == 0 || count[b] > count[b - 1]) && (b + 1 == bins || count[b] >= count[b + 1]);
    valley = std::min(valley, count[b]);
    if (!top) continue;
    if (peaks.empty() || valley <= deepest_valley * std::min(count[b], count[peaks.back()])) peaks.push_back(b);
    else if (count[b] > count[peaks.back()]) peaks.back() = b;
    else continue;
    valley = count[b];
  }
  return peaks;
}

/// Pixels from valley to valley round a peak.
double members(const Histogram& count, std::size_t peak) {
  double sum = count[peak];
  for (std::size_t b = peak; b > 0 && count[b - 1] <= count[b]; --b) sum += count[b - 1];
  for (std::size_t b = peak; b + 1 < bins && count[b + 1] <= count[b]; ++b) sum += count[b + 1];
  return sum;
}

}  // namespace

std::vector<double> levels_between(const FloatImage& image) {
  if (image.value.empty()) return {};
  const auto [low, high] = std::minmax_element(image.value.begin(), image.value.end());
  const Scale scale{static_cast<double>(*low), (static_cast<double>(*high) - static_cast<double>(*low)) / bins};
  if (!(scale.width > 0)) return {};
  const Histogram count = histogram_of(image, scale);
  std::vector<std::size_t> peaks = peaks_of(count);
  std::erase_if(peaks, [&](std::size_t peak) { return members(count, peak) < least_share * static_cast<double>(image.size()); });
  if (peaks.size() < 3) return {};
  peaks.erase(peaks.begin());
  peaks.pop_back();
  std::stable_sort(peaks.begin(), peaks.end(), [&](std::size_t a, std::size_t b) { return members(count, a) > members(count, b); });
  return mapped(peaks, [&](std::size_t peak) { return scale.low + (static_cast<double>(peak) + 0.5) * scale.width; });
}

}  // namespace arenite::imaging
