#include "thermography/step_load.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "thermography/find_step.hpp"
#include "thermography/frame_times.hpp"

namespace arenite::thermography {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

void check(const StepOptions& o) {
  if (o.drift_order < 0 || o.drift_order > 4) throw InputError(fmt::format("the drift's order is {}; it must be 0 to 4", o.drift_order));
  if (!(o.rise >= 0) || !(o.window >= 0)) throw InputError("the step's rise and window must not be below 0 s");
}

/// Frames first .. first + count - 1 on one side of a step and their polynomials, orthonormal over these frames: a number
/// of the fit is a weighed sum of values. Heights and slopes are those of the polynomials at the step.
struct Side {
  std::size_t first = 0, count = 0;
  MatrixXd weight;  ///< polynomials x frames
  VectorXd height, slope;
};

Side side_of(const std::vector<double>& time, std::size_t first, std::size_t end, double step, int order, const char* name) {
  const auto size = static_cast<Index>(order + 1);
  if (end < first + static_cast<std::size_t>(size) + 2)
    throw InputError(fmt::format("the film has {} frames {} the step at {:.6g} s that can be used, too few for a drift of order {}; give another time, a longer "
                                 "window, a shorter rise or less drift", end > first ? end - first : 0, name, step, order));
  Side side{first, end - first, {}, VectorXd::Zero(size), VectorXd::Zero(size)};
  const double length = std::max(std::abs(time[first] - step), std::abs(time[end - 1] - step));
  MatrixXd power(static_cast<Index>(side.count), size);
  for (Index n = 0; n < power.rows(); ++n) {
    const double x = (time[first + static_cast<std::size_t>(n)] - step) / length;
    for (Index k = 0; k < size; ++k) power(n, k) = k == 0 ? 1 : power(n, k - 1) * x;
  }
  const Eigen::HouseholderQR<MatrixXd> qr(power);
  side.weight = (qr.householderQ() * MatrixXd::Identity(power.rows(), size)).transpose();
  const MatrixXd r = qr.matrixQR().topRows(size).triangularView<Eigen::Upper>();
  VectorXd unit = VectorXd::Zero(size);
  unit[0] = 1;
  side.height = r.transpose().triangularView<Eigen::Lower>().solve(unit);
  if (order == 0) return side;
  unit.setZero();
  unit[1] = 1 / length;
  side.slope = r.transpose().triangularView<Eigen::Lower>().solve(unit);
  return side;
}

/// Weighed sums of all pixels' values, less the pixel's first one.
class Sums {
 public:
  Sums(std::size_t pixels, Index size) : pixels_(pixels), base_(pixels), squares_(pixels), sum_(static_cast<std::size_t>(size), std::vector<double>(pixels)) {}

  /// False if stopped.
  bool pass(FilmSource& film, const Side& side, const Team& team, const std::function<bool(std::size_t)>& progress) {
    const std::size_t at_once = std::clamp<std::size_t>((std::size_t{1} << 22) / pixels_, 1, 256);
    FrameBlock block;
    for (std::size_t n = 0; n < side.count; n += at_once) {
      const std::size_t count = std::min(at_once, side.count - n);
      film.read(static_cast<std::int64_t>(side.first + n), count, block);
      if (block.value.empty()) add(block.level.data(), n, count, side, team);
      else add(block.value.data(), n, count, side, team);
      if (!progress(count)) return false;
    }
    return true;
  }

  double base(std::size_t p) const { return base_[p]; }
  double squares(std::size_t p) const { return squares_[p]; }
  double at(const VectorXd& functional, std::size_t p) const {
    double sum = 0;
    for (std::size_t k = 0; k < sum_.size(); ++k) sum += functional[static_cast<Index>(k)] * sum_[k][p];
    return sum;
  }
  double explained(std::size_t p) const {
    double sum = 0;
    for (const auto& each : sum_) sum += each[p] * each[p];
    return sum;
  }

 private:
  template <class T>
  void add(const T* frames, std::size_t first, std::size_t count, const Side& side, const Team& team) {
    team.for_ranges(pixels_, [&](std::size_t begin, std::size_t end) {
      if (first == 0)
        for (std::size_t p = begin; p < end; ++p) base_[p] = static_cast<double>(frames[p]);
      for (std::size_t f = 0; f < count; ++f) {
        const T* value = frames + f * pixels_;
        for (std::size_t p = begin; p < end; ++p) {
          const double d = static_cast<double>(value[p]) - base_[p];
          squares_[p] += d * d;
        }
        for (std::size_t k = 0; k < sum_.size(); ++k) {
          const double w = side.weight(static_cast<Index>(k), static_cast<Index>(first + f));
          for (std::size_t p = begin; p < end; ++p) sum_[k][p] += w * (static_cast<double>(value[p]) - base_[p]);
        }
      }
    });
  }

  std::size_t pixels_;
  std::vector<double> base_, squares_;
  std::vector<std::vector<double>> sum_;
};

void fill(StepMaps& maps, const Side (&side)[2], const Sums (&sums)[2]) {
  const std::size_t pixels = static_cast<std::size_t>(maps.width) * static_cast<std::size_t>(maps.height);
  for (auto* map : {&maps.jump, &maps.standard_error, &maps.level, &maps.drift_before, &maps.drift_after, &maps.residual}) map->resize(pixels);
  const double spread = std::sqrt(side[0].height.squaredNorm() + side[1].height.squaredNorm());
  const double freedom = static_cast<double>(maps.before + maps.after) - 2.0 * static_cast<double>(maps.drift_order + 1);
  bool changes = false;
  for (std::size_t p = 0; p < pixels; ++p) {
    const double before = sums[0].base(p) + sums[0].at(side[0].height, p), after = sums[1].base(p) + sums[1].at(side[1].height, p);
    const double left = sums[0].squares(p) + sums[1].squares(p) - sums[0].explained(p) - sums[1].explained(p), noise = std::sqrt(std::max(left, 0.0) / freedom);
    maps.level[p] = static_cast<float>(before);
    maps.jump[p] = static_cast<float>(after - before);
    maps.drift_before[p] = static_cast<float>(sums[0].at(side[0].slope, p));
    maps.drift_after[p] = static_cast<float>(sums[1].at(side[1].slope, p));
    maps.residual[p] = static_cast<float>(std::isfinite(left) ? noise : left);
    maps.standard_error[p] = static_cast<float>(static_cast<double>(maps.residual[p]) * spread);
    changes = changes || sums[0].squares(p) > 0 || sums[1].squares(p) > 0 || std::abs(sums[0].base(p) - sums[1].base(p)) > 0;
  }
  if (!changes) throw InputError("every pixel of the film is constant in time (or is no number); a step needs a film of a loaded sample");
}

}  // namespace

StepMaps step_load(FilmSource& film, const StepOptions& o) {
  check(o);
  const std::vector<double> time = frame_times(film.info(), o.frame_rate);
  StepMaps maps;
  const double passes = o.time ? 1 : 2;
  maps.time = o.time ? *o.time : find_step(film, time, o.drift_order, o.progress ? [&](double share) { return o.progress(share / 2); } : Progress());
  if (!o.time && maps.time < 0) return {};
  if (!(maps.time > time.front() && maps.time < time.back()))
    throw InputError(fmt::format("the step at {:.6g} s is not within the film, which lasts {:.6g} s", maps.time, time.back()));
  const double far = o.window > 0 ? o.window : time.back() + 1;
  const auto after_time = [&](double t) { return static_cast<std::size_t>(std::upper_bound(time.begin(), time.end(), t) - time.begin()); };
  const auto from_time = [&](double t) { return static_cast<std::size_t>(std::lower_bound(time.begin(), time.end(), t) - time.begin()); };
  const Side side[2] = {side_of(time, from_time(maps.time - far), from_time(maps.time - o.rise / 2), maps.time, o.drift_order, "before"),
                        side_of(time, after_time(maps.time + o.rise / 2), after_time(maps.time + far), maps.time, o.drift_order, "after")};
  maps.width = film.info().width;
  maps.height = film.info().height;
  maps.before = side[0].count;
  maps.after = side[1].count;
  maps.drift_order = o.drift_order;
  const auto size = static_cast<Index>(o.drift_order + 1);
  Sums sums[2] = {Sums(film.info().pixels(), size), Sums(film.info().pixels(), size)};
  const Team team(o.threads);
  std::size_t read = 0;
  const auto progress = [&](std::size_t frames) {
    read += frames;
    return !o.progress || o.progress(((passes - 1) + static_cast<double>(read) / static_cast<double>(maps.before + maps.after)) / passes);
  };
  for (std::size_t k = 0; k < 2; ++k)
    if (!sums[k].pass(film, side[k], team, progress)) return {};
  fill(maps, side, sums);
  return maps;
}

}  // namespace arenite::thermography
