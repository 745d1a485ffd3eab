#pragma once
#include <cstdint>
#include <memory>
#include <vector>

namespace arenite::inference {

/// Sums of squares of linear equations: sum of weight (row . x - right)^2, kept as normal equations H x = b. Rows come in
/// small dense blocks that share their columns.
class NormalEquations {
 public:
  explicit NormalEquations(int unknowns);
  ~NormalEquations();
  NormalEquations(NormalEquations&&) noexcept;
  NormalEquations& operator=(NormalEquations&&) noexcept;

  /// Equations in the unknowns `columns` (each once): rows one after the other, columns.size() numbers each.
  void add(const std::vector<int>& columns, const std::vector<double>& rows, const std::vector<double>& right, const std::vector<double>& weight);
  void add_diagonal(int unknown, double weight, double right);

  /// The minimum. With a cone, unknowns 2 c and 2 c + 1 (c < contacts) are fn and ft of a contact and obey
  /// |ft| <= mu fn; found by an interior-point method (Mehrotra 1992).
  std::vector<double> solve() const;
  std::vector<double> solve_in_cone(int contacts, double mu) const;
  /// Diagonal of the inverse of H, by Takahashi's recurrence on the factor's pattern.
  std::vector<double> inverse_diagonal() const;
  /// Number of eigenvalues of H below `threshold` times its largest diagonal entry, by Sylvester's law of inertia.
  int small_eigenvalues(double threshold) const;

  int unknowns() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Diagonal of the inverse of L D L^T, L with unit diagonal, by columns (rows ascending, the unit diagonal may be stored),
/// from Takahashi's recurrence: only entries in the pattern of L are computed.
std::vector<double> selected_inverse_diagonal(const std::vector<int>& begin, const std::vector<int>& row, const std::vector<double>& value,
                                              const std::vector<double>& d);

}  // namespace arenite::inference
