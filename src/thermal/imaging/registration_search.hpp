#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "core/vec.hpp"
#include "geometry/cell_grid.hpp"
#include "thermal/imaging/registration.hpp"

namespace arenite::imaging {

inline double mean_radius(const PictureGrains& grains) {
  return std::accumulate(grains.radius.begin(), grains.radius.end(), 0.0) / static_cast<double>(grains.size());
}

/// Places sorted into square cells, to ask what lies near a point.
class CentreGrid {
 public:
  explicit CentreGrid(const PictureGrains& grains)
      : grains_(grains),
        grid_(grid_over(grains)),
        cells_(grid_.size(), 0, grains.size(), [&](std::size_t k) { return grid_.cell(grains.centre[k]); }) {}

  /// Calls visit(index, squared distance) for every place no farther than `reach`.
  template <class Visit> void within(Vec2 p, double reach, Visit visit) const {
    const auto at = [&](double x, std::int32_t row) { return static_cast<std::size_t>(row * grid_.count[0] + grid_.along(0, x)); };
    for (std::int32_t row = grid_.along(1, p.y - reach); row <= grid_.along(1, p.y + reach); ++row)
      for (std::int32_t k = cells_.first[at(p.x - reach, row)]; k < cells_.first[at(p.x + reach, row) + 1]; ++k) {
        const std::int32_t item = cells_.item[static_cast<std::size_t>(k)];
        const Vec2 away = grains_.centre[item] - p;
        if (const double square = dot(away, away); square <= reach * reach) visit(item, square);
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
  /// Cells as wide as a grain, but never many more than places, however far apart these lie.
  static geometry::CellGrid<2> grid_over(const PictureGrains& g) {
    const geometry::Rectangle box = geometry::bounds(g.centre);
    const double width = box.width(), height = box.height(), n = static_cast<double>(g.size());
    return {{{box.x_min, box.y_min}, {width, height}}, std::max({2 * mean_radius(g), std::sqrt(width * height / (4 * n)), std::max(width, height) / (4 * n)})};
  }

  const PictureGrains& grains_;
  geometry::CellGrid<2> grid_;
  geometry::SortedCells cells_;
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
  CentreGrid to_grid_;
};

}  // namespace arenite::imaging
