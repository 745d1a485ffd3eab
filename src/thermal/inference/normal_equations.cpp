#include "thermal/inference/normal_equations.hpp"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "core/error.hpp"
#include "core/mapped.hpp"
#include "model/cement.hpp"

namespace arenite::inference {

using Matrix = Eigen::SparseMatrix<double>;
using Vector = Eigen::VectorXd;
using Factor = Eigen::SimplicialLDLT<Matrix, Eigen::Lower>;

void NormalEquations::add(const std::vector<int>& columns, const std::vector<double>& rows,
                          const std::vector<double>& right, const std::vector<double>& weight) {
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const auto n = static_cast<Eigen::Index>(columns.size()), m = static_cast<Eigen::Index>(right.size());
  const Eigen::Map<const Rows> a(rows.data(), m, n);
  const Eigen::Map<const Vector> w(weight.data(), m), y(right.data(), m);
  const Rows weighted = w.asDiagonal() * a;
  const Eigen::MatrixXd normal = a.transpose() * weighted;
  const Vector b = weighted.transpose() * y;
  constant_ += y.dot(w.cwiseProduct(y));
  factor_.reset();
  for (Eigen::Index p = 0; p < n; ++p) {
    const int column = columns[static_cast<std::size_t>(p)];
    right_[static_cast<std::size_t>(column)] += b[p];
    for (Eigen::Index q = 0; q <= p; ++q) {
      const int other = columns[static_cast<std::size_t>(q)];
      lower_.push_back({std::max(column, other), std::min(column, other), normal(p, q)});
    }
  }
}

void NormalEquations::add_diagonal(int unknown, double weight, double right) {
  factor_.reset();
  lower_.push_back({unknown, unknown, weight});
  right_[static_cast<std::size_t>(unknown)] += weight * right;
  constant_ += weight * right * right;
}

double NormalEquations::squares(const std::vector<double>& x) const {
  double sum = constant_;
  for (const Entry& e : lower_)
    sum += (e.i == e.j ? 1 : 2) * e.w * x[static_cast<std::size_t>(e.i)] * x[static_cast<std::size_t>(e.j)];
  for (std::size_t u = 0; u < x.size(); ++u) sum -= 2 * right_[u] * x[u];
  return sum;
}

namespace {

using Entries = std::vector<NormalEquations::Entry>;

Matrix sparse(Eigen::Index size, const Entries& entries) {
  Matrix m(size, size);
  m.setFromTriplets(entries.begin(), entries.end());
  return m;
}

Eigen::Map<const Vector> vector(const std::vector<double>& v) {
  return {v.data(), static_cast<Eigen::Index>(v.size())};
}

std::vector<double> values(const Vector& v) { return {v.data(), v.data() + v.size()}; }

[[noreturn]] void refuse() {
  throw InputError(
      "the contact forces cannot be solved for: loads, thermoelastic factors and errors of pixels differ by too many "
      "orders of magnitude, or nothing holds a contact; check their units and the positions of grains and walls");
}

/// Places of grains move by a solution: what is no number must not get there.
std::vector<double> finite_values(const Vector& v) {
  if (!v.allFinite()) refuse();
  return values(v);
}

/// Of a matrix of the analysed pattern.
void factorise(Factor& factor, const Matrix& m) {
  if (!m.coeffs().allFinite()) refuse();
  factor.factorize(m);
  if (factor.info() != Eigen::Success) refuse();
}

/// x = T y with fn = y_0 + y_1 and ft = mu (y_0 - y_1) for every contact; other unknowns stay.
Matrix cone_edges(int unknowns, int contacts, double mu) {
  Entries entries;
  for (int c = 0; c < contacts; ++c)
    entries.insert(entries.end(),
                   {{2 * c, 2 * c, 1}, {2 * c, 2 * c + 1, 1}, {2 * c + 1, 2 * c, mu}, {2 * c + 1, 2 * c + 1, -mu}});
  for (int u = 2 * contacts; u < unknowns; ++u) entries.push_back({u, u, 1});
  return sparse(unknowns, entries);
}

/// The largest step, at most 1, that keeps v + step dv >= 0 in its first entries.
double longest_step(const Vector& v, const Vector& dv, Eigen::Index bounded) {
  double step = 1;
  for (Eigen::Index u = 0; u < bounded; ++u)
    if (dv[u] < 0) step = std::min(step, -v[u] / dv[u]);
  return step;
}

/// Minimum of y H y/2 - b y with the first `bounded` unknowns >= 0, by Mehrotra's predictor and corrector: `s` are the
/// slopes that hold unknowns at zero, and products y s shrink together.
Vector nonnegative(const Matrix& h, const Vector& b, Eigen::Index bounded) {
  const auto times = [&](const Vector& v) -> Vector { return h.selfadjointView<Eigen::Lower>() * v; };
  const double slope = b.cwiseAbs().maxCoeff();
  if (slope == 0) return Vector::Zero(b.size());
  Vector y = Vector::Ones(b.size()), s = Vector::Zero(b.size());
  s.head(bounded).setConstant(slope);
  Factor factor;
  factor.analyzePattern(h);
  for (int iteration = 0; iteration < 100; ++iteration) {
    const Vector left = times(y) - b - s;
    const double gap = y.head(bounded).dot(s.head(bounded)) / static_cast<double>(bounded);
    if (gap < 1e-11 * slope && left.cwiseAbs().maxCoeff() < 1e-9 * slope) return y;
    Matrix m = h;
    for (Eigen::Index u = 0; u < bounded; ++u) m.coeffRef(u, u) += s[u] / y[u];
    factorise(factor, m);
    Vector dy, ds = Vector::Zero(b.size()), goal = Vector::Zero(b.size());
    const auto solve = [&] {
      Vector right = -left;
      right.head(bounded).array() += goal.head(bounded).array() / y.head(bounded).array();
      dy = factor.solve(right);
      ds.head(bounded) =
          (goal.head(bounded) - s.head(bounded).cwiseProduct(dy.head(bounded))).cwiseQuotient(y.head(bounded));
    };
    goal.head(bounded) = -y.head(bounded).cwiseProduct(s.head(bounded));
    solve();
    const double p = longest_step(y, dy, bounded), d = longest_step(s, ds, bounded);
    const double after = (y + p * dy).head(bounded).dot((s + d * ds).head(bounded)) / static_cast<double>(bounded);
    goal.head(bounded) -= dy.head(bounded).cwiseProduct(ds.head(bounded));
    goal.head(bounded).array() += gap * std::pow(after / gap, 3);
    solve();
    const double step = std::min(longest_step(y, dy, bounded), longest_step(s, ds, bounded));
    const double safe = step < 1 ? 0.995 * step : 1;
    y += safe * dy, s += safe * ds;
  }
  throw CannotGoOn(
      "forces within the friction cone were not found in 100 steps; check the units of loads and factors, and "
      "forces.friction");
}

/// L by columns; those that follow each other and have the same rows below them are a supernode.
struct Lower {
  Matrix l;
  std::vector<int> first;            ///< column of every supernode, and the end
  std::vector<std::size_t> node_of;  ///< of every column

  explicit Lower(Matrix of) : l(std::move(of)) {
    for (int j = 0; j < l.cols(); ++j) {
      if (j == 0 || rows(j - 1).size() != rows(j).size() + 1 || rows(j - 1)[0] != j) first.push_back(j);
      node_of.push_back(first.size() - 1);
    }
    first.push_back(static_cast<int>(l.cols()));
  }
  /// Where a column begins below the diagonal, which may be stored.
  int start(int j) const {
    const int begin = l.outerIndexPtr()[j];
    return begin + (begin < l.outerIndexPtr()[j + 1] && l.innerIndexPtr()[begin] == j ? 1 : 0);
  }
  std::span<const int> rows(int j) const {
    return {l.innerIndexPtr() + start(j), l.innerIndexPtr() + l.outerIndexPtr()[j + 1]};
  }
  /// The rows below a supernode's columns, and the supernode of the first of them.
  std::span<const int> below(std::size_t node) const { return rows(first[node + 1] - 1); }
  std::size_t parent(std::size_t node) const { return node_of[static_cast<std::size_t>(below(node)[0])]; }
};

}  // namespace

/// Factor has no copy: it is made in place.
struct NormalEquations::Factorised : Factor {
  explicit Factorised(const Matrix& m) {
    analyzePattern(m);
    factorise(*this, m);
  }
};

const NormalEquations::Factorised& NormalEquations::factorised() const {
  if (!factor_) factor_ = std::make_shared<const Factorised>(sparse(unknowns(), lower_));
  return *factor_;
}

std::vector<double> NormalEquations::solve() const { return finite_values(factorised().solve(vector(right_))); }

std::vector<double> NormalEquations::solve_in_cone(int contacts, double mu) const {
  const Matrix half = sparse(unknowns(), lower_), t = cone_edges(unknowns(), contacts, mu);
  const Matrix full = half.selfadjointView<Eigen::Lower>();
  const Matrix h = Matrix(t.transpose() * full * t).triangularView<Eigen::Lower>();
  return finite_values(t * nonnegative(h, t.transpose() * vector(right_), 2 * contacts));
}

// Z = (L D L^T)^-1 obeys Z = D^-1 L^-1 + (1 - L^T) Z (Takahashi): with the rows R below the diagonal of L's column j,
// Z_Rj = -Z_RR L_Rj and Z_jj = 1/D_j - L_Rj . Z_Rj. A supernode has Z of all its rows; of those below its columns it is
// a part of its parent's, which goes when its last child has it.
std::vector<double> NormalEquations::inverse_diagonal() const {
  const Lower l(factorised().matrixL());
  const Vector& d = factorised().vectorD();
  std::vector<int> children(l.first.size() - 1);
  for (std::size_t k = 0; k < children.size(); ++k)
    if (!l.below(k).empty()) ++children[l.parent(k)];
  std::vector<Eigen::MatrixXd> z(children.size());
  Vector diagonal(d.size());
  for (std::size_t k = z.size(); k-- > 0;) {
    const Eigen::Index columns = l.first[k + 1] - l.first[k], further = std::ssize(l.below(k)),
                       size = columns + further;
    z[k].resize(size, size);  // lower triangle
    if (further > 0) {
      const std::size_t parent = l.parent(k);
      const auto others = l.below(parent);  // places of the rows among its columns and these
      const int begin = l.first[parent], end = l.first[parent + 1];
      const auto place = mapped(l.below(k), [&](int row) {
        return row < end ? row - begin : end - begin + (std::ranges::lower_bound(others, row) - others.begin());
      });
      z[k].bottomRightCorner(further, further) = z[parent](place, place);
      if (--children[parent] == 0) z[parent] = {};
    }
    for (Eigen::Index c = columns - 1; c >= 0; --c) {
      const int j = l.first[k] + static_cast<int>(c);
      const Eigen::Map<const Vector> column(l.l.valuePtr() + l.start(j), size - c - 1);
      auto under = z[k].col(c).tail(column.size());
      under.noalias() = z[k].bottomRightCorner(column.size(), column.size()).selfadjointView<Eigen::Lower>() * -column;
      diagonal[j] = z[k](c, c) = 1 / d[j] - column.dot(under);
    }
    if (children[k] == 0) z[k] = {};
  }
  return values(factorised().permutationP().inverse() * diagonal);
}

int NormalEquations::small_eigenvalues(double threshold) const {
  Matrix m = sparse(unknowns(), lower_);
  const double shift = threshold * m.diagonal().maxCoeff();
  for (Eigen::Index u = 0; u < m.cols(); ++u) m.coeffRef(u, u) -= shift;
  return static_cast<int>((Factorised(m).vectorD().array() < 0).count());
}

}  // namespace arenite::inference
