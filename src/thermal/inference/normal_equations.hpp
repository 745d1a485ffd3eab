#pragma once
#include <cstddef>
#include <memory>
#include <vector>

namespace arenite::inference {

/// Sums of squares of linear equations: sum of weight (row . x - right)^2, kept as normal equations H x = b. Rows come
/// in small dense blocks that share their columns.
class NormalEquations {
 public:
  explicit NormalEquations(int unknowns) : right_(static_cast<std::size_t>(unknowns)) {}

  /// Equations in the unknowns `columns` (each once): rows one after the other, columns.size() numbers each.
  void add(const std::vector<int>& columns, const std::vector<double>& rows, const std::vector<double>& right,
           const std::vector<double>& weight);
  void add_diagonal(int unknown, double weight, double right);

  /// The sum of squares at x.
  double squares(const std::vector<double>& x) const;
  /// The minimum. With a cone, unknowns 2 c and 2 c + 1 (c < contacts) are fn and ft of a contact and obey
  /// |ft| <= mu fn; found by an interior-point method (Mehrotra 1992).
  std::vector<double> solve() const;
  std::vector<double> solve_in_cone(int contacts, double mu) const;
  /// Diagonal of the inverse of H.
  std::vector<double> inverse_diagonal() const;
  /// Number of eigenvalues of H below `threshold` times its largest diagonal entry, by Sylvester's law of inertia.
  int small_eigenvalues(double threshold) const;

  int unknowns() const { return static_cast<int>(right_.size()); }

  /// Of the lower triangle of H, as Eigen takes it; those of one place add up.
  struct Entry {
    int i, j;
    double w;
    int row() const { return i; }
    int col() const { return j; }
    double value() const { return w; }
  };

 private:
  struct Factorised;
  const Factorised& factorised() const;

  std::vector<Entry> lower_;
  std::vector<double> right_;
  double constant_ = 0;                               // the sum of squares at zero
  mutable std::shared_ptr<const Factorised> factor_;  // for solution and errors alike; none after equations were added
};

}  // namespace arenite::inference
