#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/thread_count.hpp"
#include "model/film.hpp"
#include "thermal/thermography/segment_sums.hpp"

namespace arenite::thermography {

struct StepOptions {
  std::optional<double> time;  ///< of the middle of the step, s after the first frame; without it found on the film
  double rise = 0;             ///< s that the load takes; frames within it are left out, and those that the film shows
  double window = 0;           ///< s before and after the step that are used; 0: the whole film
  int drift_order = 1;         ///< of the polynomial in time by which a pixel drifts on each side, 0 to 4
  int threads = Threads{}.threads;
  Progress progress;
};

/// What a film shows of one step of the load, in the film's unit, rows from the top.
struct StepMaps {
  int width = 0, height = 0;
  double time = 0;                    ///< of the middle of the step, s after the first frame
  std::size_t before = 0, after = 0;  ///< frames used
  std::vector<std::int64_t> blank;    ///< frames of the film that hold no whole picture and were left out
  int drift_order = 0;
  double relaxation_before = 0,
         relaxation_after = 0;  ///< s, of the exponential that was fitted on a side beside the polynomial; 0: none was
  double time_error = 0;        ///< s, of a time that was found
  double rise = 0;              ///< s for which the film shows the load on its way; 0: it does not
  std::vector<double> level_jumps = {};  ///< s, where pixels jump beside the step; each was fitted with its own
  std::vector<std::string> doubts = {};  ///< what the film shows against what a step is taken for, each a sentence
  std::vector<float> jump =
      {};  ///< after less before, both continued to the middle of the step: -A times the stress step
  std::vector<float> standard_error =
      {};                         ///< of the jump, from the residual, its correlation and what the fit may miss
  std::vector<float> level = {};  ///< before, continued to the middle of the step
  std::vector<float> drift_before = {}, drift_after = {};  ///< slopes there, unit/s
  std::vector<float> residual = {};                        ///< root mean square of what the fit leaves

  std::size_t size() const { return jump.size(); }
};

/// The jump of every pixel between two polynomials in time, one before and one after a step of the load, by least
/// squares with a common noise: the signal of a load that does not cycle. A step is adiabatic only at its middle: where
/// heat that flows later makes the pixels relax by more than their noise, an exponential joins the polynomial. A first
/// pass looks at some thousand pixels: it finds that, the noise and, where no time is given, the split of the film that
/// explains most; frames in which it sees the load on its way are left out. InputError for a step outside the film, too
/// few frames on a side, a film in which nothing changes or, where it is to be found, without a step. Empty maps if
/// `progress` stopped it.
StepMaps step_load(FilmSource& film, const StepOptions& options);

}  // namespace arenite::thermography
