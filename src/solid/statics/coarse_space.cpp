#include "solid/statics/coarse_space.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "core/joined_sets.hpp"
#include "core/pages.hpp"
#include "solid/statics/cholesky.hpp"
#include "solid/statics/couplings.hpp"

namespace arenite::statics {

namespace {

/// Where a corner of one cell lies, as seen from another: visit(corner) for each that it is of the other.
template <int D, class Visit>
void each_same_corner(const Aggregates::Aggregate& p, const Aggregates::Aggregate& q, const std::array<int, 3>& cells,
                      bool periodic, int a, int axis, int found, const Visit& visit) {
  if (axis == D) {
    visit(found);
    return;
  }
  const auto k = static_cast<std::size_t>(axis);
  const int at = (a >> axis & 1) + p.cell[k] - q.cell[k];
  for (const int turn : {0, cells[k], -cells[k]}) {
    if (turn != 0 && !periodic) break;
    if (const int here = at + turn; here == 0 || here == 1)
      each_same_corner<D>(p, q, cells, periodic, a, axis + 1, found | here << axis, visit);
  }
}

/// Coarse nodes up to which a factor is cheaper than the third level. In the plane it always is.
constexpr std::int32_t most_direct(int dimension) {
  return dimension == 2 ? std::numeric_limits<std::int32_t>::max() : 2000;
}

}  // namespace

template <int D>
CoarseSpaceIn<D>::CoarseSpaceIn(const Grid& grid, Aggregates aggregates, const GalerkinSums<D>& sums,
                                const std::vector<std::uint8_t>& prescribed, const ThreadPool* pool)
    : grid_(grid),
      aggregates_(std::move(aggregates)),
      pool_(pool) {
  number_corners(sums);
  list_runs(prescribed);
  factorise(sums);
  aggregates_.of_node = {};  // runs tell it from here on
  load_.resize(static_cast<std::size_t>(D * nodes_));
  moments_.resize(D * moments * aggregates_.list.size());
}

template <int D> BlockMatrix CoarseSpaceIn<D>::stiffened(const GalerkinSums<D>& sums) const {
  BlockMatrix matrix = pattern(sums);
  const double stiffest_corner = assemble(sums, matrix);
  // An aggregate of few nodes carries more functions than it has freedoms, and a hat may vanish on all of its nodes: a
  // trace of stiffness on the diagonal keeps these apart and is too small to slow anything down.
  const auto diagonal = [&](std::int32_t c, int a) -> double& {
    return matrix
        .value[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(matrix.column_begin[c]) * D * D + a * (D + 1))];
  };
  const auto trace = [&](std::int32_t c) {
    double sum = 0;
    for (int a = 0; a < D; ++a) sum += diagonal(c, a);
    return sum;
  };
  double stiffest = 0;
  for (std::int32_t c = 0; c < matrix.columns(); ++c) stiffest = std::max(stiffest, trace(c));
  // Nothing holds a periodic sample: one coarse node is held, as firmly as a corner of a cell by the others.
  for (int a = 0; grid_.periodic && a < D; ++a) diagonal(0, a) += stiffest_corner;
  double extra = 1e-7;
  for (int time = 0; time <= repairs_; ++time, extra *= 100)
    for (std::int32_t c = 0; c < matrix.columns(); ++c) {
      const double more = extra * trace(c) + 1e-3 * extra * stiffest;
      for (int a = 0; a < D; ++a) diagonal(c, a) += more;
    }
  return matrix;
}

template <int D> void CoarseSpaceIn<D>::factorise(const GalerkinSums<D>& sums) {
  // A repair works the sums out anew: kept, the matrix would lie beside its factor when most memory is held.
  for (;; ++repairs_) {
    if (nodes_ > most_direct(D)) cycle_.emplace(stiffened(sums), places(), pool_);
    else factor_.emplace(stiffened(sums));
    if ((cycle_ ? cycle_->positive() : factor_->positive()) || repairs_ == 3) break;
  }
}

template <int D> std::vector<CoarsePlace> CoarseSpaceIn<D>::places() const {
  std::vector<CoarsePlace> places(static_cast<std::size_t>(nodes_));
  for (std::int32_t p = 0; p < aggregates_.count(); ++p) {
    const Aggregates::Aggregate& own = aggregates_.list[p];
    for (int a = 0; a < corners<D>; ++a)
      places[static_cast<std::size_t>(corner(p, a))] = {
          own.owner, {own.cell[0] + (a & 1), own.cell[1] + (a >> 1 & 1), own.cell[2] + (a >> 2)}};
  }
  return places;
}

template <int D> void CoarseSpaceIn<D>::solve() {
  if (cycle_) cycle_->solve(load_);
  else factor_->solve(load_);
}

template <int D> void CoarseSpaceIn<D>::number_corners(const GalerkinSums<D>& sums) {
  const std::size_t all = corners<D> * aggregates_.list.size();
  std::array<int, 3> cells;
  for (std::size_t k = 0; k < 3; ++k) cells[k] = (grid_.size()[k] + aggregates_.side - 1) / aggregates_.side;
  JoinedSets sets(all);
  for (const auto& [pp, qq] : sums.pairs) {
    const Aggregates::Aggregate &p = aggregates_.list[pp], &q = aggregates_.list[qq];
    if ((pp == qq && !grid_.periodic) || p.owner != q.owner) continue;
    for (int a = 0; a < corners<D>; ++a)
      each_same_corner<D>(p, q, cells, grid_.periodic, a, 0, 0,
                          [&, from = corners<D> * pp + a, to = qq](int b) { sets.join(from, corners<D> * to + b); });
  }
  corner_.resize(all);
  nodes_ = 0;
  for (std::size_t k = 0; k < all; ++k) {
    const auto root = static_cast<std::size_t>(sets.find(static_cast<std::int32_t>(k)));
    corner_[k] = root == k ? nodes_++ : corner_[root];
  }
}

template <int D> BlockMatrix CoarseSpaceIn<D>::pattern(const GalerkinSums<D>& sums) const {
  // Every coupling of corners goes into the column of its lower coarse node.
  const auto columns = static_cast<std::size_t>(nodes_);
  const auto each = [&](auto&& visit) {
    for (const auto& [p, q] : sums.pairs)
      for (int a = 0; a < corners<D>; ++a)
        for (int b = p == q ? a : 0; b < corners<D>; ++b) {
          const auto m = corner(p, a), n = corner(q, b);
          visit(static_cast<std::size_t>(std::min(m, n)), std::max(m, n));
        }
  };
  std::vector<std::int64_t> begin(columns + 1, 0);
  each([&](std::size_t column, std::int32_t) { ++begin[column + 1]; });
  for (std::size_t k = 0; k < columns; ++k) begin[k + 1] += begin[k];
  Buffer<std::int32_t> rows(static_cast<std::size_t>(begin[columns]));
  auto at = begin;
  each([&](std::size_t column, std::int32_t row) { rows[static_cast<std::size_t>(at[column]++)] = row; });
  BlockMatrix matrix;
  matrix.side = D;
  matrix.column_begin.assign(1, 0);
  reserve_in_large_pages(matrix.row, rows.size());
  for (std::size_t k = 0; k < columns; ++k) {
    const auto first = rows.begin() + begin[k], last = rows.begin() + begin[k + 1];
    std::sort(first, last);
    matrix.row.insert(matrix.row.end(), first, std::unique(first, last));
    matrix.column_begin.push_back(static_cast<std::int32_t>(matrix.row.size()));
  }
  reserve_in_large_pages(matrix.value, D * D * matrix.row.size());
  matrix.value.assign(D * D * matrix.row.size(), 0.0);
  return matrix;
}

template <int D> double CoarseSpaceIn<D>::assemble(const GalerkinSums<D>& sums, BlockMatrix& matrix) const {
  double stiffest_corner = 0;
  const auto block_at = [&](std::int32_t row, std::int32_t column) {
    const auto first = matrix.row.begin() + matrix.column_begin[column],
               last = matrix.row.begin() + matrix.column_begin[static_cast<std::size_t>(column) + 1];
    return &matrix.value[static_cast<std::size_t>(std::lower_bound(first, last, row) - matrix.row.begin()) * D * D];
  };
  sums.each(aggregates_, [&](const CouplingIn<D>& c) {
    for (int a = 0; a < corners<D>; ++a)
      for (int b = c.p == c.q ? a : 0; b < corners<D>; ++b) {
        const std::int32_t m = corner(c.p, a), n = corner(c.q, b);
        const auto stiffness = [&](int of_p, int of_q) {
          return c.block[static_cast<std::size_t>(D * of_p + of_q)][static_cast<std::size_t>(a)][b];
        };
        // Two corners that share a coarse node: then the block and its transpose both land on the diagonal.
        const bool twice = m == n && !(c.p == c.q && a == b);
        stiffest_corner = std::max(stiffest_corner, stiffness(0, 0));
        double* to = block_at(std::max(m, n), std::min(m, n));
        for (int s = 0; s < D; ++s)
          for (int r = 0; r < D; ++r)
            *to++ += twice ? stiffness(r, s) + stiffness(s, r) : m >= n ? stiffness(r, s) : stiffness(s, r);
      }
  });
  return stiffest_corner;
}

template <int D> void CoarseSpaceIn<D>::list_runs(const std::vector<std::uint8_t>& prescribed) {
  const int side = aggregates_.side;
  for (int z = 0; z < grid_.depth; ++z) {
    for (int y = 0; y < grid_.height; ++y)
      for (int x = 0; x < grid_.width;) {
        const std::ptrdiff_t i = grid_.index(x, y, z);
        const std::int32_t aggregate = aggregates_.of_node[i];
        const int end = std::min(grid_.width, (x / side + 1) * side);
        int length = 1;
        while (x + length < end && aggregates_.of_node[i + length] == aggregate) ++length;
        const auto level = static_cast<std::size_t>(grid_.in_space() ? z : y);
        if (aggregate >= 0) {
          runs_.push_back({i, aggregate, static_cast<std::int16_t>(length), static_cast<std::int16_t>(x % side),
                           static_cast<std::int16_t>(y % side), static_cast<std::int16_t>(z % side),
                           prescribed[level] == normal_component<D>});
        }
        x += length;
      }
    if ((z + 1) % side == 0 || z + 1 == grid_.depth) layer_begin_.push_back(runs_.size());
  }
}

template <int D> void CoarseSpaceIn<D>::take_moments(std::size_t layer, PointersIn<D, const float> r) {
  for (std::size_t n = layer_begin_[layer]; n < layer_begin_[layer + 1]; ++n) {
    const Run& run = runs_[n];
    const auto from = static_cast<float>(run.x);
    const auto monomials = run.monomials();
    const float* at[D];
    float sum[D] = {}, first[D] = {};
    for (int c = 0; c < D; ++c) at[c] = r[c] + run.begin;
    for (int k = 0; k < run.length; ++k) {
      const auto along = static_cast<float>(k);
#pragma GCC unroll 3
      for (int c = 0; c < D; ++c) {
        sum[c] += at[c][k];
        first[c] += along * at[c][k];
      }
    }
    if (run.slides) sum[D - 1] = first[D - 1] = 0;
    float* m = &moments_[D * moments * static_cast<std::size_t>(run.aggregate)];
    for (int c = 0; c < D; ++c, m += moments) {
      first[c] += from * sum[c];
#pragma GCC unroll 4
      for (std::size_t k = 0; k < moments / 2; ++k) {
        m[2 * k] += monomials[k] * sum[c];
        m[2 * k + 1] += monomials[k] * first[c];
      }
    }
  }
}

template <int D> void CoarseSpaceIn<D>::correct(PointersIn<D, const float> r, PointersIn<D, float> z) {
  std::fill(moments_.begin(), moments_.end(), 0.0f);
  const std::size_t layers = layer_begin_.size() - 1;
  for_each(pool_, layers, [&](std::size_t layer) { take_moments(layer, r); });
  std::fill(load_.begin(), load_.end(), 0.0);
  const double h = 1.0 / aggregates_.side;
  const auto each_part = [&](const auto& visit) {
    for (std::int32_t p = 0; p < aggregates_.count(); ++p)
      for (int c = 0; c < D; ++c) visit(p, c, &moments_[static_cast<std::size_t>((p * D + c) * moments)]);
  };
  const auto load = [&](std::int32_t p, int a, int c) -> double& {
    return load_[static_cast<std::size_t>(D * corner(p, a) + c)];
  };
  each_part([&](std::int32_t p, int c, const float* m) {
    std::array<double, corners<D>> weight;
    to_corners(m, h, weight);
    for (int a = 0; a < corners<D>; ++a) load(p, a, c) += weight[static_cast<std::size_t>(a)];
  });
  solve();
  each_part([&](std::int32_t p, int c, float* m) {
    std::array<double, corners<D>> u;
    for (int a = 0; a < corners<D>; ++a) u[static_cast<std::size_t>(a)] = load(p, a, c);
    to_polynomial(u, h, m);
  });
  for_each(pool_, layers, [&](std::size_t layer) { add_answer(layer, z); });
}

template <int D> void CoarseSpaceIn<D>::add_answer(std::size_t layer, PointersIn<D, float> z) const {
  for (std::size_t n = layer_begin_[layer]; n < layer_begin_[layer + 1]; ++n) {
    const Run& run = runs_[n];
    const auto from = static_cast<float>(run.x);
    const auto monomials = run.monomials();
    const float* m = &moments_[D * moments * static_cast<std::size_t>(run.aggregate)];
    float* at[D];
    float value[D] = {}, slope[D] = {};
    for (int c = 0; c < D; ++c, m += moments) {
      at[c] = z[c] + run.begin;
      if (run.slides && c == D - 1) continue;
#pragma GCC unroll 4
      for (std::size_t k = 0; k < moments / 2; ++k) {
        value[c] += monomials[k] * m[2 * k];
        slope[c] += monomials[k] * m[2 * k + 1];
      }
      value[c] += from * slope[c];
    }
    for (int k = 0; k < run.length; ++k) {
      const auto along = static_cast<float>(k);
#pragma GCC unroll 3
      for (int c = 0; c < D; ++c) at[c][k] += value[c] + along * slope[c];
    }
  }
}

template class CoarseSpaceIn<2>;
template class CoarseSpaceIn<3>;

}  // namespace arenite::statics
