#include "solid/statics/coarse_cycle.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "core/joined_sets.hpp"
#include "solid/statics/grid.hpp"

namespace arenite::statics {
namespace {

constexpr int box_side = 3;  ///< cells a side of the boxes of owners that reach further than two of them
constexpr int degree = 6;    ///< of the smoother

/// The boxes that an owner is cut into, alike along each axis.
struct Boxes : Extent {
  std::array<std::int32_t, 3> count{1, 1, 1};

  void cut() {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t extent = last[k] - first[k];
      count[k] = extent <= 2 * box_side ? 1 : (extent + box_side - 1) / box_side;
    }
  }
  /// Which box along an axis, and how far through it.
  std::pair<std::int32_t, double> place(std::size_t k, std::int32_t at) const {
    if (last[k] == first[k]) return {0, 0.0};
    const double share = static_cast<double>(at - first[k]) * count[k] / (last[k] - first[k]);
    const auto box = std::min(static_cast<std::int32_t>(share), count[k] - 1);
    return {box, share - box};
  }
  bool is_one() const { return count == std::array{1, 1, 1}; }
};

/// How far a place lies along each axis of a box weighs its multilinear hats, one for each corner.
template <int D> std::array<float, 1 << D> hats(const std::array<double, D>& share) {
  std::array<float, 1 << D> weight;
  weight.fill(1);
  for (std::size_t axis = 0; axis < D; ++axis)
    for (std::size_t c = 0; c < weight.size(); ++c)
      weight[c] *= static_cast<float>(c >> axis & 1 ? share[axis] : 1 - share[axis]);
  return weight;
}

/// The functions 1, x, y (and z) of a box that shares nothing with others: all rigid motions and uniform strains of a
/// grain with half as many unknowns as its corners have.
template <int D> std::array<float, 1 << D> affine(const std::array<double, D>& share) {
  std::array<float, 1 << D> weight{1};
  for (std::size_t axis = 0; axis < D; ++axis) weight[axis + 1] = static_cast<float>(share[axis] - 0.5);
  return weight;
}

/// visit(row, column, block) for each block of the lower triangle.
template <class Visit> void each_block(const BlockMatrix& m, const Visit& visit) {
  const std::ptrdiff_t size = m.side * m.side;
  for (std::int32_t c = 0; c < m.columns(); ++c)
    for (std::int32_t j = m.column_begin[c]; j < m.column_begin[static_cast<std::size_t>(c) + 1]; ++j)
      visit(m.row[j], c, &m.value[static_cast<std::size_t>(j * size)]);
}

}  // namespace

template <int D>
CoarseCycle<D>::CoarseCycle(BlockMatrix matrix, const std::vector<CoarsePlace>& places, const ThreadPool* pool)
    : n_(static_cast<std::size_t>(matrix.columns())),
      matrix_(matrix, pool) {
  for (Field* v : {&x_, &older_, &f_, &right_}) v->assign(n_, Four{});
  set_steps();
  cut(matrix, places);
  BlockMatrix coarse = product(matrix);
  matrix = {};
  factor_.emplace(std::move(coarse));
  load_.resize(static_cast<std::size_t>(D * functions_));
}

template <int D> void CoarseCycle<D>::set_steps() {
  // The largest eigenvalue by the power method; it comes from below, so that something is added.
  for (std::size_t k = 0; k < D * n_; ++k)
    x_[k / D][k % D] = static_cast<float>(std::cos(2.0 * static_cast<double>(k) + 1));
  const auto square = [](Four v) {
    double sum = 0;
    for (std::size_t a = 0; a < D; ++a) sum += static_cast<double>(v[a]) * static_cast<double>(v[a]);
    return sum;
  };
  double highest = 1;
  for (int round = 0; round < 25; ++round) {
    matrix_.apply(x_, f_);
    double before = 0, after = 0;
    for (std::size_t k = 0; k < n_; ++k) {
      older_[k] = matrix_.preconditioned(k, f_[k]);
      before += square(x_[k]);
      after += square(older_[k]);
    }
    highest = std::sqrt(after / before);
    for (std::size_t k = 0; k < n_; ++k) x_[k] = older_[k] / static_cast<float>(highest);
  }
  highest *= 1.2;
  steps_ = chebyshev_steps(degree, highest / 25, highest);
}

template <int D> void CoarseCycle<D>::cut(const BlockMatrix& matrix, const std::vector<CoarsePlace>& places) {
  std::unordered_map<std::int32_t, Boxes> boxes;
  for (const CoarsePlace& p : places) boxes[p.owner].meet(p.at);
  for (auto& [owner, of_owner] : boxes) of_owner.cut();
  std::vector<std::array<std::int32_t, 3>> box(n_);
  std::vector<bool> whole(n_);
  function_.resize(n_);
  weight_.resize(n_);
  for (std::size_t k = 0; k < n_; ++k) {
    const Boxes& of_owner = boxes[places[k].owner];
    std::array<double, D> share;
    for (std::size_t axis = 0; axis < D; ++axis)
      std::tie(box[k][axis], share[axis]) = of_owner.place(axis, places[k].at[axis]);
    whole[k] = of_owner.is_one();
    weight_[k] = whole[k] ? affine<D>(share) : hats<D>(share);
  }
  // Coarse nodes of one owner that are coupled have the functions of a box in common, in neighbouring boxes those of
  // the corners that both have.
  constexpr int functions = 1 << D;
  JoinedSets sets(functions * n_);
  const auto join = [&](std::int32_t r, int a, std::int32_t c, int b) {
    sets.join(functions * r + a, functions * c + b);
  };
  each_block(matrix, [&](std::int32_t r, std::int32_t c, const double*) {
    const auto ur = static_cast<std::size_t>(r), uc = static_cast<std::size_t>(c);
    if (r == c || places[ur].owner != places[uc].owner) return;
    for (int a = 0; a < functions; ++a) {
      int b = 0;
      bool shared = true;
      for (std::size_t axis = 0; axis < D; ++axis) {
        const int there = (a >> axis & 1) + box[ur][axis] - box[uc][axis];
        shared = shared && (there == 0 || there == 1);
        b |= there << axis;
      }
      if (shared) join(r, a, c, b);
    }
  });
  // What an affine box has no use for is counted as its first function, with weight 0.
  for (std::int32_t k = 0; k < static_cast<std::int32_t>(n_); ++k)
    for (int a = D + 1; whole[static_cast<std::size_t>(k)] && a < functions; ++a) join(k, 0, k, a);
  std::vector<std::int32_t> number(functions * n_);
  for (std::size_t k = 0; k < number.size(); ++k) {
    const auto root = static_cast<std::size_t>(sets.find(static_cast<std::int32_t>(k)));
    number[k] = root == k ? functions_++ : number[root];
    function_[k / functions][k % functions] = number[k];
  }
}

template <int D> BlockMatrix CoarseCycle<D>::product(const BlockMatrix& matrix) const {
  std::vector<std::unordered_map<std::int32_t, std::array<double, D * D>>> columns(
      static_cast<std::size_t>(functions_));
  // Blocks that follow each other mostly have the same functions: these are looked up once.
  constexpr std::size_t functions = 1 << D;
  using Functions = std::array<std::int32_t, functions>;
  const Functions *latest_r = nullptr, *latest_c = nullptr;
  std::array<std::array<double*, functions>, functions> found{};
  each_block(matrix, [&](std::int32_t r, std::int32_t c, const double* block) {
    const auto ur = static_cast<std::size_t>(r), uc = static_cast<std::size_t>(c);
    const Functions &of_r = function_[ur], &of_c = function_[uc];
    if (!latest_r || *latest_r != of_r || *latest_c != of_c) found = {};
    latest_r = &of_r, latest_c = &of_c;
    for (std::size_t a = 0; a < functions; ++a)
      for (std::size_t b = 0; b < functions; ++b) {
        const double w = static_cast<double>(weight_[ur][a]) * static_cast<double>(weight_[uc][b]);
        if (w == 0) continue;
        const std::int32_t m = of_r[a], n = of_c[b];
        // A block on the diagonal has all pairs of functions, so that those above it are left out; a block off the
        // diagonal stands for its mirror image too.
        if (r == c && m < n) continue;
        double*& to = found[a][b];
        if (!to) to = columns[static_cast<std::size_t>(std::min(m, n))][std::max(m, n)].data();
        for (std::size_t s = 0; s < D; ++s)
          for (std::size_t q = 0; q < D; ++q) {
            const double straight = block[s * D + q], turned = block[q * D + s];
            to[s * D + q] += w * (r == c ? straight : m == n ? straight + turned : m > n ? straight : turned);
          }
      }
  });
  BlockMatrix coarse;
  coarse.side = D;
  coarse.column_begin.assign(1, 0);
  double stiffest = 0;
  for (std::int32_t c = 0; c < functions_; ++c) {
    std::vector<std::int32_t> rows{c};
    auto& column = columns[static_cast<std::size_t>(c)];
    for (const auto& [r, block] : column)
      if (r != c) rows.push_back(r);
    std::sort(rows.begin(), rows.end());
    for (const std::int32_t r : rows) {
      coarse.row.push_back(r);
      const auto& block = column[r];
      coarse.value.insert(coarse.value.end(), block.begin(), block.end());
      for (std::size_t a = 0; r == c && a < D; ++a) stiffest = std::max(stiffest, block[a * (D + 1)]);
    }
    coarse.column_begin.push_back(static_cast<std::int32_t>(coarse.row.size()));
  }
  // Boxes that are flat, or hold few coarse nodes, carry more functions than these have freedoms.
  for (std::int32_t c = 0; c < functions_; ++c)
    for (std::size_t a = 0; a < D; ++a) {
      double& own = coarse.value[static_cast<std::size_t>(coarse.column_begin[c]) * D * D + a * (D + 1)];
      own += 1e-6 * own + 1e-9 * stiffest;
    }
  return coarse;
}

template <int D> void CoarseCycle<D>::smooth(const Field& b, bool from_zero) {
  if (from_zero) std::fill(x_.begin(), x_.end(), Four{});
  older_ = x_;
  for (std::size_t s = 0; s < steps_.size(); ++s) {
    const bool rests = s == 0 && from_zero;
    if (!rests) matrix_.apply(x_, f_);
    const auto [keep, add] = steps_[s];
    for (std::size_t k = 0; k < n_; ++k) {
      const Four z = matrix_.preconditioned(k, rests ? b[k] : b[k] - f_[k]);
      older_[k] = x_[k] + keep * (x_[k] - older_[k]) + add * z;
    }
    std::swap(x_, older_);
  }
}

template <int D> void CoarseCycle<D>::correct(const Field& b) {
  matrix_.apply(x_, f_);
  std::fill(load_.begin(), load_.end(), 0.0);
  for (std::size_t k = 0; k < n_; ++k) {
    const Four left = b[k] - f_[k];
    for (std::size_t c = 0; c < weight_[k].size(); ++c)
      for (std::size_t a = 0; a < D; ++a)
        load_[static_cast<std::size_t>(D * function_[k][c]) + a] += static_cast<double>(weight_[k][c] * left[a]);
  }
  factor_->solve(load_);
  for (std::size_t k = 0; k < n_; ++k)
    for (std::size_t c = 0; c < weight_[k].size(); ++c)
      for (std::size_t a = 0; a < D; ++a)
        x_[k][a] += weight_[k][c] * static_cast<float>(load_[static_cast<std::size_t>(D * function_[k][c]) + a]);
}

template <int D> void CoarseCycle<D>::solve(std::vector<double>& b) {
  for (std::size_t k = 0; k < D * n_; ++k) right_[k / D][k % D] = static_cast<float>(b[k]);
  smooth(right_, true);
  correct(right_);
  smooth(right_, false);
  for (std::size_t k = 0; k < D * n_; ++k) b[k] = static_cast<double>(x_[k / D][k % D]);
}

template class CoarseCycle<2>;
template class CoarseCycle<3>;

}  // namespace arenite::statics
