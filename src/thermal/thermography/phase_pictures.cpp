#include "thermal/thermography/phase_pictures.hpp"

#include <numbers>
#include <numeric>
#include <utility>

#include "core/median.hpp"
#include "core/threads.hpp"
#include "model/grain_motion.hpp"
#include "model/lockin_maps.hpp"
#include "thermal/thermography/blank_frames.hpp"
#include "thermal/thermography/harmonic_fit.hpp"
#include "thermal/thermography/level_changes.hpp"
#include "thermal/thermography/segment_sums.hpp"

namespace arenite::thermography {
namespace {

using statistics::Matrix;

/// One line of `n` numbers that lie `stride` apart: forth and back with the pole of the cubic spline (Unser's filter).
void filter(float* value, int n, std::ptrdiff_t stride) {
  if (n < 2) return;
  const double pole = std::sqrt(3.0) - 2;
  const auto at = [&](int k) -> float& { return value[k * stride]; };
  double sum = 0, power = 1;
  for (int k = 0; k < std::min(n, 24); ++k, power *= pole) sum += power * static_cast<double>(at(k));
  double last = 6 * sum;
  at(0) = static_cast<float>(last);
  for (int k = 1; k < n; ++k) at(k) = static_cast<float>(last = 6 * static_cast<double>(at(k)) + pole * last);
  last = pole / (pole * pole - 1) * (static_cast<double>(at(n - 1)) + pole * static_cast<double>(at(n - 2)));
  at(n - 1) = static_cast<float>(last);
  for (int k = n - 2; k >= 0; --k) at(k) = static_cast<float>(last = pole * (last - static_cast<double>(at(k))));
}

struct Bins {
  std::vector<std::size_t> of_frame;
  std::vector<double> frames;
  std::vector<Harmonics> phases;
  std::vector<float> slow;  ///< frames x order: Legendre's polynomials P_1, P_2 .. of the time, and changes of the
                            ///< level, less their mean over the film
  Matrix mean_slow;         ///< parts x order: their means over the frames of every part
  std::size_t order = 0;
};

/// The order that frames of a like phase, of which there is one in every cycle, can show.
std::size_t order_of(const LockinMaps& maps, const std::vector<double>& time) {
  const double cycles = maps.frequency * film_length(time);
  return static_cast<std::size_t>(std::clamp(cycles - 1, 0.0, static_cast<double>(maps.drift_order)));
}

void weigh_drift(Bins& bins, const std::vector<double>& time, const std::vector<std::vector<double>>& levels) {
  const double middle = (time.front() + time.back()) / 2, half = (time.back() - time.front()) / 2;
  const std::size_t powers = bins.order + 1;
  bins.order += levels.size();
  std::vector<double> now(bins.order + 1), mean(now.size());
  const auto at = [&](std::size_t n) {
    legendre((time[n] - middle) / half, powers, now.data());
    for (std::size_t j = 0; j < levels.size(); ++j) now[powers + j] = levels[j][n];
  };
  for (std::size_t n = 0; n < time.size(); ++n) {
    at(n);
    for (std::size_t j = 0; j < now.size(); ++j) mean[j] += now[j] / static_cast<double>(time.size());
  }
  bins.slow.resize(time.size() * bins.order);
  bins.mean_slow = Matrix(bins.frames.size(), bins.order);
  for (std::size_t n = 0; n < time.size(); ++n) {
    at(n);
    for (std::size_t j = 0; j < bins.order; ++j) {
      const double value =
          now[j + 1] - mean[j + 1];  // so the noise of the drift does not add to that of the pictures' mean
      bins.slow[n * bins.order + j] = static_cast<float>(value);
      bins.mean_slow(bins.of_frame[n], j) += value / bins.frames[bins.of_frame[n]];
    }
  }
}

Bins sort_frames(const std::vector<double>& time, double frequency, std::size_t parts, std::size_t order,
                 const std::vector<std::vector<double>>& levels) {
  Bins bins;
  bins.order = order;
  std::vector<std::size_t> name(parts, parts);
  for (const double t : time) {
    const double cycles = frequency * t, angle = 2 * std::numbers::pi * cycles;
    const auto part =
        std::min(parts - 1, static_cast<std::size_t>((cycles - std::floor(cycles)) * static_cast<double>(parts)));
    if (name[part] == parts) {
      name[part] = bins.frames.size();
      bins.frames.push_back(0);
      bins.phases.push_back({});
    }
    const std::size_t b = name[part];
    bins.of_frame.push_back(b);
    bins.frames[b] += 1;
    const Harmonics here{1, std::cos(angle), std::sin(angle), std::cos(2 * angle), std::sin(2 * angle)};
    for (std::size_t m = 0; m < here.size(); ++m) bins.phases[b][m] += here[m];
  }
  for (std::size_t b = 0; b < bins.phases.size(); ++b)
    for (double& each : bins.phases[b]) each /= bins.frames[b];
  weigh_drift(bins, time, levels);
  return bins;
}

/// What gives a pixel's drift from its weighed sums: least squares of polynomials beside any oscillation, as frames of
/// a like phase show it, whatever the pixel shows within a cycle.
Matrix drift_solver(const Bins& bins) {
  const std::size_t order = bins.order;
  Matrix normal(order, order);
  for (std::size_t i = 0; i < order; ++i)
    for (std::size_t j = 0; j < order; ++j) {
      for (std::size_t at = 0; at < bins.slow.size(); at += order)
        normal(i, j) += static_cast<double>(bins.slow[at + i]) * static_cast<double>(bins.slow[at + j]);
      for (std::size_t b = 0; b < bins.frames.size(); ++b)
        normal(i, j) -= bins.frames[b] * bins.mean_slow(b, i) * bins.mean_slow(b, j);
    }
  return solve(normal, statistics::identity(order, order));
}

/// Turns the weighed sums into the drift's coefficients. `sums` holds the sums of the pictures.
void solve_drift(const Bins& bins, const float* sums, std::size_t pixels, float* drift, const ThreadPool& pool) {
  if (bins.order == 0) return;
  const Matrix solver = drift_solver(bins);
  pool.for_ranges(pixels, [&](std::size_t begin, std::size_t end) {
    std::vector<double> side(bins.order);
    for (std::size_t p = begin; p < end; ++p) {
      for (std::size_t j = 0; j < bins.order; ++j) {
        side[j] = static_cast<double>(drift[j * pixels + p]);
        for (std::size_t b = 0; b < bins.frames.size(); ++b)
          side[j] -= static_cast<double>(sums[b * pixels + p]) * bins.mean_slow(b, j);
      }
      for (std::size_t j = 0; j < bins.order; ++j)
        drift[j * pixels + p] = static_cast<float>(std::inner_product(side.begin(), side.end(), solver.column(j), 0.0));
    }
  });
}

/// Median size of how far pixels lie beside the mean of their four neighbours.
double roughness(const std::vector<float>& picture, std::size_t width) {
  std::vector<float> away;
  for (std::size_t p = width; p + width < picture.size(); ++p)
    if (p % width > 0 && p % width + 1 < width)
      away.push_back(
          std::abs(4 * picture[p] - picture[p - 1] - picture[p + 1] - picture[p - width] - picture[p + width]));
  return median_of_finite(std::move(away));
}

/// The film's mean picture. Where each pixel's level jumps on its own the pattern of the jumps would be taken for rims
/// as grains move over it: the picture is then that between those jumps where it is smoothest, if any is clearly
/// smoother.
std::vector<float> picture_at_rest(const LockinMaps& maps, const Bins& bins,
                                   const std::vector<std::vector<double>>& levels, const float* drift) {
  constexpr double clearly = 0.9;
  const auto& jumps = maps.levels.jumps;
  std::vector<float> best = maps.mean;
  if (jumps.empty()) return best;
  double least = clearly * roughness(best, static_cast<std::size_t>(maps.width));
  for (std::size_t k = 0; k <= jumps.size(); ++k) {
    std::vector<float> here = maps.mean;
    for (std::size_t j = 0; j < jumps.size(); ++j) {
      const float* size = drift + (bins.order - levels.size() + j) * maps.size();
      const auto level = static_cast<float>(levels[j][k == 0 ? 0 : jumps[k - 1].frame]);
      for (std::size_t p = 0; p < here.size(); ++p) here[p] += level * size[p];
    }
    if (const double rough = roughness(here, static_cast<std::size_t>(maps.width)); rough < least)
      least = rough, best = std::move(here);
  }
  return best;
}

/// Pixels without a value would spoil their lines in the spline.
void finish(const LockinMaps& maps, const Bins& bins, const std::vector<float>& mean, const float* drift, std::size_t b,
            float* picture) {
  for (std::size_t p = 0; p < maps.size(); ++p) {
    picture[p] = mean[p] + picture[p] / static_cast<float>(bins.frames[b]);
    for (std::size_t j = 0; j < bins.order; ++j)
      picture[p] -= drift[j * maps.size() + p] * static_cast<float>(bins.mean_slow(b, j));
    if (!std::isfinite(picture[p])) picture[p] = p > 0 ? picture[p - 1] : 0;
  }
  spline_coefficients(picture, maps.width, maps.height);
}

PhasePictures sorted_pictures(FilmSource& film, const std::vector<double>& time, const LockinMaps& maps,
                              const LockinOptions& options, std::size_t parts) {
  const auto levels = functions_of(maps.levels, time.size());
  const Bins bins = sort_frames(time, maps.frequency, parts, order_of(maps, time), levels);
  PhasePictures result{maps.width, maps.height, bins.frames, bins.phases, {}};
  const std::size_t pixels = result.pixels();
  result.spline.resize(result.size() * pixels);
  std::vector<float> drift(bins.order * pixels);
  const ThreadPool pool(options.threads);
  // A frame goes to its picture and, weighed, to the sums that give each pixel's drift.
  const auto take = [&](const auto* frames, std::size_t n, std::size_t some) {
    pool.for_ranges(pixels, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = 0; k < some; ++k) {
        const auto* frame = frames + k * pixels;
        float* sum = result.spline.data() + bins.of_frame[n + k] * pixels;
        for (std::size_t p = begin; p < end; ++p) sum[p] += static_cast<float>(frame[p]) - maps.mean[p];
        for (std::size_t j = 0; j < bins.order; ++j) {
          const float slow = bins.slow[(n + k) * bins.order + j];
          for (std::size_t p = begin; p < end; ++p)
            drift[j * pixels + p] += slow * (static_cast<float>(frame[p]) - maps.mean[p]);
        }
      }
    });
    return !options.progress || options.progress(static_cast<double>(n + some) / static_cast<double>(time.size()));
  };
  if (!read_frames(film, 0, time.size(), take)) return {};
  solve_drift(bins, result.spline.data(), pixels, drift.data(), pool);
  const std::vector<float> mean = picture_at_rest(maps, bins, levels, drift.data());
  pool.for_each(result.size(),
                [&](std::size_t b) { finish(maps, bins, mean, drift.data(), b, result.spline.data() + b * pixels); });
  return result;
}

}  // namespace

void spline_coefficients(float* picture, int width, int height) {
  for (int row = 0; row < height; ++row) filter(picture + static_cast<std::ptrdiff_t>(row) * width, width, 1);
  for (int column = 0; column < width; ++column) filter(picture + column, height, width);
}

PhasePictures phase_pictures(FilmSource& film, const LockinMaps& maps, const LockinOptions& options,
                             std::size_t parts) {
  const bool stored = maps.blank.empty() && !maps.time.empty();
  const std::vector<double> time = stored ? maps.time : frame_times(film.info());
  if (maps.blank.empty()) return sorted_pictures(film, time, maps, options, parts);
  FilmWithout kept(film, maps.blank, time);
  return sorted_pictures(kept, kept.info().time, maps, options, parts);
}

std::vector<float> picture_of(const PhasePictures& pictures, std::size_t k) {
  std::vector<float> values;
  Vec2 place, slope;
  for (place.y = 0; place.y < pictures.height; ++place.y)
    for (place.x = 0; place.x < pictures.width; ++place.x)
      values.push_back(
          static_cast<float>(Resampled(pictures.width, pictures.height, place).of(pictures.picture(k), slope)));
  return values;
}

std::size_t picture_at_smallest_load(const PhasePictures& pictures, double largest) {
  const double phase = largest + std::numbers::pi;
  std::size_t best = 0;
  double most = -2;
  for (std::size_t k = 0; k < pictures.size(); ++k) {
    const double along = pictures.phases[k][1] * std::cos(phase) + pictures.phases[k][2] * std::sin(phase);
    if (along > most) most = along, best = k;
  }
  return best;
}

double opposite(double phase) { return std::remainder(phase + std::numbers::pi, 2 * std::numbers::pi); }

bool are_opposite(double phase, double other) { return std::cos(phase - other) < 0; }

PixelHarmonics::PixelHarmonics(const PhasePictures& p, const GrainMotion& motion, std::size_t grain) {
  Matrix design(5, p.size()), weighed = design;
  for (std::size_t k = 0; k < p.size(); ++k) {
    moved_.push_back(p.moved(motion, grain, k));
    for (std::size_t m = 0; m < 5; ++m) design(m, k) = p.phases[k][m], weighed(m, k) = p.frames[k] * p.phases[k][m];
  }
  fit_ = transposed(solve_symmetric(times_transposed(design, weighed), weighed));
}

Followed PixelHarmonics::follow(const PhasePictures& p, Vec2 place) const {
  const std::size_t n = p.size();
  double frames = 0, noise = 0;
  Followed f;
  std::vector<double> value(n);
  for (std::size_t k = 0; k < n; ++k) {
    const Resampled here(p.width, p.height, place + moved_[k]);
    Vec2 slope;
    value[k] = here.of(p.picture(k), slope);
    for (std::size_t m = 0; m < 5; ++m) f.harmonics[m] += fit_(k, m) * value[k];
    frames += p.frames[k];
    noise += p.frames[k] * here.noise();
    f.slope += p.frames[k] * slope;
  }
  double rest = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const double fitted = std::inner_product(f.harmonics.begin(), f.harmonics.end(), p.phases[k].begin(), 0.0);
    rest += p.frames[k] * (value[k] - fitted) * (value[k] - fitted);
  }
  f.slope = f.slope / frames;
  f.variance = n > 5 ? rest / static_cast<double>(n - 5) * frames / noise : 0;
  return f;
}

}  // namespace arenite::thermography
