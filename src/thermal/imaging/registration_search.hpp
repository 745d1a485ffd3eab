#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "core/mapped.hpp"
#include "core/median.hpp"
#include "geometry/cell_grid.hpp"
#include "thermal/imaging/registration.hpp"

namespace arenite::imaging {

/// Transforms from pairs of grains, held against their neighbours, grown over the picture: the search of
/// register_circles.
class RegistrationSearch {
 public:
  using Pairs = decltype(Registration::pairs);

  RegistrationSearch(const PictureGrains& from, const PictureGrains& to, const RegistrationOptions& options)
      : from_(from),
        to_(to),
        options_(options),
        to_grid_(grid_over(to)),
        all_(from.size()) {
    std::iota(all_.begin(), all_.end(), 0);
    for (std::size_t reach = test_grains; reach < from.size(); reach *= 2) reaches_.push_back(reach);
    reaches_.push_back(from.size());
  }

  /// The transform that speaks for itself best, and its pairs; no pairs where there is none.
  Pairs best(Similarity& transform) const {
    const std::size_t n = from_.size(), bases = std::min(n, most_bases);
    std::size_t stride = std::max<std::size_t>(1, static_cast<std::size_t>(0.618 * static_cast<double>(n))),
                agreeing = 0;
    while (std::gcd(stride, n) != 1) ++stride;
    Candidate best;
    for (std::size_t k = 0; k < bases && agreeing < agreeing_bases; ++k) {
      const Similarity before = best.transform;
      const bool first = best.pairs.empty();
      try_base(k * stride % n, best);
      if (best.pairs.empty()) continue;
      agreeing = !first && same(before, best.transform) ? agreeing + 1 : 1;
    }
    transform = best.transform;
    return best.pairs;
  }

  /// Fits a transform to all grains whose places agree under it, but for those that lie far off against the median:
  /// these are other grains, or were found badly.
  Pairs refine(Similarity& t) const {
    Pairs pairs = matches(t, all_);
    const std::vector<double> away = mapped(pairs, [&](const auto& pair) { return distance(t, pair); });
    const double most = outlier * std::max(median(away) / median_of_plane_distance, 1e-9 * mean_radius(to_));
    std::size_t kept = 0;
    for (std::size_t k = 0; k < pairs.size(); ++k)
      if (away[k] <= most) pairs[kept++] = pairs[k];
    if (kept >= 3) pairs.resize(kept);
    t = fit(pairs, t.mirrored);
    return pairs;
  }

  double distance(const Similarity& t, const Pairs::value_type& pair) const {
    return norm(t(from_.centre[pair.first]) - to_.centre[pair.second]);
  }

 private:
  static constexpr double reach_of_match = 0.3;  // of the smaller radius: two different grains cannot both be so near
  static constexpr double sharpest = 0.02;       // of a radius: what lies nearer than this is not told apart
  static constexpr double base_length = 10;  // mean radii: long enough to tell the direction, short enough to be whole
  static constexpr std::size_t most_bases = 60, test_grains = 12, agreeing_bases = 3;
  static constexpr double of_best[] = {0.75, 0.8, 0.85,
                                       0.9};  // score of the best so far below which growing ends, stage by stage
  static constexpr double outlier = 4;        // standard deviations

  static double mean_radius(const PictureGrains& grains) {
    return std::accumulate(grains.radius.begin(), grains.radius.end(), 0.0) / static_cast<double>(grains.size());
  }

  /// The grains of a picture in cells as wide as they are, but never many more cells than grains, however far apart
  /// these lie.
  static geometry::PointGrid grid_over(const PictureGrains& grains) {
    const geometry::Rectangle box = geometry::bounds(grains.centre);
    const double width = box.width(), height = box.height(), n = static_cast<double>(grains.size());
    return {grains.centre, std::max({2 * mean_radius(grains), std::sqrt(width * height / (4 * n)),
                                     std::max(width, height) / (4 * n)})};
  }

  /// A transform with what it matches, and its score with 12, 24, 48, ... grains around its base.
  struct Candidate {
    Similarity transform;
    Pairs pairs;
    std::vector<double> score;
    double total() const { return score.empty() ? 0 : score.back(); }
  };

  /// Grains whose places agree under a transform, each once: of two that want one partner the nearer has it.
  Pairs matches(const Similarity& t, std::span<const std::int32_t> of) const {
    std::vector<std::pair<double, Pairs::value_type>> all;
    for (const std::int32_t a : of)
      if (const std::int32_t b = partner(t, a); b >= 0) all.push_back({distance(t, {a, b}), {a, b}});
    std::sort(all.begin(), all.end());
    std::vector<char> taken(to_.size(), 0);
    Pairs pairs;
    for (const auto& [distance, pair] : all)
      if (taken[static_cast<std::size_t>(pair.second)]++ == 0) pairs.push_back(pair);
    std::sort(pairs.begin(), pairs.end());
    return pairs;
  }

  Similarity fit(const Pairs& pairs, bool mirrored) const {
    return fit_similarity(mapped(pairs, [&](const auto& pair) { return from_.centre[pair.first]; }),
                          mapped(pairs, [&](const auto& pair) { return to_.centre[pair.second]; }), mirrored);
  }

  bool alike(double scale, std::size_t a, std::size_t b) const {
    return options_.radius_within <= 0 ||
           std::abs(std::log(scale * from_.radius[a] / to_.radius[b])) <= std::log1p(options_.radius_within);
  }

  /// The nearest grain that may be the same under a transform, or -1.
  std::int32_t partner(const Similarity& t, std::int32_t a) const {
    const auto k = static_cast<std::size_t>(a);
    std::int32_t b = -1;
    double least = 0;
    to_grid_.within(t(from_.centre[k]), reach_of_match * t.scale * from_.radius[k],
                    [&](std::int32_t near, double square) {
                      if (b < 0 || square < least) b = near, least = square;
                    });
    const bool same = b >= 0 && alike(t.scale, k, static_cast<std::size_t>(b)) &&
                      distance(t, {a, b}) <= reach_of_match * to_.radius[static_cast<std::size_t>(b)];
    return same ? b : -1;
  }

  /// Sum over pairs of how much nearer the two are than chance would have them (logarithm of the areas): in an ordered
  /// packing a shift by one grain matches as many, but none of them well.
  double score(const Similarity& t, const Pairs& pairs) const {
    double sum = 0;
    for (const auto& pair : pairs) {
      const double off = distance(t, pair) / to_.radius[static_cast<std::size_t>(pair.second)];
      sum += std::log(reach_of_match * reach_of_match / (off * off + sharpest * sharpest));
    }
    return sum;
  }

  /// Whether two transforms bring the outermost grains to the same places.
  bool same(const Similarity& s, const Similarity& t) const {
    const auto [left, right, top, bottom] = geometry::bounds(from_.centre);
    return std::ranges::all_of(
        std::array{Vec2{left, top}, Vec2{right, top}, Vec2{left, bottom}, Vec2{right, bottom}},
        [&](Vec2 corner) { return norm(s(corner) - t(corner)) <= reach_of_match * mean_radius(to_); });
  }

  /// All grains of `from`, the nearest to a place first.
  std::vector<std::int32_t> around(Vec2 middle) const {
    std::vector<std::int32_t> index = all_;
    std::ranges::stable_sort(index, {},
                             [&](std::int32_t a) { return dot(from_.centre[a] - middle, from_.centre[a] - middle); });
    return index;
  }

  /// The grain whose distance from `first` is nearest to the length of a base.
  std::size_t other_end(std::size_t first) const {
    const auto off = mapped(from_.centre, [&, wanted = base_length * mean_radius(from_)](Vec2 centre) {
      const double away = norm(centre - from_.centre[first]);
      return away > 0 ? std::abs(away - wanted) : INFINITY;
    });
    return static_cast<std::size_t>(std::ranges::min_element(off) - off.begin());
  }

  /// Scales that are looked at where a grain is held against another.
  std::pair<double, double> scales(std::size_t a, std::size_t b) const {
    if (options_.scale)
      return {*options_.scale * (1 - options_.scale_within), *options_.scale * (1 + options_.scale_within)};
    const double within = options_.radius_within > 0 ? 1 + options_.radius_within : 2,
                 ratio = to_.radius[b] / from_.radius[a];
    return {ratio / within, ratio * within};
  }

  void try_base(std::size_t a0, Candidate& best) const {
    const std::size_t a1 = other_end(a0);
    const Vec2 ends[2] = {from_.centre[a0], from_.centre[a1]};
    const double length = norm(ends[1] - ends[0]);
    if (length == 0) return;  // all grains are in one place
    const std::vector<std::int32_t> order = around(0.5 * (ends[0] + ends[1]));
    best.score.clear();  // the best so far is to be beaten among the grains around this base, too
    for (const std::size_t reach : reaches_)
      if (!best.pairs.empty())
        best.score.push_back(score(best.transform, matches(best.transform, std::span(order).first(reach))));
    for (std::size_t b0 = 0; b0 < to_.size(); ++b0) {
      const auto [low, high] = scales(a0, b0);
      to_grid_.within(to_.centre[b0], high * length, [&, low = low](std::int32_t k, double square) {
        const auto b1 = static_cast<std::size_t>(k);
        const double scale = std::sqrt(square) / length;
        if (scale < low || scale == 0 || !alike(scale, a0, b0) || !alike(scale, a1, b1)) return;
        const Vec2 targets[2] = {to_.centre[b0], to_.centre[b1]};
        if (options_.mirror != Mirror::yes) grow(fit_similarity(ends, targets, false), order, best);
        if (options_.mirror != Mirror::no) grow(fit_similarity(ends, targets, true), order, best);
      });
    }
  }

  /// Holds a transform against the grains around its base and, while it keeps up with the best, fits it to twice as
  /// many.
  void grow(Similarity t, const std::vector<std::int32_t>& order, Candidate& best) const {
    const std::size_t tests = reaches_.front(), allowed = (2 * tests) / 5;
    std::size_t failed = 0;
    for (std::size_t k = 0; k < tests && failed <= allowed; ++k)
      if (partner(t, order[k]) < 0) ++failed;
    if (failed > allowed) return;
    Candidate here;
    for (std::size_t stage = 0; stage < reaches_.size(); ++stage) {
      for (int pass = 0; pass < 2; ++pass) {
        here.pairs = matches(t, std::span(order).first(reaches_[stage]));
        if (here.pairs.size() < 2) return;
        t = fit(here.pairs, t.mirrored);
      }
      here.score.push_back(score(t, here.pairs));
      if (stage < best.score.size() && here.score[stage] < of_best[std::min<std::size_t>(stage, 3)] * best.score[stage])
        return;
    }
    if (here.total() <= best.total()) return;
    here.transform = t;
    best = std::move(here);
  }

  const PictureGrains &from_, &to_;
  const RegistrationOptions& options_;
  geometry::PointGrid to_grid_;
  std::vector<std::int32_t> all_;     ///< grains of `from`
  std::vector<std::size_t> reaches_;  ///< how many grains around its base a transform is held against, step by step
};

}  // namespace arenite::imaging
