#include "thermal/imaging/disk_evidence.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/median.hpp"
#include "statistics/least_squares.hpp"
#include "thermal/imaging/disk_model.hpp"

namespace arenite::imaging {
namespace {

constexpr double least_explained =
    0.75;  // of a disk's squares; the rest is noise, marks, neighbours that are not found yet
constexpr double rim_of_usual = 0.8, unexplained_of_usual = 4,
                 few_unexplained = 0.05;     // against the median disk's; share that is never too much
constexpr double least_contrast = 0.2;       // of the usual contrast
constexpr double least_area = 0.005;         // share of all disks' area that a size needs
constexpr double other_size = 1.28;          // times the radius
constexpr double most_fitted_overlap = 0.3;  // of the smaller radius, in disks that are fitted

using Disks = std::vector<DiskModel::Disk>;
using Evidence = std::vector<DiskModel::Evidence>;

/// What the median disk by area has: many specks beside few grains do not set the measure.
template <class Of> double usual(const Disks& disks, const Evidence& evidence, Of&& of) {
  std::vector<std::pair<double, double>> value_area;
  for (std::size_t k = 0; k < disks.size(); ++k)
    value_area.emplace_back(of(evidence[k]), disks[k].radius * disks[k].radius);
  return weighted_median(std::move(value_area));
}

/// Marks dirt and spots: a size that makes up next to nothing of the area found.
void mark_specks(const Disks& disks, std::vector<char>& out) {
  double area = 0;
  for (const auto& disk : disks) area += disk.radius * disk.radius;
  for (std::size_t k = 0; k < disks.size(); ++k) {
    double alike = 0;
    for (const auto& disk : disks)
      if (disk.radius < other_size * disks[k].radius && other_size * disk.radius > disks[k].radius)
        alike += disk.radius * disk.radius;
    if (alike < least_area * area) out[k] = 1;
  }
}

/// Of two disks that overlap too much the one that shows less well.
void mark_overlapping(const Disks& disks, const Evidence& evidence, std::vector<char>& out) {
  for (std::size_t a = 0; a < disks.size(); ++a)
    for (std::size_t b = a + 1; b < disks.size(); ++b) {
      if (out[a] != 0 || out[b] != 0 ||
          std::abs(disks[a].centre.y - disks[b].centre.y) > disks[a].radius + disks[b].radius)
        continue;
      const double gap = norm(disks[a].centre - disks[b].centre) - disks[a].radius - disks[b].radius;
      if (gap > -most_fitted_overlap * std::min(disks[a].radius, disks[b].radius)) continue;
      out[evidence[a].explained * evidence[a].rim < evidence[b].explained * evidence[b].rim ? a : b] = 1;
    }
}

}  // namespace

/// The picture at a place (linear between pixels) with every other disk taken away, minus the background.
double DiskModel::alone(const Disk& disk, Vec2 place) const {
  const auto [x, y] = place;
  const int c = static_cast<int>(std::floor(x)), r = static_cast<int>(std::floor(y));
  double sum = 0;
  for (int j = r; j <= r + 1; ++j)
    for (int i = c; i <= c + 1; ++i) {
      if (i < 0 || j < 0 || i >= image_.width || j >= image_.height) return std::nan("");
      const std::size_t at = image_.index(i, j);
      const double own = (disk.level - static_cast<double>(background_[at])) * cover(disk, i, j).share;
      sum += (1 - std::abs(x - i)) * (1 - std::abs(y - j)) * (left(at) + own);
    }
  return sum;
}

std::vector<DiskModel::Evidence> DiskModel::evidence() const {
  std::vector<Evidence> all;
  for (const Disk& disk : disks_) {
    const double contrast = disk.level - background(disk.centre);
    const int angles = std::max(16, static_cast<int>(2 * std::numbers::pi * disk.radius));
    const double inner = disk.radius - 1 - blur_, outer = disk.radius + 1 + blur_;
    int seen = 0;
    for (int k = 0; k < angles; ++k) {
      const double a = 2 * std::numbers::pi * k / angles;
      const Vec2 outward{std::cos(a), std::sin(a)};
      if ((alone(disk, disk.centre + inner * outward) - alone(disk, disk.centre + outer * outward)) / contrast > 0.5)
        ++seen;
    }
    double with = 0, without = 0;
    each(disk, [&](int x, int y, std::size_t at) {
      const double c = cover(disk, x, y).share, rest = left(at);
      if (c < 0.5) return;  // what neighbours cover says nothing against this one
      const double own = (disk.level - static_cast<double>(background_[at])) * c;
      with += rest * rest;
      without += (rest + own) * (rest + own);
    });
    all.push_back({static_cast<double>(seen) / angles, without > 0 ? 1 - with / without : 0, contrast});
  }
  return all;
}

std::vector<DiskModel::Errors> DiskModel::errors() const {
  const auto n = disks_.size();
  std::vector<std::vector<std::size_t>> near(n);  // of each disk: itself, and those whose rims reach into its window
  for (std::size_t i = 0; i < n; ++i) {
    near[i] = {i};
    for (std::size_t j = 0; j < n; ++j)
      if (norm(disks_[i].centre - disks_[j].centre) < disks_[i].radius + disks_[j].radius + 4 * blur_ + 1 && i != j)
        near[i].push_back(j);
  }
  using Slope = std::array<double, 4>;
  using Block = std::array<Slope, 4>;  // of the normal matrix, between each disk and those near it
  std::vector<std::vector<Block>> block(n);
  const auto slope = [&](const Disk& d, int x, int y) {
    const auto [c, edge, outward] = cover(d, x, y);
    const double contrast = d.level - static_cast<double>(background_[image_.index(x, y)]);
    return Slope{contrast * edge * outward.x, contrast * edge * outward.y, contrast * edge, c};
  };
  for (std::size_t i = 0; i < n; ++i) {
    block[i].resize(near[i].size());
    each(disks_[i], [&](int x, int y, std::size_t) {
      const Slope own = slope(disks_[i], x, y);
      if (own[3] < 1e-5) return;
      for (std::size_t k = 0; k < near[i].size(); ++k) {
        const Slope other = k == 0 ? own : slope(disks_[near[i][k]], x, y);
        for (std::size_t a = 0; a < 4; ++a)
          for (std::size_t b = 0; b < 4; ++b) block[i][k][a][b] += own[a] * other[b];
      }
    });
    if (disks_[i].prior_error > 0)
      block[i][0][2][2] += noise_ * noise_ / (disks_[i].prior_error * disks_[i].prior_error);
  }
  std::vector<Errors> errors;
  for (const std::vector<std::size_t>& group : near) {
    statistics::Matrix normal(4 * group.size(), 4 * group.size());
    for (std::size_t a = 0; a < group.size(); ++a)
      for (std::size_t b = 0; b < group.size(); ++b) {
        const auto& others = near[group[a]];
        const auto at = std::find(others.begin(), others.end(), group[b]);
        if (at == others.end()) continue;
        const Block& own = block[group[a]][static_cast<std::size_t>(at - others.begin())];
        for (std::size_t k = 0; k < 4; ++k)
          for (std::size_t l = 0; l < 4; ++l)
            normal(4 * a + k, 4 * b + l) += 0.5 * own[k][l], normal(4 * b + l, 4 * a + k) += 0.5 * own[k][l];
      }
    double most = 0;
    for (std::size_t k = 0; k < normal.rows(); ++k) most = std::max(most, normal(k, k));
    for (std::size_t k = 0; k < normal.rows(); ++k) normal(k, k) += 1e-9 * most;
    const statistics::Matrix inverse = solve_symmetric(normal, statistics::identity(normal.rows(), 4));
    const auto error = [&](double inverse_of_normal) { return noise_ * std::sqrt(std::max(0.0, inverse_of_normal)); };
    errors.push_back({error(0.5 * (inverse(0, 0) + inverse(1, 1))), error(inverse(2, 2)), error(inverse(3, 3))});
  }
  return errors;
}

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
  if (strict)
    most_unexplained = std::min(most_unexplained, std::max(few_unexplained, unexplained_of_usual * usual_unexplained));
  for (std::size_t k = 0; k < disks.size(); ++k) {
    const double least = std::max(least_contrast * usual_contrast, 3 * model.noise() / disks[k].radius);
    if (evidence[k].rim < least_rim || 1 - evidence[k].explained > most_unexplained ||
        std::abs(evidence[k].contrast) < least)
      out[k] = 1;
    if (options.radii.empty() && disks[k].radius < 0.9 * std::max(options.smallest, least_resolved(model))) out[k] = 1;
  }
  mark_overlapping(disks, evidence, out);
  return out;
}

}  // namespace arenite::imaging
