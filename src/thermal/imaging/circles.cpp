#include "thermal/imaging/circles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include "core/error.hpp"
#include "core/mapped.hpp"
#include "core/median.hpp"
#include "core/ranks.hpp"
#include "statistics/histogram.hpp"
#include "thermal/imaging/search_rounds.hpp"

namespace arenite::imaging {
namespace {

void check(const FloatImage& image) {
  if (image.size() == 0 || image.value.size() != image.size())
    throw InputError("the picture is empty; give one that shows grains");
  if (!std::all_of(image.value.begin(), image.value.end(), [](float v) { return std::isfinite(v); }))
    throw InputError("the picture holds values that are not numbers; replace bad pixels first");
  const auto [low, high] = std::minmax_element(image.value.begin(), image.value.end());
  if (*low == *high) throw InputError("all pixels of the picture are equal; give one that shows grains");
}

/// Mean over the inner half of a disk, that is out to r/sqrt(2).
double brightness_of(const FloatImage& image, const DiskModel::Disk& disk) {
  const double reach = std::max(1.0, disk.radius * std::sqrt(0.5));
  double sum = 0, count = 0;
  each_pixel_near(disk.centre, reach, image.width, image.height, [&](int x, int y, std::size_t at) {
    if (std::hypot(x - disk.centre.x, y - disk.centre.y) <= reach) sum += static_cast<double>(image.value[at]), ++count;
  });
  return count > 0 ? sum / count : disk.level;
}

/// A pore between three grains may have a round rim, but it is as grey as what is behind grains of both kinds.
std::vector<char> pores(const std::vector<double>& brightness, double between) {
  constexpr double least = 0.3;  // of the usual distance from the level between grains
  const std::vector<double> away = mapped(brightness, [&](double b) { return std::abs(b - between); });
  return mapped<char>(away, [&, usual = median(away)](double a) { return a < least * usual; });
}

void part_materials(FoundCircles& found, const CircleOptions& options) {
  statistics::ClusterOptions how{.floor = 0.5 * found.report.noise,
                                 .least_members = std::max<std::size_t>(2, found.grains.size() / 100)};
  if (options.materials > 0) how = {.most = options.materials, .separation = 0, .floor = how.floor, .least_members = 1};
  found.report.materials = statistics::cluster(found.grains.brightness, how);
  found.grains.material = found.report.materials.of;
}

void count_overlaps(FoundCircles& found) {
  const PictureGrains& g = found.grains;
  for (std::size_t a = 0; a < g.size(); ++a)
    for (std::size_t b = a + 1; b < g.size(); ++b) {
      const double overlap = g.radius[a] + g.radius[b] - norm(g.centre[a] - g.centre[b]);
      found.report.largest_overlap = std::max(found.report.largest_overlap, overlap);
      const double error = std::hypot(std::hypot(g.position_error[a], g.position_error[b]),
                                      std::hypot(g.radius_error[a], g.radius_error[b]));
      if (overlap > 3 * error && overlap > 0.02 * std::min(g.radius[a], g.radius[b])) ++found.report.overlapping;
    }
}

constexpr int bins = 256;
using Levels = std::array<double, bins>;

Levels smooth_histogram(const FloatImage& image, const statistics::Bins& scale) {
  Levels count{}, smooth{};
  for (const float v : image.value)
    ++count[static_cast<std::size_t>(std::clamp((static_cast<double>(v) - scale.low) / scale.width, 0.0, bins - 1.0))];
  for (int b = 0; b < bins; ++b)
    for (int d = std::max(-6, -b); d <= std::min(6, bins - 1 - b); ++d)
      smooth[static_cast<std::size_t>(b)] += count[static_cast<std::size_t>(b + d)] * std::exp(-d * d / 8.0) / 5.013;
  return smooth;
}

/// Bins of maxima between which the histogram falls to half of the lower one.
std::vector<std::size_t> peaks_of(const Levels& count) {
  constexpr double deepest_valley = 0.5;
  std::vector<std::size_t> peaks;
  double valley = 0;
  for (std::size_t b = 0; b < bins; ++b) {
    valley = std::min(valley, count[b]);
    if ((b > 0 && count[b] <= count[b - 1]) || (b + 1 < bins && count[b] < count[b + 1])) continue;
    if (peaks.empty() || valley <= deepest_valley * std::min(count[b], count[peaks.back()])) peaks.push_back(b);
    else if (count[b] > count[peaks.back()]) peaks.back() = b;
    else continue;
    valley = count[b];
  }
  return peaks;
}

/// Pixels from valley to valley round a peak.
double members(const Levels& count, std::size_t peak) {
  double sum = count[peak];
  for (std::size_t b = peak; b > 0 && count[b - 1] <= count[b]; --b) sum += count[b - 1];
  for (std::size_t b = peak; b + 1 < bins && count[b + 1] <= count[b]; ++b) sum += count[b + 1];
  return sum;
}

constexpr std::size_t most_levels = 2;
constexpr double most_share = 0.6;  // of the pixels on both sides of a level that disks must account for

/// Pixels that are farther from a level than half of what the farthest are.
double pixels_away_from(double level, const FloatImage& image) {
  std::vector<double> away = mapped(image.value, [&](float v) { return std::abs(static_cast<double>(v) - level); });
  const double half = of_rank_in_place(away, away.size() * 9 / 10) / 2;
  return static_cast<double>(std::ranges::count_if(away, [half](double v) { return v > half; }));
}

/// Whether disks are brighter or darker than what is around them is decided, if it is asked, by which of the two
/// accounts for more of the picture after the first round; where the picture has a level between two others
/// (levels_between) and disks on both sides of it account for most of the rest, these are taken.
DiskSearch search_disks(const FloatImage& image, const CircleOptions& options) {
  std::array<std::optional<std::vector<Circle>>, 2> seen;
  const auto rims = [&](bool bright) -> const std::vector<Circle>& {  // searched once for all that begin with them
    auto& own = seen[bright ? 1 : 0];
    if (!own) own = search_rims(image, SearchRounds::range(image, options, options.radii, bright, 0.15));
    return *own;
  };
  std::vector<double> levels;
  if (options.contrast == GrainContrast::found) levels = levels_between(image);
  levels.resize(std::min(levels.size(), most_levels));
  for (const double level :
       levels) {  // disks on both sides of it, if they account for most of what is not of that level
    std::vector<Circle> first = rims(true);
    first.insert(first.end(), rims(false).begin(), rims(false).end());
    SearchRounds both(image, true, options, level);
    both.begin(std::move(first));
    if (both.area() >= most_share * pixels_away_from(level, image)) return both.finish();
  }
  SearchRounds bright(image, true, options), dark(image, false, options);
  if (options.contrast != GrainContrast::dark) bright.begin(rims(true));
  if (options.contrast != GrainContrast::bright) dark.begin(rims(false));
  return bright.gain() >= dark.gain() ? bright.finish() : dark.finish();
}

}  // namespace

std::vector<double> levels_between(const FloatImage& image) {
  constexpr double least_share = 0.01;
  if (image.value.empty()) return {};
  const auto [low, high] = std::minmax_element(image.value.begin(), image.value.end());
  const statistics::Bins scale{static_cast<double>(*low),
                               (static_cast<double>(*high) - static_cast<double>(*low)) / bins, bins};
  if (!(scale.width > 0)) return {};
  const Levels count = smooth_histogram(image, scale);
  std::vector<std::size_t> peaks = peaks_of(count);
  std::erase_if(
      peaks, [&](std::size_t peak) { return members(count, peak) < least_share * static_cast<double>(image.size()); });
  if (peaks.size() < 3) return {};
  peaks.erase(peaks.begin());
  peaks.pop_back();
  std::ranges::stable_sort(peaks, std::greater{}, [&](std::size_t peak) { return members(count, peak); });
  return mapped(peaks, [&](std::size_t peak) { return scale.centre(peak); });
}

FoundCircles find_circles(const FloatImage& image, const CircleOptions& options) {
  check(image);
  const DiskSearch search = search_disks(image, options);
  const auto& disks = search.model.disks();
  const auto order =
      ordered_by(disks.size(), [&](std::size_t k) { return std::pair(disks[k].centre.y, disks[k].centre.x); });
  const auto errors = search.model.errors();
  const auto evidence = search.model.evidence();
  const auto brightness = mapped(disks, [&](const auto& disk) { return brightness_of(image, disk); });
  const std::vector<char> out =
      search.report.between ? pores(brightness, *search.report.between) : std::vector<char>(disks.size(), 0);
  FoundCircles found;
  for (const std::size_t k : order) {
    if (out[k] != 0) continue;
    found.grains.centre.push_back(disks[k].centre);
    found.grains.radius.push_back(disks[k].radius);
    found.grains.position_error.push_back(errors[k].position);
    found.grains.radius_error.push_back(errors[k].radius);
    found.grains.brightness.push_back(brightness[k]);
    found.grains.score.push_back(evidence[k].rim);
    found.grains.size_class.push_back(search.report.sizes.of[k]);
  }
  found.report = search.report;
  found.report.sizes.of = found.grains.size_class;
  part_materials(found, options);
  count_overlaps(found);
  return found;
}

void declare_rims(ParameterVisitor& v, GrainContrast& contrast, double& least_score) {
  v.choice({"contrast", "Whether grains are brighter or darker than what is between them."}, contrast,
           {{"found", "as the picture shows, some brighter and some darker, too"},
            {"bright", "brighter"},
            {"dark", "darker"}});
  v.number({"least_score", "Fraction of a grain's rim that must be visible."}, least_score, "", range::between(0, 1));
}

void declare(ParameterVisitor& v, CircleOptions& options) {
  v.numbers({"radii", "Radii of the size classes, in pixels; found automatically if not given."}, options.radii, "",
            range::positive);
  v.number({"smallest", "Smallest radius that is looked for where none are given, in pixels."}, options.smallest, "",
           range::positive);
  v.number({"largest",
            "Largest radius that is looked for where none are given, in pixels; 0: half the picture's smaller side."},
           options.largest, "", range::not_negative);
  v.integer({"materials", "Number of materials by brightness; 0: found automatically."}, options.materials,
            {0, 1'000'000});
  declare_rims(v, options.contrast, options.least_score);
}

}  // namespace arenite::imaging
