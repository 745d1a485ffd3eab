#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "core/vec.hpp"
#include "thermal/imaging/registration.hpp"

namespace arenite::imaging {

inline Vec2 place(const PictureGrains& grains, std::size_t k) { return {grains.x[k], grains.y[k]}; }
inline Vec2 place(const PictureGrains& grains, std::int32_t k) { return place(grains, static_cast<std::size_t>(k)); }
inline double mean_radius(const PictureGrains& grains) {
  return std::accumulate(grains.radius.begin(), grains.radius.end(), 0.0) / static_cast<double>(grains.size());
}

/// Places sorted into square cells, to ask what lies near a point.
class CentreGrid {
 public:
  CentreGrid(const std::vector<double>& x, const std::vector<double>& y, double cell) : x_(x), y_(y), cell_(cell) {
    const auto [x0, x1] = std::minmax_element(x.begin(), x.end());
    const auto [y0, y1] = std::minmax_element(y.begin(), y.end());
    origin_ = {*x0, *y0};
    // Cells never outnumber places by much, however far apart these lie.
    const double area = (*x1 - *x0) * (*y1 - *y0), longest = std::max(*x1 - *x0, *y1 - *y0), n = static_cast<double>(x.size());
    cell_ = std::max({cell_, std::sqrt(area / (4 * n)), longest / (4 * n)});
    columns_ = static_cast<int>((*x1 - *x0) / cell_) + 1;
    rows_ = static_cast<int>((*y1 - *y0) / cell_) + 1;
    start_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
    for (std::size_t k = 0; k < x.size(); ++k) ++start_[cell_of(k) + 1];
    for (std::size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
    auto next = start_;
    member_.resize(x.size());
    for (std::size_t k = 0; k < x.size(); ++k) member_[next[cell_of(k)]++] = static_cast<std::int32_t>(k);
  }

  /// Calls visit(index, squared distance) for every place no farther than `reach`.
  template <class Visit>
  void within(Vec2 p, double reach, Visit visit) const {
    const int c0 = clamped((p.x - reach - origin_.x) / cell_, columns_), c1 = clamped((p.x + reach - origin_.x) / cell_, columns_);
    const int r0 = clamped((p.y - reach - origin_.y) / cell_, rows_), r1 = clamped((p.y + reach - origin_.y) / cell_, rows_);
    for (int r = r0; r <= r1; ++r)
      for (std::size_t k = start_[at(c0, r)]; k < start_[at(c1, r) + 1]; ++k) {
        const auto i = static_cast<std::size_t>(member_[k]);
        const double dx = x_[i] - p.x, dy = y_[i] - p.y, square = dx * dx + dy * dy;
        if (square <= reach * reach) visit(member_[k], square);
      }
  }

  /// The nearest place no farther than `reach`, or -1.
  std::int32_t nearest(Vec2 p, double reach) const {
    std::int32_t best = -1;
    double least = reach * reach;
    within(p, reach, [&](std::int32_t k, double square) {
      if (best >= 0 && square >= least) return;
      best = k;
      least = square;
    });
    return best;
  }

 private:
  static int clamped(double cell, int n) { return static_cast<int>(std::clamp(cell, 0.0, n - 1.0)); }
  std::size_t at(int column, int row) const { return static_cast<std::size_t>(column) + static_cast<std::size_t>(columns_) * static_cast<std::size_t>(row); }
  std::size_t cell_of(std::size_t k) const { return at(clamped((x_[k] - origin_.x) / cell_, columns_), clamped((y_[k] - origin_.y) / cell_, rows_)); }

  const std::vector<double>&x_, &y_;
  double cell_;
  Vec2 origin_;
  int columns_ = 0, rows_ = 0;
  std::vector<std::size_t> start_;
  std::vector<std::int32_t> member_;
};

/// The search of register_circles: transforms from pairs of grains, held against their neighbours, grown over the picture.
class RegistrationSearch {
 public:
  using Pairs = std::vector<std::pair<std::int32_t, std::int32_t>>;

  RegistrationSearch(const PictureGrains& from, const PictureGrains& to, const RegistrationOptions& options);

  /// The transform that speaks for itself best, and its pairs; no pairs where there is none.
  Pairs best(Similarity& transform);
  /// Grains whose places agree under a transform, each once: of two that want one partner the nearer has it.
  Pairs matches(const Similarity& t, std::span<const std::int32_t> of) const;
  Similarity fit(const Pairs& pairs, bool mirrored) const;
  std::vector<std::int32_t> all() const;

 private:
  /// A transform with what it matches, and its score with 12, 24, 48, ... grains around its base.
  struct Candidate {
    Similarity transform;
    Pairs pairs;
    std::vector<double> score;
    double total() const { return score.empty() ? 0 : score.back(); }
  };

  bool alike(double scale, std::size_t a, std::size_t b) const;
  std::int32_t partner(const Similarity& t, std::int32_t a) const;
  double score(const Similarity& t, const Pairs& pairs) const;
  bool same(const Similarity& s, const Similarity& t) const;
  std::vector<std::int32_t> around(Vec2 middle) const;
  std::size_t other_end(std::size_t first) const;
  std::pair<double, double> scales(std::size_t a, std::size_t b) const;
  std::vector<std::size_t> reaches() const;
  void try_base(std::size_t first, Candidate& best) const;
  void grow(Similarity t, const std::vector<std::int32_t>& order, Candidate& best) const;

  const PictureGrains &from_, &to_;
  const RegistrationOptions& options_;
  CentreGrid from_grid_, to_grid_;
};

}  // namespace arenite::imaging
