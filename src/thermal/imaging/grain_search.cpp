#include "thermal/imaging/grain_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/mapped.hpp"
#include "core/median.hpp"

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

constexpr std::size_t most_levels = 2;
constexpr double most_share = 0.6;  // of the pixels on both sides of a level that disks must account for

/// Pixels that are farther from a level than half of what the farthest are.
double pixels_away_from(double level, const FloatImage& image) {
  std::vector<double> away = mapped(image.value, [&](float v) { return std::abs(static_cast<double>(v) - level); });
  const auto far = away.begin() + static_cast<std::ptrdiff_t>(away.size() * 9 / 10);
  std::nth_element(away.begin(), far, away.end());
  return static_cast<double>(std::count_if(away.begin(), away.end(), [half = *far / 2](double v) { return v > half; }));
}

constexpr double least_explained = 0.75;  // of a disk's squares; the rest is noise, marks, neighbours that are not found yet
constexpr double rim_of_usual = 0.8, unexplained_of_usual = 4, few_unexplained = 0.05;  // against the median disk's; share that is never too much
constexpr double least_contrast = 0.2;                                                  // of the usual contrast
constexpr double least_area = 0.005;                                                    // share of all disks' area that a size needs
constexpr double other_size = 1.28;                                                     // times the radius
constexpr double most_overlap = 0.3;                                                    // of the smaller radius, in disks that are fitted

using Disks = std::vector<DiskModel::Disk>;
using Evidence = std::vector<DiskModel::Evidence>;

/// What the median disk by area has: many specks beside few grains do not set the measure.
template <class Of> double usual(const Disks& disks, const Evidence& evidence, Of&& of) {
  std::vector<std::pair<double, double>> value_area;
  for (std::size_t k = 0; k < disks.size(); ++k) value_area.emplace_back(of(evidence[k]), disks[k].radius * disks[k].radius);
  return weighted_median(std::move(value_area));
}

/// Marks dirt and spots: a size that makes up next to nothing of the area found.
void mark_specks(const Disks& disks, std::vector<char>& out) {
  double area = 0;
  for (const auto& disk : disks) area += disk.radius * disk.radius;
  for (std::size_t k = 0; k < disks.size(); ++k) {
    double alike = 0;
    for (const auto& disk : disks)
      if (disk.radius < other_size * disks[k].radius && other_size * disk.radius > disks[k].radius) alike += disk.radius * disk.radius;
    if (alike < least_area * area) out[k] = 1;
  }
}

/// Of two disks that overlap too much the one that shows less well.
void mark_overlapping(const Disks& disks, const Evidence& evidence, std::vector<char>& out) {
  for (std::size_t a = 0; a < disks.size(); ++a)
    for (std::size_t b = a + 1; b < disks.size(); ++b) {
      if (out[a] != 0 || out[b] != 0 || std::abs(disks[a].centre.y - disks[b].centre.y) > disks[a].radius + disks[b].radius) continue;
      const double gap = norm(disks[a].centre - disks[b].centre) - disks[a].radius - disks[b].radius;
      if (gap > -most_overlap * std::min(disks[a].radius, disks[b].radius)) continue;
      out[evidence[a].explained * evidence[a].rim < evidence[b].explained * evidence[b].rim ? a : b] = 1;
    }
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

DiskSearch search_disks(const FloatImage& image, const CircleOptions& options) {
  std::array<std::optional<std::vector<Circle>>, 2> seen;
  const auto rims = [&](bool bright) -> const std::vector<Circle>& {  // searched once for all that begin with them
    auto& own = seen[bright ? 1 : 0];
    if (!own) own = search_rims(image, first_range(image, options, bright));
    return *own;
  };
  std::vector<double> levels;
  if (options.contrast == GrainContrast::found) levels = levels_between(image);
  levels.resize(std::min(levels.size(), most_levels));
  for (const double level : levels) {  // disks on both sides of it, if they account for most of what is not of that level
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

double least_resolved(const DiskModel& model) { return 2.5 * model.blur(); }

std::vector<char> refuted_disks(const DiskModel& model, const CircleOptions& options, bool strict) {
  const Disks& disks = model.disks();
  const Evidence evidence = model.evidence();
  std::vector<char> out(disks.size(), 0);
  if (options.radii.empty()) mark_specks(disks, out);
  const double usual_contrast = usual(disks, evidence, [](const auto& e) { return std::abs(e.contrast); });
  const double usual_rim = usual(disks, evidence, [](const auto& e) { return e.rim; });
  const double usual_unexplained = usual(disks, evidence, [](const auto& e) { return 1 - e.explained; });
  const double least_rim = std::max(options.least_score, strict ? rim_of_usual * usual_rim : 0.0);
  double most_unexplained = 1 - least_explained;
  if (strict) most_unexplained = std::min(most_unexplained, std::max(few_unexplained, unexplained_of_usual * usual_unexplained));
  for (std::size_t k = 0; k < disks.size(); ++k) {
    const double least = std::max(least_contrast * usual_contrast, 3 * model.noise() / disks[k].radius);
    if (evidence[k].rim < least_rim || 1 - evidence[k].explained > most_unexplained || std::abs(evidence[k].contrast) < least) out[k] = 1;
    if (options.radii.empty() && disks[k].radius < 0.9 * std::max(options.smallest, least_resolved(model))) out[k] = 1;
  }
  mark_overlapping(disks, evidence, out);
  return out;
}

}  // namespace arenite::imaging
