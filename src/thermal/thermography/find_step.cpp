#include "thermal/thermography/find_step.hpp"

#include <Eigen/Dense>

#include "core/error.hpp"
#include "thermal/thermography/harmonic_fit.hpp"

namespace arenite::thermography {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Sums over frames so far: of products of polynomials, and of every pixel's values with them.
struct Side {
  MatrixXd normal, value;

  Side(Index size, Index pixels) : normal(MatrixXd::Zero(size, size)), value(MatrixXd::Zero(pixels, size)) {}
  void add(const VectorXd& phi, const VectorXd& frame, double sign) {
    normal.noalias() += sign * phi * phi.transpose();
    value.noalias() += sign * frame * phi.transpose();
  }
  MatrixXd fitted(const Eigen::LDLT<MatrixXd>& inverse) const { return inverse.solve(value.transpose()); }
};

}  // namespace

double find_step(const MatrixXd& series, const std::vector<double>& time, int drift_order) {
  const auto frames = static_cast<Index>(time.size()), size = static_cast<Index>(drift_order + 1), margin = size + 2;
  if (frames < 2 * margin) throw InputError("the film has too few frames for a step to be found; give its time, or ask for less drift");
  const double middle = (time.front() + time.back()) / 2, half = (time.back() - time.front()) / 2;
  MatrixXd phi(size, frames);
  for (Index n = 0; n < frames; ++n) legendre((time[static_cast<std::size_t>(n)] - middle) / half, static_cast<std::size_t>(size), phi.col(n).data());
  Side before(size, series.rows()), after = before;
  for (Index n = 0; n < frames; ++n) after.add(phi.col(n), series.col(n), 1);
  Index best = 0;
  double most = -1;
  for (Index n = 0; n + margin <= frames; ++n) {
    if (n >= margin) {
      const MatrixXd a = before.fitted(Eigen::LDLT<MatrixXd>(before.normal)), b = after.fitted(Eigen::LDLT<MatrixXd>(after.normal));
      const double explained = (a.array() * before.value.transpose().array()).sum() + (b.array() * after.value.transpose().array()).sum();
      if (explained > most) most = explained, best = n;
    }
    before.add(phi.col(n), series.col(n), 1);
    after.add(phi.col(n), series.col(n), -1);
  }
  return (time[static_cast<std::size_t>(best - 1)] + time[static_cast<std::size_t>(best)]) / 2;
}

}  // namespace arenite::thermography
