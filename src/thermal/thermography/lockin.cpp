#include "thermal/thermography/lockin.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/mapped.hpp"
#include "core/median.hpp"
#include "core/problems.hpp"
#include "core/text.hpp"
#include "thermal/thermography/blank_frames.hpp"
#include "thermal/thermography/film_checks.hpp"
#include "thermal/thermography/harmonic_fit.hpp"
#include "thermal/thermography/judge_amplitude.hpp"
#include "thermal/thermography/level_changes.hpp"
#include "thermal/thermography/load_phases.hpp"
#include "thermal/thermography/lost_frames.hpp"
#include "thermal/thermography/refine_frequency.hpp"
#include "thermal/thermography/shared_noise.hpp"
#include "thermal/thermography/watched_pixels.hpp"

namespace arenite::thermography {
namespace {

void check(const LockinOptions& o) {
  if (!(o.frequency > 0) || !std::isfinite(o.frequency)) throw InputError("the load frequency must be above 0 Hz");
  if (o.drift_order < 0 || o.drift_order > 8) throw refusal("the drift order is {}; it must be 0 to 8", o.drift_order);
  if (o.harmonics < 1 || o.harmonics > 4) throw refusal("{} harmonics were requested; give 1 to 4", o.harmonics);
}

/// How many harmonics can be told apart with these frames; throws where not even the load frequency can.
int possible_harmonics(const std::vector<double>& time, const LockinOptions& o) {
  if (time.size() < 2) throw InputError("a lock-in needs a film of many frames; this has one");
  const double nyquist = nyquist_frequency(time), cycles = o.frequency * (time.back() - time.front());
  if (o.frequency >= nyquist)
    throw refusal(
        "the load frequency of {:.6g} Hz is at or above the Nyquist frequency of {:.6g} Hz, half the frame rate, so "
        "the film cannot resolve the load cycle",
        o.frequency, nyquist);
  const double frame = 0.5 / nyquist;
  if (cycles + o.frequency * frame < 1 - 1e-9)
    throw refusal("the film of {:.4g} s holds {:.3g} cycles of {:.6g} Hz; a lock-in needs at least one",
                  time.back() - time.front() + frame, cycles, o.frequency);
  const int harmonics = std::min(o.harmonics, static_cast<int>(std::ceil(nyquist / o.frequency - 1e-6)) - 1);
  const auto unknowns = static_cast<std::size_t>(o.drift_order + 1 + 2 * harmonics);
  if (time.size() < unknowns + 4)
    throw refusal(
        "the film has {} frames, too few for {} unknowns per pixel; use fewer harmonics or a lower drift order",
        time.size(), unknowns);
  return std::max(harmonics, 1);
}

/// Of a pixel that never changes all sums are 0, and of one that is no number none is larger or smaller.
void refuse_constant(const SegmentSums& s) {
  if (std::ranges::any_of(s.sums, [](float sum) { return std::abs(sum) > 0; })) return;
  throw InputError(without_change);
}

/// Fills all maps but those that need the reference; cos and sin of the first harmonic go to `phasor`.
void fill(const SegmentSums& s, const HarmonicFit& fit, const ThreadPool& pool, LockinMaps& maps,
          std::vector<double> (&phasor)[2]) {
  const bool second = fit.harmonics > 1;
  for (const auto& map : lockin_maps)
    if (second || map.values != &LockinMaps::second_harmonic) (maps.*map.values).resize(s.pixels);
  for (auto& each : phasor) each.resize(s.pixels);
  const double factor = 2 / to_peak_to_peak(maps.convention);
  const auto a = fit.harmonic(1);
  const double spread = std::sqrt(maps.noise_ratio * (fit.covariance(a, a) + fit.covariance(a + 1, a + 1)) / 2);
  std::vector<double> value(fit.drift), slope(fit.drift);
  legendre(0, fit.drift, value.data(), slope.data());
  for_runs(s, pool, [&](std::size_t, std::size_t begin, std::size_t count) {
    PixelFit pixels;
    fit_pixels_with_variance(s, fit, begin, count, pixels);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t p = begin + i;
      const auto number = [&](std::size_t m) { return pixels.value[m * PixelFit::run + i]; };
      double mean = static_cast<double>(s.base[p]), drift = 0;
      for (std::size_t j = 0; j < fit.drift; ++j) mean += value[j] * number(j), drift += slope[j] * number(j);
      Harmonics fitted{mean, number(a), number(a + 1)};
      if (second) fitted[3] = number(fit.harmonic(2)), fitted[4] = number(fit.harmonic(2) + 1);
      put(maps, p, fitted, std::sqrt(pixels.variance[i]), spread);
      maps.drift[p] = static_cast<float>(drift / fit.half);
      phasor[0][p] = factor * fitted[1];
      phasor[1][p] = factor * fitted[2];
    }
  });
}

void project(LockinMaps& maps, const std::vector<double>& cosine, const std::vector<double>& sine) {
  const double c = std::cos(maps.reference_phase), s = std::sin(maps.reference_phase);
  for (std::size_t p = 0; p < maps.size(); ++p) {
    maps.in_phase[p] = static_cast<float>(c * cosine[p] + s * sine[p]);
    maps.quadrature[p] = static_cast<float>(c * sine[p] - s * cosine[p]);
  }
}

/// A sentence for each kind of change of the level.
void tell_levels(const std::vector<double>& time, LockinMaps& maps) {
  constexpr std::size_t most = 5;
  const LevelChanges& changes = maps.levels;
  double common = 0, own = 0;
  std::vector<std::string> when;
  for (const LevelJump& jump : changes.jumps) {
    common = std::max(common, std::abs(jump.common)), own = std::max(own, jump.own);
    if (when.size() < most) when.push_back(fmt::format("{:.4g} s", time[jump.frame]));
  }
  if (changes.jumps.size() > most) when.push_back(fmt::format("{} more times", changes.jumps.size() - most));
  if (!when.empty())
    maps.disturbances.push_back(fmt::format(
        "the level of the pixels jumps at {}, by up to {:.2g} in all pixels and {:.2g} from one to another (in the "
        "unit of the film), as where a camera closes its shutter; every pixel is fitted with its own jumps",
        list_of(when), common, own));
  if (changes.course.empty()) return;
  const auto [low, high] = std::ranges::minmax(changes.course);
  maps.disturbances.push_back(
      fmt::format("all pixels drift along a curve of {:.2g} (in the unit of the film) that no polynomial of order {} "
                  "follows; every pixel is fitted with that curve, too",
                  high - low, maps.drift_order));
}

/// Sentences for a film without time stamps in whose segments the phase of the load wanders.
void tell_wander(const LoadPhases& phases, const std::vector<LostFrames>& lost, LockinMaps& maps) {
  if (!lost.empty()) {
    for (const LostFrames& each : lost) maps.lost_frames += each.count;
    maps.disturbances.push_back(
        fmt::format("{} frames are missing at {} places though no time stamp shows it: only so the load has one "
                    "frequency; frames are given the times that they then have",
                    maps.lost_frames, lost.size()));
    return;
  }
  constexpr double steady = 0.1;  // rad, which takes half a per cent from amplitudes
  if (phases.wander < std::max(steady, 4 * phases.noise)) return;
  maps.disturbances.push_back(
      fmt::format("the phase of the load wanders by {:.2g} deg over the film: its frequency is not steady, or frames "
                  "were lost; amplitudes are about {:.2g} % too small",
                  phases.wander * 180 / std::numbers::pi, 100 * (1 - std::exp(-phases.wander * phases.wander / 2))));
}

/// Of a film that shows a load at this frequency, and none of which it is a multiple.
LevelChanges level_changes(SegmentSums& sums, double frequency, int drift_order, const ThreadPool& pool) {
  LevelChanges found = find_level_changes(sums, frequency, drift_order, pool);
  if (found.empty()) return found;
  // A course may hold the oscillation of which this frequency is a multiple; jumps hide those that there are.
  sums.levels = functions_of({found.jumps, {}}, sums.time.size());
  const WatchedPixels watched(sums);
  if (watched.have_line(frequency) && !watched.stronger_part(frequency)) return found;
  sums.levels.clear();
  return {};
}

/// What a first look at a film has shown of it.
struct Known {
  std::vector<LostFrames> lost = {};  ///< that the times allow for already
  LevelChanges levels = {};
  bool looked = false;  ///< for changes of the level
};

LockinMaps locked_in(FilmSource& film, const LockinOptions& o, std::vector<double> time, int harmonics,
                     Known known = {}) {
  const ThreadPool pool(o.threads);
  SegmentSums sums =
      sum_segments(film, std::move(time), o.frequency, harmonics, o.drift_order, pool, o.progress, known.levels);
  if (sums.sums.empty()) return {};
  const MissingPixels missing = missing_pixels(sums, pool);
  if (may_lack_frames(sums, missing))
    if (const auto blank = blank_frames(film); !blank.empty()) {
      FilmWithout kept(film, blank, sums.time);
      sums = {};
      LockinMaps maps = of_other_frames(
          blank, [&] { return locked_in(kept, o, kept.info().time, possible_harmonics(kept.info().time, o), known); });
      maps.blank = blank;
      return maps;
    }
  refuse_constant(sums);
  std::optional<FrequencyFit> refined;
  if (o.refine) refined = refine_frequency(sums, o.drift_order, pool);
  if (!std::exchange(known.looked, true))
    if (auto found = level_changes(sums, refined ? refined->frequency : o.frequency, o.drift_order, pool);
        !found.empty()) {
      known.levels = std::move(found);
      std::vector<double> again = std::move(sums.time);
      sums = {};
      return locked_in(film, o, std::move(again), harmonics, std::move(known));
    }
  const std::vector<LostFrames>& lost = known.lost;
  LoadPhases phases;
  const WatchedPixels watched(sums);
  // A load of another frequency, which is refused below, would be made one of this by losses that were none.
  if (refined && film.info().time.empty() && lost.empty() && watched.have_line(refined->frequency)) {
    phases = load_phases(sums);
    constexpr double in_step = 0.003, by_noise = 1.7;  // rad; of sixteen segments or more, once in some thousand films
    if (phases.wander > std::max(in_step, by_noise * phases.noise))
      if (const auto found = find_lost_frames(film, sums, phases, o.progress); !found.empty()) {
        known.lost = found;
        return locked_in(film, o, times_with_losses(sums.time.size(), sums.time[1] - sums.time[0], found), harmonics,
                         std::move(known));
      }
  }
  LockinMaps maps;
  maps.width = film.info().width, maps.height = film.info().height;
  maps.frequency = refined ? refined->frequency : o.frequency;
  maps.frames = sums.time.size();
  maps.drift_order = o.drift_order, maps.harmonics = harmonics;
  maps.convention = o.convention;
  maps.levels = known.levels;
  tell_failing_pixels(missing, maps);
  tell_levels(sums.time, maps);
  tell_wander(phases, lost, maps);
  if (!lost.empty()) maps.time = sums.time;
  const HarmonicFit fit = harmonic_fit(sums, maps.frequency, o.drift_order, false);
  refuse_too_few_cycles(fit, sums);
  judge_amplitude(sums, fit, refined, watched, pool, maps);
  tell_far_frequency(o.frequency, maps);
  std::vector<double> phasor[2];
  fill(sums, fit, pool, maps, phasor);
  const auto phase = [&] { return o.reference_phase ? *o.reference_phase : reference_phase(phasor[0], phasor[1]); };
  maps.reference_phase = phase();
  if (take_off_shared_noise(maps, phasor[0], phasor[1])) maps.reference_phase = phase();
  project(maps, phasor[0], phasor[1]);
  return maps;
}

}  // namespace

void put(LockinMaps& maps, std::size_t p, const Harmonics& fitted, double noise, double spread) {
  const auto [mean, cosine, sine, cosine2, sine2] = fitted;
  const double factor = 2 / to_peak_to_peak(maps.convention), error = factor * spread * noise;
  maps.mean[p] = static_cast<float>(mean);
  maps.amplitude[p] = static_cast<float>(factor * std::sqrt(cosine * cosine + sine * sine));
  maps.phase[p] = static_cast<float>(std::atan2(sine, cosine));
  if (!maps.second_harmonic.empty())
    maps.second_harmonic[p] = static_cast<float>(factor * std::sqrt(cosine2 * cosine2 + sine2 * sine2));
  maps.residual[p] = static_cast<float>(noise), maps.standard_error[p] = static_cast<float>(error);
  maps.noise_floor[p] = static_cast<float>(std::sqrt(std::numbers::pi / 2) * error);
}

std::vector<float> phase_after_load(const LockinMaps& maps) {
  const double turn = 2 * std::numbers::pi;
  return mapped<float>(maps.phase, [&](float phase) { return std::remainder(phase - maps.reference_phase, turn); });
}

double reference_phase(const std::vector<double>& cosine, const std::vector<double>& sine) {
  std::vector<double> sizes;
  for (std::size_t p = 0; p < cosine.size(); ++p)
    if (const double size = std::hypot(cosine[p], sine[p]); size > 0 && std::isfinite(size)) sizes.push_back(size);
  const double most = 3 * median(std::move(sizes));
  double real = 0, imaginary = 0, c = 0, s = 0;
  for (std::size_t p = 0; p < cosine.size(); ++p) {
    const double size = std::hypot(cosine[p], sine[p]), part = size > most ? most / size : 1;
    if (!std::isfinite(size)) continue;
    const double x = part * cosine[p], y = part * sine[p];
    real += x * x - y * y;
    imaginary += 2 * x * y;
    c += x;
    s += y;
  }
  const double phase = 0.5 * std::atan2(imaginary, real);
  if (c * std::cos(phase) + s * std::sin(phase) >= 0) return phase;
  return phase > 0 ? phase - std::numbers::pi : phase + std::numbers::pi;
}

double Adiabatic::lost() const {
  const double wave = std::numbers::pi * length / pixel;
  return 1 - 1 / std::hypot(1.0, wave * wave / 2);
}

std::string Adiabatic::sentence() const {
  return fmt::format(
      "heat diffuses over {:.3g} pixels within a cycle, which is not much less than one: the finest detail of the "
      "signal is not adiabatic; raise the load frequency",
      length / pixel);
}

LockinMaps lock_in(FilmSource& film, const LockinOptions& options) {
  check(options);
  const std::vector<double> time = frame_times(film.info());
  return locked_in(film, options, time, possible_harmonics(time, options));
}

LockinMaps nearest_bin_transform(FilmSource& film, const LockinOptions& options) {
  LockinOptions o = options;
  o.refine = false;
  o.drift_order = 0;
  check(o);
  FilmInfo even = film.info();
  if (even.time.size() > 1 && even.frame_rate <= 0) even.frame_rate = 1 / mean_interval(even.time);
  even.time.clear();
  even.number.clear();
  std::vector<double> time = frame_times(even);
  const int harmonics = possible_harmonics(time, o);
  const double length = film_length(time);
  o.frequency = std::max(1.0, std::round(o.frequency * length)) / length;
  return locked_in(film, o, std::move(time), harmonics, {.looked = true});
}

}  // namespace arenite::thermography
