#include "inference/normal_equations.hpp"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <stdexcept>

#include "inference/selected_inverse.hpp"

namespace arenite::inference {

using Matrix = Eigen::SparseMatrix<double>;
using Vector = Eigen::VectorXd;
using Factor = Eigen::SimplicialLDLT<Matrix, Eigen::Lower>;

struct NormalEquations::State {
  std::vector<Eigen::Triplet<double>> lower;
  Vector right;

  Matrix matrix() const {
    Matrix m(right.size(), right.size());
    m.setFromTriplets(lower.begin(), lower.end());
    return m;
  }
};

NormalEquations::NormalEquations(int unknowns) : state_(std::make_unique<State>()) { state_->right = Vector::Zero(unknowns); }
NormalEquations::~NormalEquations() = default;
NormalEquations::NormalEquations(NormalEquations&&) noexcept = default;
NormalEquations& NormalEquations::operator=(NormalEquations&&) noexcept = default;

int NormalEquations::unknowns() const { return static_cast<int>(state_->right.size()); }

void NormalEquations::add(const std::vector<int>& columns, const std::vector<double>& rows, const std::vector<double>& right,
                          const std::vector<double>& weight) {
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const auto n = static_cast<Eigen::Index>(columns.size()), m = static_cast<Eigen::Index>(right.size());
  const Eigen::Map<const Rows> a(rows.data(), m, n);
  const Eigen::Map<const Vector> w(weight.data(), m), y(right.data(), m);
  const Rows weighted = w.asDiagonal() * a;
  const Eigen::MatrixXd normal = a.transpose() * weighted;
  const Vector b = weighted.transpose() * y;
  for (Eigen::Index p = 0; p < n; ++p) {
    const int column = columns[static_cast<std::size_t>(p)];
    state_->right[column] += b[p];
    for (Eigen::Index q = 0; q <= p; ++q) {
      const int other = columns[static_cast<std::size_t>(q)];
      state_->lower.emplace_back(std::max(column, other), std::min(column, other), normal(p, q));
    }
  }
}

void NormalEquations::add_diagonal(int unknown, double weight, double right) {
  state_->lower.emplace_back(unknown, unknown, weight);
  state_->right[unknown] += weight * right;
}

namespace {

std::vector<double> values(const Vector& v) { return {v.data(), v.data() + v.size()}; }

void factorise(Factor& factor, const Matrix& m) {
  factor.factorize(m);
  if (factor.info() != Eigen::Success) throw std::runtime_error("the normal equations of the contact forces are singular");
}

/// x = T y with fn = y_0 + y_1 and ft = mu (y_0 - y_1) for every contact; other unknowns stay.
Matrix cone_edges(Eigen::Index unknowns, int contacts, double mu) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int c = 0; c < contacts; ++c) {
    entries.emplace_back(2 * c, 2 * c, 1), entries.emplace_back(2 * c, 2 * c + 1, 1);
    entries.emplace_back(2 * c + 1, 2 * c, mu), entries.emplace_back(2 * c + 1, 2 * c + 1, -mu);
  }
  for (Eigen::Index u = 2 * contacts; u < unknowns; ++u) entries.emplace_back(u, u, 1);
  Matrix t(unknowns, unknowns);
  t.setFromTriplets(entries.begin(), entries.end());
  return t;
}

/// H with rows and columns of the held unknowns emptied but for their diagonal.
Matrix freed(const Matrix& h, const std::vector<char>& held) {
  Matrix f = h;
  for (Eigen::Index column = 0; column < f.outerSize(); ++column)
    for (Matrix::InnerIterator it(f, column); it; ++it)
      if (it.row() != it.col() && (held[static_cast<std::size_t>(it.row())] || held[static_cast<std::size_t>(it.col())])) it.valueRef() = 0;
  return f;
}

/// Minimum of y H y/2 - b y with the first `bounded` unknowns >= 0. Exchanges all infeasible unknowns at a time while
/// their number falls; else only the last one, which ends for certain.
Vector nonnegative(const Matrix& h, const Vector& b, Eigen::Index bounded) {
  const Eigen::Index n = b.size();
  std::vector<char> held(static_cast<std::size_t>(n), 0);
  Factor factor;
  factor.analyzePattern(h);
  Eigen::Index fewest = n + 1;
  int patience = 4;
  for (;;) {
    Vector right = b;
    for (Eigen::Index u = 0; u < bounded; ++u)
      if (held[static_cast<std::size_t>(u)]) right[u] = 0;
    factorise(factor, freed(h, held));
    const Vector y = factor.solve(right);
    const Vector slope = h.selfadjointView<Eigen::Lower>() * y - b;
    const double small = 1e-10 * y.cwiseAbs().maxCoeff(), flat = 1e-10 * b.cwiseAbs().maxCoeff();
    std::vector<Eigen::Index> wrong;
    for (Eigen::Index u = 0; u < bounded; ++u)
      if (held[static_cast<std::size_t>(u)] ? slope[u] < -flat : y[u] < -small) wrong.push_back(u);
    if (wrong.empty()) return y;
    const auto count = static_cast<Eigen::Index>(wrong.size());
    if (count < fewest) fewest = count, patience = 4;
    else if (--patience < 0) wrong = {wrong.back()};
    for (const Eigen::Index u : wrong) held[static_cast<std::size_t>(u)] ^= 1;
  }
}

}  // namespace

std::vector<double> NormalEquations::solve() const {
  const Matrix m = state_->matrix();
  Factor factor;
  factor.analyzePattern(m);
  factorise(factor, m);
  return values(factor.solve(state_->right));
}

std::vector<double> NormalEquations::solve_in_cone(int contacts, double mu) const {
  const Matrix half = state_->matrix(), t = cone_edges(half.rows(), contacts, mu);
  const Matrix full = half.selfadjointView<Eigen::Lower>();
  const Matrix h = Matrix(t.transpose() * full * t).triangularView<Eigen::Lower>();
  return values(t * nonnegative(h, t.transpose() * state_->right, 2 * contacts));
}

std::vector<double> NormalEquations::inverse_diagonal() const {
  const Matrix m = state_->matrix();
  Factor factor;
  factor.analyzePattern(m);
  factorise(factor, m);
  const Matrix l = factor.matrixL();
  std::vector<int> begin(l.outerIndexPtr(), l.outerIndexPtr() + l.cols() + 1), row(l.innerIndexPtr(), l.innerIndexPtr() + l.nonZeros());
  const std::vector<double> value(l.valuePtr(), l.valuePtr() + l.nonZeros());
  const std::vector<double> z = selected_inverse_diagonal(begin, row, value, values(factor.vectorD()));
  std::vector<double> diagonal(z.size());
  const auto& order = factor.permutationP().indices();  // old index -> new index
  for (std::size_t u = 0; u < z.size(); ++u) diagonal[u] = z[static_cast<std::size_t>(order[static_cast<Eigen::Index>(u)])];
  return diagonal;
}

int NormalEquations::small_eigenvalues(double threshold) const {
  Matrix m = state_->matrix();
  const double shift = threshold * m.diagonal().maxCoeff();
  for (Eigen::Index u = 0; u < m.cols(); ++u) m.coeffRef(u, u) -= shift;
  Factor factor;
  factor.analyzePattern(m);
  factorise(factor, m);
  return static_cast<int>((factor.vectorD().array() < 0).count());
}

}  // namespace arenite::inference
