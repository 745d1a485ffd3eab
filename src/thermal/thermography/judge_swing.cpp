#include "thermal/thermography/judge_swing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "thermal/thermography/frame_times.hpp"
#include "thermal/thermography/lockin.hpp"
#include "thermal/thermography/noise_around.hpp"
#include "thermal/thermography/refine_frequency.hpp"
#include "thermal/thermography/watched_pixels.hpp"

namespace arenite::thermography {

bool shows_swing(const LockinMaps& maps) {
  constexpr double level = 0.01, one_phase = 0.5;
  return maps.chance < level && maps.one_phase >= one_phase;
}

/// Seven times the error of a film of many cycles: nothing that such maps show would be the load's.
void refuse_too_few_cycles(const HarmonicFit& fit, const SegmentSums& s) {
  if (fit.inflation(s.time.size()) < 50) return;
  const double length = film_length(s.time);
  throw InputError(fmt::format("the film of {:.4g} s holds {:.3g} cycles of {:.6g} Hz, too few to tell the swing from a drift of order {}; ask for less drift, or "
                               "give a longer film", length, length * fit.frequency, fit.frequency, fit.drift - 1));
}

void judge_swing(const SegmentSums& s, const HarmonicFit& fit, const std::optional<FrequencyFit>& refined, LockinMaps& maps) {
  const NoiseAround around = noise_around(s, fit, refined ? frequencies_in(search_band(s.time, s.frequency), s.time) : 1);
  maps.noise_ratio = around.ratio;
  maps.chance = around.chance;
  maps.one_phase = around.one_phase;
  if (refined) maps.frequency_error = std::hypot(refined->error * std::sqrt(around.ratio * around.together), refined->of_model);
  const WatchedPixels watched(s);
  const bool clear = shows_swing(maps) && watched.have_line(fit.frequency);
  const auto elsewhere = clear ? watched.stronger_part(fit.frequency) : watched.strongest_line();
  if (!elsewhere || std::abs(*elsewhere - fit.frequency) * film_length(s.time) < 0.7) return;  // the same line
  maps.swings_at = *elsewhere;
  if (!clear) maps.chance = 1;  // it leaks there from the other
  if (!refined) return;
  const int digits = static_cast<int>(std::ceil(std::log10(*elsewhere * film_length(s.time)))) + 2;  // a hundredth of a cycle over the film
  const std::string there = fmt::format("{:.{}g} Hz", *elsewhere, std::max(digits, 3));
  if (clear)
    throw InputError(fmt::format("the film swings more at {} than at {:.6g} Hz, which is a multiple; give the frequency of the load, {}", there, s.frequency, there));
  throw InputError(fmt::format("nothing but noise swings at {:.6g} Hz, but the film swings at {}; if that is the load, give this frequency", s.frequency, there));
}

}  // namespace arenite::thermography
