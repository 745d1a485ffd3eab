#pragma once
#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

#include "core/threads.hpp"
#include "statistics/least_squares.hpp"
#include "thermal/thermography/kernels/kernels.hpp"
#include "thermal/thermography/segment_sums.hpp"

namespace arenite::thermography {

/// Least squares of drift and harmonics of one frequency, the same for all pixels, as numbers by which the sums of
/// segments are multiplied. Functions fitted: Legendre polynomials of x = (t - middle)/half the film's time, changes of
/// the level, then cos(h w t), sin(h w t) of every harmonic h, the highest first, then, if asked for, x cos(w t), x
/// sin(w t), which show a frequency that is off, or cos and sin of frequencies beside w, which show the noise there.
/// The film is projected on the same functions with x and the phase of a small w - w_0 constant within a segment: what
/// is of the fitted form is found exactly, with a standard error larger than that of plain least squares by less than a
/// per cent.
struct HarmonicFit {
  double frequency = 0;    ///< Hz
  std::size_t drift = 0;   ///< polynomials, order + 1
  std::size_t levels = 0;  ///< changes of the level
  std::size_t harmonics = 0;
  double middle = 0, half = 0;          ///< s
  double spacing = 0;                   ///< Hz
  std::vector<int> beside = {};         ///< frequencies beside it, so many spacings above or below
  bool beat = false;                    ///< x cos(w t) and x sin(w t) are the last
  statistics::Matrix coefficient = {};  ///< transposed: (segments x planes) x functions
  statistics::Matrix covariance = {};   ///< of the fitted numbers over the variance of the noise
  statistics::Matrix normal = {};  ///< sums of products of the fitted functions, unless there are frequencies beside

  std::size_t size() const { return side(beside.size()) + (beat ? 2 : 0); }
  /// Column of cos of harmonic h; sin is next to it.
  std::size_t harmonic(std::size_t h) const { return slow() + 2 * (harmonics - h); }
  /// All that is no oscillation.
  std::size_t slow() const { return drift + levels; }
  /// Column of cos of frequency k beside; sin is next to it.
  std::size_t side(std::size_t k) const { return slow() + 2 * (harmonics + k); }
  /// Variance of the amplitude over what it would be if nothing else were fitted to as many frames: 1 in a film of many
  /// cycles, far more where drift and harmonics can do what the load's frequency does.
  double inflation(std::size_t frames) const {
    const std::size_t a = harmonic(1);
    return (covariance(a, a) + covariance(a + 1, a + 1)) * static_cast<double>(frames) / 4;
  }
};

HarmonicFit harmonic_fit(const SegmentSums& sums, double frequency, int drift_order, bool with_beat, double spacing = 0,
                         std::vector<int> beside = {});

/// 1 and the weights of the pass in the frames of segment k: weights x frames.
statistics::Matrix pass_weights(const SegmentSums& sums, std::size_t k);

/// Legendre polynomials P_0 .. P_order at x and their slopes.
void legendre(double x, std::size_t count, double* value, double* slope = nullptr);

/// Fitted numbers of a run of pixels, in doubles: number m of pixel begin + i is value[m * run + i].
struct PixelFit {
  static constexpr std::size_t run = 16 * chunk;
  std::vector<double> value;
  std::vector<double> variance;  ///< of the noise, from what the fit leaves; only if asked for
};

/// The numbers `from` .. `from + rows - 1` of the fit for pixels begin .. begin + count - 1, of which there are at most
/// `run`.
void fit_pixels(const SegmentSums& sums, const HarmonicFit& fit, std::size_t from, std::size_t rows, std::size_t begin,
                std::size_t count, PixelFit& out);

/// All numbers, relative to the film's first frame, and the variance.
void fit_pixels_with_variance(const SegmentSums& sums, const HarmonicFit& fit, std::size_t begin, std::size_t count,
                              PixelFit& out);

/// Calls work(run number, first pixel, pixels) for all runs of all pixels, on the whole team.
template <class Work> void for_runs(const SegmentSums& sums, const ThreadPool& pool, const Work& work) {
  const std::size_t runs = (sums.pixels + PixelFit::run - 1) / PixelFit::run;
  pool.for_each(runs, [&](std::size_t r) {
    work(r, r * PixelFit::run, std::min(PixelFit::run, sums.pixels - r * PixelFit::run));
  });
}

/// Calls work(first pixel, pixels) for at most about `most` chunks of pixels, spread over the picture.
template <class Work> void for_some_chunks(const SegmentSums& sums, std::size_t most, const Work& work) {
  const std::size_t chunks = (sums.pixels + chunk - 1) / chunk, every = std::max<std::size_t>(1, chunks / most);
  for (std::size_t c = 0; c < chunks; c += every) work(c * chunk, std::min(chunk, sums.pixels - c * chunk));
}

}  // namespace arenite::thermography
