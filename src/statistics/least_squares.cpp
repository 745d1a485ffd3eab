#include "statistics/least_squares.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SparseCholesky>

namespace arenite::statistics {
namespace {

template <class T> using Dense = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>;

Eigen::Index index(std::size_t i) { return static_cast<Eigen::Index>(i); }

template <class T> Eigen::Map<const Dense<T>> seen(const MatrixOf<T>& a) {
  return {a.column(0), index(a.rows()), index(a.columns())};
}

template <class T> Eigen::Map<Dense<T>> seen(MatrixOf<T>& a) {
  return {a.column(0), index(a.rows()), index(a.columns())};
}

template <class T> MatrixOf<T> product(const MatrixOf<T>& a, const MatrixOf<T>& b) {
  MatrixOf<T> c(a.rows(), b.columns());
  seen(c).noalias() = seen(a) * seen(b);
  return c;
}

template <class T> MatrixOf<T> product_with_transposed(const MatrixOf<T>& a, const MatrixOf<T>& b) {
  MatrixOf<T> c(a.rows(), b.rows());
  seen(c).noalias() = seen(a) * seen(b).transpose();
  return c;
}

template <class Factors> Matrix solved(const Factors& factors, const Matrix& right) {
  Matrix x(right.rows(), right.columns());
  seen(x) = factors.solve(seen(right));
  return x;
}

}  // namespace

Matrix identity(std::size_t rows, std::size_t columns) {
  Matrix a(rows, columns);
  for (std::size_t k = 0; k < rows && k < columns; ++k) a(k, k) = 1;
  return a;
}

Matrix transposed(const Matrix& a) {
  Matrix b(a.columns(), a.rows());
  seen(b) = seen(a).transpose();
  return b;
}

Matrix operator*(const Matrix& a, const Matrix& b) { return product(a, b); }
FloatMatrix operator*(const FloatMatrix& a, const FloatMatrix& b) { return product(a, b); }

Matrix transposed_times(const Matrix& a, const Matrix& b) {
  Matrix c(a.columns(), b.columns());
  seen(c).noalias() = seen(a).transpose() * seen(b);
  return c;
}

Matrix times_transposed(const Matrix& a, const Matrix& b) { return product_with_transposed(a, b); }
FloatMatrix times_transposed(const FloatMatrix& a, const FloatMatrix& b) { return product_with_transposed(a, b); }

double dot(const double* a, const double* b, std::size_t count) {
  using Vector = Eigen::Map<const Eigen::VectorXd>;
  return Vector(a, index(count)).dot(Vector(b, index(count)));
}

double squares(const Matrix& a) { return dot(a.column(0), a.column(0), a.size()); }

Matrix solve(const Matrix& a, const Matrix& right) {
  return solved(Eigen::PartialPivLU<Dense<double>>(seen(a)), right);
}

Matrix solve_symmetric(const Matrix& a, const Matrix& right) {
  return solved(Eigen::LDLT<Dense<double>>(seen(a)), right);
}

Matrix solve_sparse(const std::vector<Entry>& a, const Matrix& right) {
  std::vector<Eigen::Triplet<double>> entries;
  for (const Entry& e : a) entries.emplace_back(index(e.row), index(e.column), e.value);
  Eigen::SparseMatrix<double> matrix(index(right.rows()), index(right.rows()));
  matrix.setFromTriplets(entries.begin(), entries.end());
  return solved(Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix), right);
}

Orthonormal orthonormal(const Matrix& columns) {
  const std::size_t size = columns.columns();
  const Eigen::HouseholderQR<Dense<double>> qr(seen(columns));
  Orthonormal result{identity(columns.rows(), size), Matrix(size, size)};
  seen(result.q).applyOnTheLeft(qr.householderQ());
  seen(result.r) = qr.matrixQR().topRows(index(size)).triangularView<Eigen::Upper>();
  return result;
}

}  // namespace arenite::statistics
