#include "thermal/imaging/grain_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/median.hpp"

namespace arenite::imaging {
namespace {

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
      if (out[a] != 0 || out[b] != 0 || std::abs(disks[a].y - disks[b].y) > disks[a].radius + disks[b].radius) continue;
      const double gap = std::hypot(disks[a].x - disks[b].x, disks[a].y - disks[b].y) - disks[a].radius - disks[b].radius;
      if (gap > -most_overlap * std::min(disks[a].radius, disks[b].radius)) continue;
      out[evidence[a].explained * evidence[a].rim < evidence[b].explained * evidence[b].rim ? a : b] = 1;
    }
}

}  // namespace

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
