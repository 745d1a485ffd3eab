#pragma once
#include <array>
#include <cstddef>
#include <vector>

namespace arenite::statistics {

/// Numbers in columns, one after the other; 0 at first. What works on all of them is compiled once, in
/// least_squares.cpp.
template <class T> class MatrixOf {
 public:
  MatrixOf() = default;
  MatrixOf(std::size_t rows, std::size_t columns) : rows_(rows), columns_(columns), value_(rows * columns) {}

  std::size_t rows() const { return rows_; }
  std::size_t columns() const { return columns_; }
  std::size_t size() const { return value_.size(); }
  T& operator()(std::size_t row, std::size_t column) { return value_[column * rows_ + row]; }
  const T& operator()(std::size_t row, std::size_t column) const { return value_[column * rows_ + row]; }
  T* column(std::size_t k) { return value_.data() + k * rows_; }
  const T* column(std::size_t k) const { return value_.data() + k * rows_; }
  /// Columns first .. first + count - 1.
  MatrixOf part(std::size_t first, std::size_t count) const {
    MatrixOf some(rows_, count);
    some.value_.assign(column(first), column(first + count));
    return some;
  }
  MatrixOf& operator+=(const MatrixOf& other) {
    for (std::size_t k = 0; k < value_.size(); ++k) value_[k] += other.value_[k];
    return *this;
  }
  MatrixOf& operator-=(const MatrixOf& other) {
    for (std::size_t k = 0; k < value_.size(); ++k) value_[k] -= other.value_[k];
    return *this;
  }

 private:
  std::size_t rows_ = 0, columns_ = 0;
  std::vector<T> value_;
};

using Matrix = MatrixOf<double>;
using FloatMatrix = MatrixOf<float>;

Matrix identity(std::size_t rows, std::size_t columns);
Matrix transposed(const Matrix& a);
Matrix operator*(const Matrix& a, const Matrix& b);
FloatMatrix operator*(const FloatMatrix& a, const FloatMatrix& b);
/// a^T b
Matrix transposed_times(const Matrix& a, const Matrix& b);
/// a b^T
Matrix times_transposed(const Matrix& a, const Matrix& b);
FloatMatrix times_transposed(const FloatMatrix& a, const FloatMatrix& b);
double dot(const double* a, const double* b, std::size_t count);
/// Sum of the squares of all numbers.
double squares(const Matrix& a);

/// x of a x = right, column by column, by LU with partial pivoting.
Matrix solve(const Matrix& a, const Matrix& right);
/// The same of a symmetric matrix that is not indefinite, by L D L^T with pivoting; of its triangles the lower one is
/// read.
Matrix solve_symmetric(const Matrix& a, const Matrix& right);

/// An entry of a sparse matrix; those of one place are added.
struct Entry {
  std::size_t row, column;
  double value;
};

/// The same of a sparse symmetric positive matrix.
Matrix solve_sparse(const std::vector<Entry>& a, const Matrix& right);

/// Columns as q r, q with as many orthonormal columns and r an upper triangle, by Householder's reflections.
struct Orthonormal {
  Matrix q, r;
};

Orthonormal orthonormal(const Matrix& columns);

/// Normal equations of a few unknowns, for places where they are summed and solved a million times.
template <std::size_t size> struct SmallNormal {
  std::array<std::array<double, size>, size> matrix{};  ///< the lower triangle
  std::array<double, size> right{};

  void add(const std::array<double, size>& row, double value, double weight) {
    for (std::size_t i = 0; i < size; ++i) {
      const double weighed = weight * row[i];
      right[i] += weighed * value;
      for (std::size_t j = 0; j <= i; ++j) matrix[i][j] += weighed * row[j];
    }
  }

  /// By L D L^T; no finite numbers where the matrix is not positive.
  std::array<double, size> solution() const {
    auto l = matrix;
    auto x = right;
    for (std::size_t j = 0; j < size; ++j) {
      for (std::size_t k = 0; k < j; ++k) l[j][j] -= l[j][k] * l[j][k] * l[k][k];
      for (std::size_t i = j + 1; i < size; ++i) {
        for (std::size_t k = 0; k < j; ++k) l[i][j] -= l[i][k] * l[j][k] * l[k][k];
        l[i][j] /= l[j][j];
      }
      for (std::size_t k = 0; k < j; ++k) x[j] -= l[j][k] * x[k];
    }
    for (std::size_t i = size; i-- > 0;) {
      x[i] /= l[i][i];
      for (std::size_t k = i + 1; k < size; ++k) x[i] -= l[k][i] * x[k];
    }
    return x;
  }
};

}  // namespace arenite::statistics
