#include "thermal/imaging/grain_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "thermal/imaging/grey_levels.hpp"
#include "thermal/imaging/search_rounds.hpp"

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

/// The rims that the picture shows, searched once for all that begin with them.
class Rims {
 public:
  Rims(const FloatImage& image, const CircleOptions& options) : image_(image), options_(options) {}
  const std::vector<Circle>& of(bool bright) {
    const std::size_t sign = bright ? 1 : 0;
    if (!searched_[sign]) seen_[sign] = search_rims(image_, first_range(image_, options_, bright));
    searched_[sign] = true;
    return seen_[sign];
  }
  std::vector<Circle> of_both() {
    std::vector<Circle> both = of(true);
    both.insert(both.end(), of(false).begin(), of(false).end());
    return both;
  }

 private:
  const FloatImage& image_;
  const CircleOptions& options_;
  std::array<std::vector<Circle>, 2> seen_;
  std::array<bool, 2> searched_{};
};

/// Disks on both sides of a level, if the picture has one, and they account for most of what is not of that level.
std::optional<DiskSearch> search_both(const FloatImage& image, const CircleOptions& options, Rims& rims) {
  auto levels = levels_between(image);
  levels.resize(std::min(levels.size(), most_levels));
  for (const double level : levels) {
    SearchRounds both(image, true, options, level);
    both.begin(rims.of_both());
    if (both.area() >= most_share * pixels_away_from(level, image)) return both.finish();
  }
  return std::nullopt;
}

}  // namespace

DiskSearch search_disks(const FloatImage& image, const CircleOptions& options) {
  Rims rims(image, options);
  if (options.contrast == GrainContrast::found)
    if (auto both = search_both(image, options, rims)) return std::move(*both);
  SearchRounds bright(image, true, options), dark(image, false, options);
  if (options.contrast != GrainContrast::dark) bright.begin(rims.of(true));
  if (options.contrast != GrainContrast::bright) dark.begin(rims.of(false));
  return bright.gain() >= dark.gain() ? bright.finish() : dark.finish();
}

}  // namespace arenite::imaging
