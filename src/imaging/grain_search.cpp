#include "imaging/grain_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "imaging/grey_levels.hpp"
#include "imaging/search_rounds.hpp"

namespace arenite::imaging {
namespace {

constexpr std::size_t most_levels = 2;
constexpr double most_share = 0.6;   // of the pixels on both sides of a level that disks must account for

/// Pixels that are farther from a level than half of what the farthest are.
double pixels_away_from(double level, const FloatImage& image) {
  std::vector<double> away;
  for (const float v : image.value) away.push_back(std::abs(static_cast<double>(v) - level));
  const auto far = away.begin() + static_cast<std::ptrdiff_t>(away.size() * 9 / 10);
  std::nth_element(away.begin(), far, away.end());
  return static_cast<double>(std::count_if(away.begin(), away.end(), [half = *far / 2](double v) { return v > half; }));
}

/// Disks on both sides of a level, if the picture has one, and they account for most of what is not of that level.
std::optional<DiskSearch> search_both(const FloatImage& image, const CircleOptions& options) {
  auto levels = levels_between(image);
  levels.resize(std::min(levels.size(), most_levels));
  for (const double level : levels) {
    SearchRounds both(image, true, options, level);
    both.begin();
    if (both.area() >= most_share * pixels_away_from(level, image)) return both.finish();
  }
  return std::nullopt;
}

}  // namespace

DiskSearch search_disks(const FloatImage& image, const CircleOptions& options) {
  if (options.contrast == GrainContrast::found)
    if (auto both = search_both(image, options)) return std::move(*both);
  SearchRounds bright(image, true, options), dark(image, false, options);
  if (options.contrast != GrainContrast::dark) bright.begin();
  if (options.contrast != GrainContrast::bright) dark.begin();
  return bright.gain() >= dark.gain() ? bright.finish() : dark.finish();
}

}  // namespace arenite::imaging
