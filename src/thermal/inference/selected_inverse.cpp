#include "thermal/inference/selected_inverse.hpp"

#include <cstddef>

namespace arenite::inference {

// Z = (L D L^T)^-1 obeys Z = D^-1 L^-1 + (1 - L^T) Z. Column j below the diagonal: Z_ij = -sum_k Z_ik L_kj over the rows k
// of L's column j; all Z_ik needed lie in columns right of j and in the pattern.
std::vector<double> selected_inverse_diagonal(const std::vector<int>& begin, const std::vector<int>& row,
                                              const std::vector<double>& value, const std::vector<double>& d) {
  const std::size_t n = d.size();
  std::vector<double> diagonal(n), z(value.size()), sum(n, 0.0), factor(n, 0.0);
  std::vector<char> wanted(n, 0);
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  for (std::size_t j = n; j-- > 0;) {
    const std::size_t first = at(begin[j]), last = at(begin[j + 1]);
    for (std::size_t e = first; e < last; ++e)
      if (const std::size_t i = at(row[e]); i != j) wanted[i] = 1, factor[i] = value[e], sum[i] = 0;
    for (std::size_t e = first; e < last; ++e) {
      const std::size_t k = at(row[e]);
      if (k == j) continue;
      sum[k] -= diagonal[k] * value[e];
      for (std::size_t q = at(begin[k]); q < at(begin[k + 1]); ++q)
        if (const std::size_t i = at(row[q]); i != k && wanted[i]) {
          sum[i] -= z[q] * value[e];
          sum[k] -= z[q] * factor[i];
        }
    }
    diagonal[j] = 1 / d[j];
    for (std::size_t e = first; e < last; ++e)
      if (const std::size_t i = at(row[e]); i != j) {
        z[e] = sum[i];
        diagonal[j] -= sum[i] * value[e];
        wanted[i] = 0;
      }
  }
  return diagonal;
}

}  // namespace arenite::inference
