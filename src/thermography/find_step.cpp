#include "thermography/find_step.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "thermography/harmonic_fit.hpp"

namespace arenite::thermography {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr std::size_t most_pixels = 1024;

/// Some pixels of every frame, less their first value and over their noise from frame to frame: pixels x frames. Pixels
/// that never change, or are no numbers, are left out.
MatrixXd some_pixels(FilmSource& film, const Progress& progress) {
  const auto frames = static_cast<std::size_t>(film.info().frames), pixels = film.info().pixels();
  const std::size_t every = (pixels + most_pixels - 1) / most_pixels, count = (pixels + every - 1) / every;
  MatrixXd series(static_cast<Index>(count), static_cast<Index>(frames));
  const std::size_t at_once = std::clamp<std::size_t>((std::size_t{1} << 22) / pixels, 1, 256);
  FrameBlock block;
  for (std::size_t n = 0; n < frames; n += at_once) {
    const std::size_t here = std::min(at_once, frames - n);
    film.read(static_cast<std::int64_t>(n), here, block);
    for (std::size_t f = 0; f < here; ++f)
      for (std::size_t i = 0; i < count; ++i) {
        const std::size_t at = f * pixels + i * every;
        series(static_cast<Index>(i), static_cast<Index>(n + f)) = block.value.empty() ? static_cast<double>(block.level[at]) : static_cast<double>(block.value[at]);
      }
    if (progress && !progress(static_cast<double>(n + here) / static_cast<double>(frames))) return {};
  }
  const VectorXd first = series.col(0);
  series.colwise() -= first;
  Index used = 0;
  const Index last = series.cols() - 1;
  for (Index i = 0; i < series.rows(); ++i) {
    const double noise = std::sqrt((series.row(i).tail(last) - series.row(i).head(last)).squaredNorm() / (2 * static_cast<double>(last)));
    if (noise > 0 && std::isfinite(noise)) series.row(used++) = series.row(i).eval() / noise;
  }
  return series.topRows(used);
}

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

double find_step(FilmSource& film, const std::vector<double>& time, int drift_order, const Progress& progress) {
  const auto frames = static_cast<Index>(time.size()), size = static_cast<Index>(drift_order + 1), margin = size + 2;
  if (frames < 2 * margin) throw InputError("the film has too few frames for a step to be found; give its time, or ask for less drift");
  const MatrixXd series = some_pixels(film, progress);
  if (series.size() == 0) {
    if (progress && film.info().pixels() > 0 && !progress(1)) return -1;
    throw InputError("every pixel of the film is constant in time (or is no number); a step is sought in a film of a loaded sample");
  }
  const double middle = (time.front() + time.back()) / 2, half = (time.back() - time.front()) / 2;
  MatrixXd phi(size, frames);
  for (Index n = 0; n < frames; ++n) legendre((time[static_cast<std::size_t>(n)] - middle) / half, static_cast<std::size_t>(size), phi.col(n).data());
  Side before(size, series.rows()), after = before;
  for (Index n = 0; n < frames; ++n) after.add(phi.col(n), series.col(n), 1);
  Index best = 0;
  double most = -1, evidence = 0;
  VectorXd at(size);
  for (Index n = 0; n + margin <= frames; ++n) {
    if (n >= margin) {
      const Eigen::LDLT<MatrixXd> first(before.normal), second(after.normal);
      const MatrixXd a = before.fitted(first), b = after.fitted(second);
      const double explained = (a.array() * before.value.transpose().array()).sum() + (b.array() * after.value.transpose().array()).sum();
      if (explained > most) {
        most = explained;
        best = n;
        const double between = (time[static_cast<std::size_t>(n - 1)] + time[static_cast<std::size_t>(n)]) / 2;
        legendre((between - middle) / half, static_cast<std::size_t>(size), at.data());
        const double variance = at.dot(first.solve(at)) + at.dot(second.solve(at));
        evidence = ((b - a).transpose() * at).squaredNorm() / variance / static_cast<double>(series.rows());
      }
    }
    before.add(phi.col(n), series.col(n), 1);
    after.add(phi.col(n), series.col(n), -1);
  }
  if (!(evidence > 1 + 6 * std::sqrt(2 / static_cast<double>(series.rows()))))
    throw InputError("the film shows no step of the load: nowhere do its pixels jump by more than their noise; give the time of the step");
  return (time[static_cast<std::size_t>(best - 1)] + time[static_cast<std::size_t>(best)]) / 2;
}

}  // namespace arenite::thermography
