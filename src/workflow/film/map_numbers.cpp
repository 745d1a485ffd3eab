#include "workflow/film/map_numbers.hpp"

#include <algorithm>
#include <numbers>

#include "thermal/thermography/judge_amplitude.hpp"

namespace arenite::workflow {

using statistics::described;
using statistics::Estimate;
using statistics::put;
using statistics::put_angle;

namespace {

constexpr double degrees = 180 / std::numbers::pi;

/// Whether there is a load at all, and what noise alone would do.
void put_judgement(Numbers& j, const LockinMaps& m) {
  j["noise_ratio"] = described(m.noise_ratio, "",
                               "Variance of the noise at this frequency over that of white noise of the same residual");
  j["shows_load"] =
      described(thermography::shows_load(m), "", "Whether pixels oscillate in one phase, and more than noise does");
  j["chance_of_noise"] = described(m.chance, "", "Probability that noise alone has as much amplitude in one phase");
  j["share_in_one_phase"] = described(
      m.one_phase, "",
      "Share of the amplitude above the noise that has one phase, or its opposite; any value where there is no load");
  if (m.other_frequency > 0)
    j["other_frequency_Hz"] = described(m.other_frequency, "Hz",
                                        "Frequency at which the film oscillates where that of the load shows nothing");
}

}  // namespace

Numbers lockin_numbers(const LockinMaps& m, const std::string& unit) {
  const char* kelvin = unit == "K" ? "K" : "";
  Numbers j{{"convention", name_of(m.convention)}, {"unit", unit}};
  put(j, "frequency_Hz", Estimate{m.frequency, m.frequency_error}, "Hz", "Frequency of the load");
  put_angle(j, "reference_phase_deg", m.reference_phase * degrees, statistics::whole_turn,
            "Phase of the load: the angle still to go to its maximum at the first frame");
  j["frames"] = described(m.frames, "", "Frames used");
  j["blank_frames"] = described(m.blank, "", "Frames that hold no whole picture and are left out");
  j["lost_frames"] =
      described(m.lost_frames, "", "Frames missing without a time stamp that shows it, found by the phase of the load");
  j["drift_order"] = described(m.drift_order, "", "Order of the polynomial that describes the drift of a pixel");
  j["harmonics"] = described(m.harmonics, "", "Harmonics of the load frequency that were fitted");
  j["level_jumps"] = described(m.levels.jumps.size(), "",
                               "Jumps of the pixels' level (a camera's shutter), each fitted in every pixel");
  if (!m.levels.course.empty()) {
    const auto [low, high] = std::ranges::minmax(m.levels.course);
    j["common_drift"] =
        described(high - low, kelvin, "Drift of all pixels beside the polynomial, fitted in every pixel");
  }
  put_judgement(j, m);
  j["common_error"] = described(m.common_error, kelvin, "Standard error of in_phase that all pixels share");
  j["column_error"] = described(m.column_error, kelvin, "Standard error of in_phase that the pixels of a column share");
  return j;
}

Numbers step_numbers(const thermography::StepMaps& m) {
  const auto relaxation = [](double time, const char* sentence) {
    return described(time > 0 ? Numbers(time) : Numbers(), "s", sentence);
  };
  return {{"time_s", described(m.time, "s", "Middle of the step after the first frame")},
          {"rise_s",
           described(m.rise, "s", "Time for which the film shows the load on its way; frames in between are left out")},
          {"frames_before", described(m.before, "", "Frames used before the step")},
          {"frames_after", described(m.after, "", "Frames used after it")},
          {"blank_frames", described(m.blank, "", "Frames that hold no whole picture and are left out")},
          {"drift_order",
           described(m.drift_order, "", "Order of the polynomial that describes the drift of a pixel on each side")},
          {"relaxation_before_s",
           relaxation(m.relaxation_before, "Time of the exponential by which pixels relax before the step")},
          {"relaxation_after_s",
           relaxation(m.relaxation_after, "Time of the exponential by which pixels relax after the step")}};
}

}  // namespace arenite::workflow
