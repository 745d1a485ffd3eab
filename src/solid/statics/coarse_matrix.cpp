#include "solid/statics/coarse_matrix.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

#include "core/definite.hpp"

namespace arenite::statics {
namespace {

/// The column of a block, with numbers behind it that mean nothing.
Vector<float, 4> column(const float* p) {
  Vector<float, 4> four;
  std::memcpy(&four, p, sizeof four);
  return four;
}
constexpr std::size_t behind = 4;  ///< numbers that can be read after the last block

/// The components alone.
template <int D> constexpr Vector<float, 4> components{1, 1, D > 2 ? 1 : 0, 0};

}  // namespace

template <int D>
CoarseMatrix<D>::CoarseMatrix(const BlockMatrix& matrix, const ThreadPool* pool)
    : n_(static_cast<std::size_t>(matrix.columns())),
      column_begin_(matrix.column_begin),
      row_(matrix.row.begin(), matrix.row.end()),
      value_(matrix.value.size() + behind),
      pool_(pool) {
  std::transform(matrix.value.begin(), matrix.value.end(), value_.begin(),
                 [](double value) { return static_cast<float>(value); });
  invert_diagonal(matrix);
  cut_into_stretches();
}

template <int D> void CoarseMatrix<D>::invert_diagonal(const BlockMatrix& matrix) {
  inverse_.resize(D * D * n_ + behind);
  for (std::size_t c = 0; c < n_; ++c) {  // the first block of its column
    std::array<double, D * D> own;
    std::copy_n(&matrix.value[D * D * static_cast<std::size_t>(matrix.column_begin[c])], D * D, own.begin());
    const auto inverse = inverse_of_definite<D>(own);
    std::transform(inverse.begin(), inverse.end(), &inverse_[D * D * c],
                   [](double value) { return static_cast<float>(value); });
  }
}

template <int D> void CoarseMatrix<D>::cut_into_stretches() {
  constexpr std::size_t most = 16;
  for (std::size_t k = 0; k < most; ++k) {
    Stretch s{n_ * k / most, n_ * (k + 1) / most, 0, {}};
    if (s.first == s.end) continue;
    s.reach = s.end;
    for (std::int32_t j = column_begin_[s.first]; j < column_begin_[s.end]; ++j)
      s.reach = std::max(s.reach, static_cast<std::size_t>(row_[static_cast<std::size_t>(j)]) + 1);
    s.sum.resize(s.reach - s.first);
    stretches_.push_back(std::move(s));
  }
}

template <int D> void CoarseMatrix<D>::add_product(const std::vector<Four>& x, Stretch& stretch) const {
  std::fill(stretch.sum.begin(), stretch.sum.end(), Four{});
  Four* const y = stretch.sum.data() - stretch.first;
  const float* block = &value_[D * D * static_cast<std::size_t>(column_begin_[stretch.first])];
  for (std::size_t c = stretch.first; c < stretch.end; ++c) {
    Four own[D] = {}, at[D];
#pragma GCC unroll 3
    for (int s = 0; s < D; ++s) at[s] = x[c][s] - Four{};
    for (std::int32_t j = column_begin_[c]; j < column_begin_[c + 1]; ++j, block += D * D) {
      const auto r = static_cast<std::size_t>(row_[static_cast<std::size_t>(j)]);
      const Four there = r == c ? Four{} : x[r];
      Four sum = y[r];
#pragma GCC unroll 3
      for (int s = 0; s < D; ++s) {
        const Four of = column(block + s * D);
        sum += of * at[s];
        own[s] += of * there;
      }
      y[r] = sum;
    }
#pragma GCC unroll 3
    for (int s = 0; s < D; ++s) y[c][s] += (own[s][0] + own[s][1]) + own[s][2];
  }
}

template <int D> void CoarseMatrix<D>::apply(const std::vector<Four>& x, std::vector<Four>& y) {
  for_each(pool_, stretches_.size(), [&](std::size_t k) { add_product(x, stretches_[k]); });
  std::fill(y.begin(), y.end(), Four{});
  for (const Stretch& s : stretches_)
    for (std::size_t k = s.first; k < s.reach; ++k) y[k] += s.sum[k - s.first];
}

template <int D> Four CoarseMatrix<D>::preconditioned(std::size_t node, Four r) const {
  Four z{};
  for (int b = 0; b < D; ++b) z += column(&inverse_[D * D * node + static_cast<std::size_t>(D * b)]) * r[b];
  return z * components<D>;
}

template class CoarseMatrix<2>;
template class CoarseMatrix<3>;

}  // namespace arenite::statics
