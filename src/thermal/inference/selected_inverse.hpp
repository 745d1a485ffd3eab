#pragma once
#include <vector>

namespace arenite::inference {

/// Diagonal of the inverse of L D L^T, L with unit diagonal, by columns (rows ascending, the unit diagonal may be stored),
/// from Takahashi's recurrence: only entries in the pattern of L are computed.
std::vector<double> selected_inverse_diagonal(const std::vector<int>& begin, const std::vector<int>& row,
                                              const std::vector<double>& value, const std::vector<double>& d);

}  // namespace arenite::inference
