#include "thermal/thermography/phase_pictures.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/threads.hpp"
#include "thermal/thermography/frame_times.hpp"
#include "thermal/thermography/harmonic_fit.hpp"
#include "thermal/thermography/resample.hpp"

namespace arenite::thermography {

namespace {

struct Bins {
  std::vector<std::size_t> of_frame;
  std::vector<double> frames, cosine, sine, cosine2, sine2;
  std::vector<float> slow;          ///< frames x order: Legendre's polynomials P_1, P_2 .. of the time, less their mean over the film
  Eigen::MatrixXd mean_slow;        ///< parts x order: their means over the frames of every part
  std::size_t order = 0;
};

/// The order that frames of a like phase, of which there is one in every cycle, can show.
std::size_t order_of(const LockinMaps& maps, const std::vector<double>& time) {
  const double cycles = maps.frequency * film_length(time);
  return static_cast<std::size_t>(std::clamp(cycles - 1, 0.0, static_cast<double>(maps.drift_order)));
}

void weigh_drift(Bins& bins, const std::vector<double>& time) {
  const double middle = (time.front() + time.back()) / 2, half = (time.back() - time.front()) / 2;
  std::vector<double> now(bins.order + 1), mean(now.size());
  for (const double t : time) {
    legendre((t - middle) / half, now.size(), now.data());
    for (std::size_t j = 0; j < now.size(); ++j) mean[j] += now[j] / static_cast<double>(time.size());
  }
  bins.slow.resize(time.size() * bins.order);
  bins.mean_slow = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(bins.frames.size()), static_cast<Eigen::Index>(bins.order));
  for (std::size_t n = 0; n < time.size(); ++n) {
    legendre((time[n] - middle) / half, now.size(), now.data());
    for (std::size_t j = 0; j < bins.order; ++j) {
      const double value = now[j + 1] - mean[j + 1];  // so the noise of the drift does not add to that of the pictures' mean
      bins.slow[n * bins.order + j] = static_cast<float>(value);
      bins.mean_slow(static_cast<Eigen::Index>(bins.of_frame[n]), static_cast<Eigen::Index>(j)) += value / bins.frames[bins.of_frame[n]];
    }
  }
}

Bins sort_frames(const std::vector<double>& time, double frequency, std::size_t parts, std::size_t order) {
  Bins bins;
  bins.order = order;
  std::vector<std::size_t> name(parts, parts);
  for (const double t : time) {
    const double cycles = frequency * t, angle = 2 * std::numbers::pi * cycles;
    const auto part = std::min(parts - 1, static_cast<std::size_t>((cycles - std::floor(cycles)) * static_cast<double>(parts)));
    if (name[part] == parts) {
      name[part] = bins.frames.size();
      for (auto* each : {&bins.frames, &bins.cosine, &bins.sine, &bins.cosine2, &bins.sine2}) each->push_back(0);
    }
    const std::size_t b = name[part];
    bins.of_frame.push_back(b);
    bins.frames[b] += 1;
    bins.cosine[b] += std::cos(angle);
    bins.sine[b] += std::sin(angle);
    bins.cosine2[b] += std::cos(2 * angle);
    bins.sine2[b] += std::sin(2 * angle);
  }
  for (auto* each : {&bins.cosine, &bins.sine, &bins.cosine2, &bins.sine2})
    for (std::size_t b = 0; b < each->size(); ++b) (*each)[b] /= bins.frames[b];
  weigh_drift(bins, time);
  return bins;
}

/// Adds a frame to its picture and, weighed, to the sums that tell each pixel's drift.
template <class T>
void add(const T* frame, const std::vector<float>& mean, const float* slow, std::size_t order, float* sum, float* drift, std::size_t begin, std::size_t end) {
  for (std::size_t p = begin; p < end; ++p) sum[p] += static_cast<float>(frame[p]) - mean[p];
  for (std::size_t j = 0; j < order; ++j, drift += mean.size())
    for (std::size_t p = begin; p < end; ++p) drift[p] += slow[j] * (static_cast<float>(frame[p]) - mean[p]);
}

/// What gives a pixel's drift from its weighed sums: least squares of polynomials beside any swing, as frames of a like phase
/// tell it, whatever the pixel shows within a cycle.
Eigen::MatrixXd drift_solver(const Bins& bins) {
  const auto order = static_cast<Eigen::Index>(bins.order);
  const Eigen::Map<const Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> slow(bins.slow.data(), static_cast<Eigen::Index>(bins.of_frame.size()), order);
  const Eigen::MatrixXd value = slow.cast<double>();
  Eigen::MatrixXd normal = value.transpose() * value;
  for (std::size_t b = 0; b < bins.frames.size(); ++b) {
    const auto row = bins.mean_slow.row(static_cast<Eigen::Index>(b));
    normal -= bins.frames[b] * row.transpose() * row;
  }
  return normal.inverse();
}

/// Turns the weighed sums into the drift's coefficients. `sums` holds the sums of the pictures.
void solve_drift(const Bins& bins, const float* sums, std::size_t pixels, float* drift, const Team& team) {
  if (bins.order == 0) return;
  const Eigen::MatrixXd solver = drift_solver(bins);
  const auto order = static_cast<Eigen::Index>(bins.order);
  team.for_ranges(pixels, [&](std::size_t begin, std::size_t end) {
    Eigen::VectorXd side(order);
    for (std::size_t p = begin; p < end; ++p) {
      for (Eigen::Index j = 0; j < order; ++j) side[j] = static_cast<double>(drift[static_cast<std::size_t>(j) * pixels + p]);
      for (std::size_t b = 0; b < bins.frames.size(); ++b) side -= static_cast<double>(sums[b * pixels + p]) * bins.mean_slow.row(static_cast<Eigen::Index>(b)).transpose();
      side = (solver * side).eval();
      for (Eigen::Index j = 0; j < order; ++j) drift[static_cast<std::size_t>(j) * pixels + p] = static_cast<float>(side[j]);
    }
  });
}

/// Pixels without a value would spoil their lines in the spline.
void finish(const LockinMaps& maps, const Bins& bins, const float* drift, std::size_t b, float* picture) {
  for (std::size_t p = 0; p < maps.size(); ++p) {
    picture[p] = maps.mean[p] + picture[p] / static_cast<float>(bins.frames[b]);
    for (std::size_t j = 0; j < bins.order; ++j)
      picture[p] -= drift[j * maps.size() + p] * static_cast<float>(bins.mean_slow(static_cast<Eigen::Index>(b), static_cast<Eigen::Index>(j)));
    if (!std::isfinite(picture[p])) picture[p] = p > 0 ? picture[p - 1] : 0;
  }
  spline_coefficients(picture, maps.width, maps.height);
}

}  // namespace

PhasePictures phase_pictures(FilmSource& film, const LockinMaps& maps, const LockinOptions& options, std::size_t parts) {
  const std::vector<double> time = frame_times(film.info(), options.frame_rate);
  const Bins bins = sort_frames(time, maps.frequency, parts, order_of(maps, time));
  PhasePictures result{maps.width, maps.height, bins.frames, bins.cosine, bins.sine, bins.cosine2, bins.sine2, {}};
  const std::size_t pixels = result.pixels();
  result.spline.resize(result.size() * pixels);
  std::vector<float> drift(bins.order * pixels);
  const Team team(options.threads);
  const std::size_t at_once = std::max<std::size_t>(1, (std::size_t{8} << 20) / (pixels * (film.info().floating ? 4 : 2)));
  FrameBlock block;
  for (std::size_t n = 0; n < time.size(); n += at_once) {
    const std::size_t count = std::min(at_once, time.size() - n);
    film.read(static_cast<std::int64_t>(n), count, block);
    team.for_ranges(pixels, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = 0; k < count; ++k) {
        float* sum = result.spline.data() + bins.of_frame[n + k] * pixels;
        const float* slow = bins.slow.data() + (n + k) * bins.order;
        if (film.info().floating) add(block.value.data() + k * pixels, maps.mean, slow, bins.order, sum, drift.data(), begin, end);
        else add(block.level.data() + k * pixels, maps.mean, slow, bins.order, sum, drift.data(), begin, end);
      }
    });
    if (options.progress && !options.progress(static_cast<double>(n + count) / static_cast<double>(time.size()))) return {};
  }
  solve_drift(bins, result.spline.data(), pixels, drift.data(), team);
  team.for_each(result.size(), [&](std::size_t b) { finish(maps, bins, drift.data(), b, result.spline.data() + b * pixels); });
  return result;
}

std::vector<float> picture_of(const PhasePictures& pictures, std::size_t k) {
  std::vector<float> values;
  values.reserve(pictures.pixels());
  for (int row = 0; row < pictures.height; ++row)
    for (int column = 0; column < pictures.width; ++column)
      values.push_back(static_cast<float>(Resampled(pictures.width, pictures.height, column, row).of(pictures.picture(k))));
  return values;
}

}  // namespace arenite::thermography
