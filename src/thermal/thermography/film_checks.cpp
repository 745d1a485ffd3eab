#include "thermal/thermography/film_checks.hpp"

#include <fmt/core.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "core/median.hpp"
#include "core/problems.hpp"
#include "model/lockin_maps.hpp"
#include "statistics/numbers_text.hpp"
#include "thermal/thermography/judge_amplitude.hpp"
#include "thermal/thermography/lockin.hpp"

namespace arenite::thermography {
namespace {

/// Hotter than this is no sample of plastics, rock or glass under a press, and a level of a camera.
constexpr double hottest = 1000;
/// No grain stays elastic at a stress that warms it by so much.
constexpr double largest_amplitude = 5;
/// Of a cycle: where most of the amplitude is lost.
constexpr double phase_refused = 0.125;

double wrapped(double cycles) { return cycles - std::round(cycles); }

}  // namespace

std::string no_load_sentence(const LockinMaps& maps, double frequency, std::string_view given_by) {
  if (maps.other_frequency > 0)
    return fmt::format(
        "the film shows only noise at {:.6g} Hz, but an oscillation at {:.4g} Hz; if that is the load, give its "
        "frequency ({})",
        frequency, maps.other_frequency, given_by);
  if (std::isnan(maps.chance))
    return fmt::format(
        "no pixel of the film has numbers in all frames and noise, so nothing is known of a load at {:.6g} Hz; give a "
        "film of a loaded sample as the camera recorded it",
        frequency);
  if (maps.chance < 0.01)
    return fmt::format(
        "the signal at {:.6g} Hz does not have a common phase, as under a load, but is a spectral line of the camera; "
        "give the frequency of the load ({}), or a film of a loaded sample",
        frequency, given_by);
  return fmt::format(
      "the film shows only noise at {:.6g} Hz; give the frequency of the load ({}), or a film of a loaded sample",
      frequency, given_by);
}

void tell_far_frequency(double given, LockinMaps& maps) {
  constexpr double far = 0.01, errors = 5;
  const double off = std::abs(maps.frequency - given);
  if (!shows_load(maps) || !(off > far * given) || !(off > errors * maps.frequency_error)) return;
  maps.disturbances.push_back(fmt::format(
      "the load oscillates at {} Hz, {:.2g} % off the {:.6g} Hz given: the frequency given or the frame rate is wrong, "
      "or frames are missing",
      statistics::with_error({maps.frequency, maps.frequency_error}), 100 * off / given, given));
}

void refuse_without_load(const LockinMaps& maps, double given_frequency) {
  if (!shows_load(maps)) throw InputError(no_load_sentence(maps, given_frequency, "lockin.frequency"));
}

double phase_off(const LockinMaps& maps, double given_cycles) {
  std::vector<double> cosine, sine;
  for (std::size_t p = 0; p < maps.size(); ++p) {
    const auto a = static_cast<double>(maps.amplitude[p]), phase = static_cast<double>(maps.phase[p]);
    if (!(a > 5 * static_cast<double>(maps.standard_error[p]))) continue;
    cosine.push_back(a * std::cos(phase));
    sine.push_back(a * std::sin(phase));
  }
  if (cosine.empty()) return 0;
  return wrapped(reference_phase(cosine, sine) / (2 * std::numbers::pi) - given_cycles);
}

void refuse_impossible(const LockinMaps& maps) {
  const double level = median_of_finite(maps.mean);
  if (level > hottest)
    throw refusal(
        "its values are about {:.4g}, which cannot be temperatures of a sample in kelvin: camera levels are taken for "
        "kelvin; choose temperature.from = \"references\", \"curve\" or \"radiometry\", or give the scale of the film",
        level);
  const double amplitude = median_of_finite(maps.amplitude);
  if (amplitude > largest_amplitude)
    throw refusal(
        "half of its pixels have amplitudes above {:.3g} K, impossible for elastic grains: camera levels are taken for "
        "kelvin, or the calibration is wrong; check [temperature]",
        amplitude);
}

void refuse_wrong_phase(const LockinMaps& maps, std::optional<double> given_phase) {
  if (!given_phase) return;
  const double given = *given_phase / (2 * std::numbers::pi), off = phase_off(maps, given);  // in cycles
  if (std::abs(off) > phase_refused)
    throw refusal(
        "it warms {:.4g} deg {} the phase that lockin.phase = \"{:.4g} deg\" gives ({}); give \"{:.4g} deg\", or leave "
        "lockin.phase out to have it found",
        360 * std::abs(off), off > 0 ? "after" : "before", 360 * given,
        std::abs(off) > 0.5 - phase_refused ? "half a cycle: it cools where it should warm"
                                            : "warming is in phase with its load",
        360 * wrapped(given + off));
}

}  // namespace arenite::thermography
