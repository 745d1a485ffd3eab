#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/vec2.hpp"

namespace arenite::imaging {

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

}  // namespace arenite::imaging
