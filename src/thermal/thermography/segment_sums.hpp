#pragma once
#include <cstddef>
#include <functional>
#include <vector>

#include "core/pages.hpp"
#include "core/threads.hpp"
#include "model/film.hpp"
#include "model/lockin_maps.hpp"
#include "thermal/thermography/kernels/kernels.hpp"

namespace arenite::thermography {

/// Times of all frames, s after the first: its stamps, so that dropped frames leave a gap, or number over frame rate
/// where frames are not stamped (their own numbers, where the film has them). Another rate is given where the film is
/// opened (io::FilmChoice). Throws InputError where there is no rate at all or stamps do not rise.
std::vector<double> frame_times(const FilmInfo& film);

/// From the beginning of the first frame to the end of the last, s.
inline double film_length(const std::vector<double>& time) {
  const auto frames = static_cast<double>(time.size());
  return time.size() < 2 ? 0 : (time.back() - time.front()) * frames / (frames - 1);
}

/// From one frame to the next in the mean over a film of two frames or more, s.
inline double mean_interval(const std::vector<double>& time) {
  return (time.back() - time.front()) / static_cast<double>(time.size() - 1);
}

/// Half the rate of frames where they follow each other without a gap, Hz.
double nyquist_frequency(const std::vector<double>& time);

/// Called with the share of the frames that has been read; false stops.
using Progress = std::function<bool(double share)>;

/// What one pass over a film keeps of every pixel: for each of some ten segments of the film, the sums of its values
/// weighed with 1 and with cos and sin of every harmonic h of `frequency`, counted from the middle of the segment, and
/// the sum of their squares. Fits for all frequencies near by follow from these sums: segments are turned against each
/// other and need not be read again. Values are taken relative to the first frame of the segment.
struct SegmentSums {
  std::vector<double> time;        ///< s after the first frame, one a frame
  std::vector<std::size_t> first;  ///< first frame of every segment, and the end
  std::vector<double> centre;      ///< time of the middle of every segment, s
  double frequency = 0;            ///< of the weights, Hz
  std::size_t functions = 0;       ///< cos and sin of all harmonics
  std::vector<float> weights;      ///< frames x functions
  std::size_t pixels = 0;
  std::vector<float> base;                  ///< first frame
  std::vector<std::size_t> watched;         ///< some pixels spread over the picture, whose every value is kept
  std::vector<std::vector<double>> levels;  ///< further functions of time that pixels follow, one value a frame
  std::vector<float> seen;  ///< watched x frames, less the pixel's first value; threads write apart from each other
  Buffer<float> sums;       ///< see SegmentView; planes 1, functions, squares, first frame less the film's first

  std::size_t segments() const { return centre.size(); }
  std::size_t planes() const { return functions + 3; }
  double frames_of(std::size_t segment) const { return static_cast<double>(first[segment + 1] - first[segment]); }
  SegmentView view() const { return {sums.data(), segments(), planes()}; }
};

/// One pass over the film with `harmonics` (1 to 4) of `frequency`; a film in memory is not copied. Every segment is
/// short against the drift polynomial of this order and, where the film allows it, against the beat of a frequency that
/// is 1e-2 off. Pixels may follow `changes` of their level, each its own share of them: no segment goes on over a jump.
/// No sums if `progress` stopped it.
SegmentSums sum_segments(FilmSource& film, std::vector<double> time, double frequency, int harmonics, int drift_order,
                         const ThreadPool& pool, const Progress& progress, const LevelChanges& changes = {});

}  // namespace arenite::thermography
