#include "solid/statics/coarse_space.hpp"

#include <algorithm>
#include <utility>

#include "core/joined_sets.hpp"
#include "solid/statics/cholesky.hpp"
#include "solid/statics/couplings.hpp"

namespace arenite::statics {

namespace {

/// A block of the coarse matrix, in a column that is known.
struct Entry {
  std::int32_t row;
  double value[4];
};

/// Adds up the entries of each column k, begin[k] to begin[k + 1] - 1, by row.
BlockMatrix gathered(const std::vector<std::int64_t>& begin, const std::vector<Entry>& entries) {
  const std::size_t columns = begin.size() - 1;
  BlockMatrix matrix;
  matrix.column_begin.assign(1, 0);
  matrix.row.reserve(entries.size() / 3);
  matrix.value.reserve(4 * entries.size() / 3);
  std::vector<std::int32_t> place(columns, -1), rows;
  std::vector<double> sums;
  for (std::size_t k = 0; k < columns; ++k) {
    rows.clear();
    sums.clear();
    for (auto e = begin[k]; e < begin[k + 1]; ++e) {
      const Entry& entry = entries[e];
      auto& p = place[entry.row];
      if (p < 0) {
        p = static_cast<std::int32_t>(rows.size());
        rows.push_back(entry.row);
        sums.resize(sums.size() + 4, 0);
      }
      for (unsigned s = 0; s < 4; ++s) sums[4 * static_cast<std::size_t>(p) + s] += entry.value[s];
    }
    std::sort(rows.begin(), rows.end());
    for (const auto r : rows) {
      const auto p = static_cast<std::size_t>(place[r]);
      matrix.row.push_back(r);
      matrix.value.insert(matrix.value.end(), &sums[4 * p], &sums[4 * p] + 4);
    }
    for (const auto r : rows) place[r] = -1;
    matrix.column_begin.push_back(static_cast<std::int32_t>(matrix.row.size()));
  }
  return matrix;
}

}  // namespace

CoarseSpace::CoarseSpace(const Grid& grid, Aggregates aggregates, const std::vector<Coupling>& sums,
                         const std::vector<std::uint8_t>& prescribed)
    : grid_(grid),
      aggregates_(std::move(aggregates)) {
  number_corners(sums);
  list_runs(prescribed);
  BlockMatrix matrix = assemble(sums);
  // An aggregate of few nodes carries more functions than it has freedoms, and a hat may vanish on all of its nodes: a
  // trace of stiffness on the diagonal keeps these apart and is too small to slow anything down.
  const auto diagonal_block = [&](std::int32_t c) {
    return &matrix.value[4 * static_cast<std::size_t>(matrix.column_begin[c])];
  };
  double stiffest = 0;
  for (std::int32_t c = 0; c < matrix.columns(); ++c)
    stiffest = std::max(stiffest, diagonal_block(c)[0] + diagonal_block(c)[3]);
  for (double extra = 1e-7;; extra *= 100, ++repairs_) {
    for (std::int32_t c = 0; c < matrix.columns(); ++c) {
      double* block = diagonal_block(c);
      const double more = extra * (block[0] + block[3]) + 1e-3 * extra * stiffest;
      block[0] += more;
      block[3] += more;
    }
    factor_.emplace(matrix);
    if (factor_->positive() || repairs_ == 3) break;
  }
  load_.resize(2 * static_cast<std::size_t>(nodes_));
  moments_.resize(8 * aggregates_.list.size());
}

void CoarseSpace::number_corners(const std::vector<Coupling>& couplings) {
  const std::size_t corners = 4 * aggregates_.list.size();
  JoinedSets sets(corners);
  for (const Coupling& c : couplings) {
    const Aggregates::Aggregate &p = aggregates_.list[c.p], &q = aggregates_.list[c.q];
    if (c.p == c.q || p.owner != q.owner) continue;
    const int right = q.cell_x - p.cell_x, up = q.cell_y - p.cell_y;
    for (int a = 0; a < 4; ++a) {
      const int x = (a & 1) - right, y = (a >> 1) - up;
      if (x < 0 || x > 1 || y < 0 || y > 1) continue;
      sets.join(4 * c.p + a, 4 * c.q + 2 * y + x);
    }
  }
  corner_.resize(corners);
  nodes_ = 0;
  for (std::size_t k = 0; k < corners; ++k) {
    const auto root = static_cast<std::size_t>(sets.find(static_cast<std::int32_t>(k)));
    corner_[k] = root == k ? nodes_++ : corner_[root];
  }
}

BlockMatrix CoarseSpace::assemble(const std::vector<Coupling>& couplings) const {
  // Every coupling of corners goes into the column of its lower coarse node.
  const auto columns = static_cast<std::size_t>(nodes_);
  const auto each = [&](auto&& visit) {
    for (const Coupling& c : couplings)
      for (int a = 0; a < 4; ++a)
        for (int b = c.p == c.q ? a : 0; b < 4; ++b) visit(c, a, b, corner_[4 * c.p + a], corner_[4 * c.q + b]);
  };
  std::vector<std::int64_t> begin(columns + 1, 0);
  each([&](const Coupling&, int, int, std::int32_t m, std::int32_t n) {
    ++begin[static_cast<std::size_t>(std::min(m, n)) + 1];
  });
  for (std::size_t k = 0; k < columns; ++k) begin[k + 1] += begin[k];
  std::vector<Entry> entries(static_cast<std::size_t>(begin[columns]));
  auto at = begin;
  each([&](const Coupling& c, int a, int b, std::int32_t m, std::int32_t n) {
    const auto ua = static_cast<unsigned>(a), ub = static_cast<unsigned>(b);
    const double xx = c.block[0][ua][ub], xy = c.block[1][ua][ub], yy = c.block[2][ua][ub], yx = c.block[3][ua][ub];
    Entry& entry = entries[static_cast<std::size_t>(at[std::min(m, n)]++)];
    // Two corners of different aggregates may share a coarse node: then the block and its transpose both land on the
    // diagonal.
    if (m == n && c.p != c.q) entry = {m, {2 * xx, xy + yx, xy + yx, 2 * yy}};
    else if (m >= n) entry = {m, {xx, yx, xy, yy}};
    else entry = {n, {xx, xy, yx, yy}};
  });
  return gathered(begin, entries);
}

void CoarseSpace::list_runs(const std::vector<std::uint8_t>& prescribed) {
  for (int y = 0; y < grid_.height; ++y)
    for (int x = 0; x < grid_.width;) {
      const std::ptrdiff_t i = grid_.index(x, y);
      const std::int32_t aggregate = aggregates_.of_node[i];
      const int end = std::min(grid_.width, (x / Aggregates::cell + 1) * Aggregates::cell);
      int length = 1;
      while (x + length < end && aggregates_.of_node[i + length] == aggregate) ++length;
      if (aggregate >= 0)
        runs_.push_back({i, aggregate, static_cast<std::int16_t>(x % Aggregates::cell),
                         static_cast<std::int16_t>(y % Aggregates::cell), static_cast<std::int16_t>(length),
                         prescribed[y] == y_prescribed});
      x += length;
    }
}

void CoarseSpace::correct(Plane<const float> r, Plane<float> z) {
  std::fill(moments_.begin(), moments_.end(), 0.0f);
  for (const Run& run : runs_) {
    float x0 = 0, x1 = 0, y0 = 0, y1 = 0;
    const float *rx = r.x + run.begin, *ry = r.y + run.begin;
    for (int k = 0; k < run.length; ++k) {
      const auto s = static_cast<float>(k);
      x0 += rx[k];
      x1 += s * rx[k];
      y0 += ry[k];
      y1 += s * ry[k];
    }
    if (run.slides) y0 = y1 = 0;
    const auto from = static_cast<float>(run.x), t = static_cast<float>(run.y);
    x1 += from * x0;
    y1 += from * y0;
    float* m = &moments_[8 * static_cast<std::size_t>(run.aggregate)];
    m[0] += x0;
    m[1] += x1;
    m[2] += t * x0;
    m[3] += t * x1;
    m[4] += y0;
    m[5] += y1;
    m[6] += t * y0;
    m[7] += t * y1;
  }
  std::fill(load_.begin(), load_.end(), 0.0);
  constexpr double h = 1.0 / Aggregates::cell;
  for (std::size_t p = 0; p < aggregates_.list.size(); ++p)
    for (unsigned c = 0; c < 2; ++c) {
      const float* m = &moments_[8 * p + 4 * c];
      const double one = m[0], s = h * m[1], t = h * m[2], st = h * h * m[3];
      const double weight[4] = {one - s - t + st, s - st, t - st, st};
      for (unsigned a = 0; a < 4; ++a) load_[2 * static_cast<std::size_t>(corner_[4 * p + a]) + c] += weight[a];
    }
  factor_->solve(load_);
  for (std::size_t p = 0; p < aggregates_.list.size(); ++p)
    for (unsigned c = 0; c < 2; ++c) {
      double u[4];
      for (unsigned a = 0; a < 4; ++a) u[a] = load_[2 * static_cast<std::size_t>(corner_[4 * p + a]) + c];
      float* m = &moments_[8 * p + 4 * c];
      m[0] = static_cast<float>(u[0]);
      m[1] = static_cast<float>(h * (u[1] - u[0]));
      m[2] = static_cast<float>(h * (u[2] - u[0]));
      m[3] = static_cast<float>(h * h * (u[0] - u[1] - u[2] + u[3]));
    }
  for (const Run& run : runs_) {
    const float* m = &moments_[8 * static_cast<std::size_t>(run.aggregate)];
    const auto from = static_cast<float>(run.x), t = static_cast<float>(run.y);
    const float gx = m[1] + t * m[3], gy = run.slides ? 0 : m[5] + t * m[7];
    const float ax = m[0] + t * m[2] + from * gx, ay = run.slides ? 0 : m[4] + t * m[6] + from * gy;
    float *zx = z.x + run.begin, *zy = z.y + run.begin;
    for (int k = 0; k < run.length; ++k) {
      const auto s = static_cast<float>(k);
      zx[k] += ax + s * gx;
      zy[k] += ay + s * gy;
    }
  }
}

}  // namespace arenite::statics
