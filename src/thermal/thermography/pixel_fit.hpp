#pragma once
#include <algorithm>
#include <vector>

#include "thermal/thermography/harmonic_fit.hpp"

namespace arenite::thermography {

/// Fitted numbers of a run of pixels, in doubles: number m of pixel begin + i is value[m * run + i].
struct PixelFit {
  static constexpr std::size_t run = 16 * chunk;
  std::size_t begin = 0, count = 0;
  std::vector<double> value;
  std::vector<double> variance;     ///< of the noise, from what the fit leaves; only if asked for
};

/// The numbers `from` .. `from + rows - 1` of the fit for pixels begin .. begin + count - 1, of which there are at most `run`.
void fit_pixels(const SegmentSums& sums, const HarmonicFit& fit, std::size_t from, std::size_t rows, std::size_t begin, std::size_t count,
                PixelFit& out);

/// All numbers, relative to the film's first frame, and the variance.
void fit_pixels_with_variance(const SegmentSums& sums, const HarmonicFit& fit, std::size_t begin, std::size_t count, PixelFit& out);

/// Calls work(run number, first pixel, pixels) for all runs of all pixels, on the whole team.
template <class Work>
void for_runs(const SegmentSums& sums, const Team& team, const Work& work) {
  const std::size_t runs = (sums.pixels + PixelFit::run - 1) / PixelFit::run;
  team.for_each(runs, [&](std::size_t r) { work(r, r * PixelFit::run, std::min(PixelFit::run, sums.pixels - r * PixelFit::run)); });
}

/// Calls work(first pixel, pixels) for at most about `most` chunks of pixels, spread over the picture.
template <class Work>
void for_some_chunks(const SegmentSums& sums, std::size_t most, const Work& work) {
  const std::size_t chunks = (sums.pixels + chunk - 1) / chunk, every = std::max<std::size_t>(1, chunks / most);
  for (std::size_t c = 0; c < chunks; c += every) work(c * chunk, std::min(chunk, sums.pixels - c * chunk));
}

}  // namespace arenite::thermography
