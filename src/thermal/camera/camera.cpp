#include "thermal/camera/camera.hpp"

#include <fmt/core.h>

#include <cmath>
#include <numbers>
#include <string>

namespace arenite::camera {
namespace {

using Visitor = ParameterVisitor;

void declare(Visitor& v, Optics& optics) {
  v.integer({"width", "Pixels in a row."}, optics.width, {8, 8192});
  v.integer({"height", "Rows."}, optics.height, {8, 8192});
  v.number({"pixel", "Side of a pixel on the sample."}, optics.pixel, "mm", range::positive);
  v.number({"blur", "Standard deviation of the lens' blur, in pixels."}, optics.blur, "", range::between(0, 5));
  v.number({"vignetting", "Loss of light in the corners."}, optics.vignetting, "%", range::between(0, 0.9));
  v.number({"halo", "Fraction of the light that the lens scatters into a halo, in addition to its blur."}, optics.halo,
           "%", range::between(0, 0.9));
  v.number({"halo_width", "Standard deviation of the halo, a Gaussian, in pixels."}, optics.halo_width, "",
           range::between(1, 50));
  v.integer({"supersampling", "Points of the scene along a side of a pixel."}, optics.supersampling, {1, 32});
}

void declare(Visitor& v, Photograph& photograph) {
  v.number({"optical_pixel", "Side of a pixel on the sample in the picture of the ordinary camera."}, photograph.pixel,
           "mm", range::positive);
  v.number({"optical_blur", "Standard deviation of its lens' blur, in its pixels."}, photograph.blur, "",
           range::between(0, 5));
  v.number({"optical_right", "Shift of that picture to the right, relative to the film."}, photograph.shift.x, "mm",
           range::any);
  v.number({"optical_up", "Shift upwards."}, photograph.shift.y, "mm", range::any);
  v.number({"optical_rotation", "Rotation, counter-clockwise, rad."}, photograph.rotation, "",
           range::between(-3.2, 3.2));
  v.number({"optical_exposure", "Grey level of white in that picture, as a fraction of the range."},
           photograph.exposure, "%", range::above(0, 4));
  v.number({"optical_noise", "Standard deviation of its noise, as a fraction of the range."}, photograph.noise, "%",
           range::between(0, 0.5));
}

void declare(Visitor& v, Detector& detector) {
  static const std::string electrons = fmt::format("Electrons in a pixel at {} K; their square root is the shot noise.",
                                                   Detector::reference),
                           netd = fmt::format("Noise equivalent temperature difference at {} K.", Detector::reference);
  v.number({"electrons", electrons}, detector.electrons, "", range::positive);
  v.number({"full_well", "Electrons at the highest level."}, detector.full_well, "", range::positive);
  v.number({"netd", netd}, detector.netd, "mK", range::not_negative);
  v.integer({"bits", "Bits of a digital level."}, detector.bits, {4, 16});
  v.number({"gain_spread", "Standard deviation of the pixels' gain."}, detector.gain_spread, "%",
           range::between(0, 0.5));
  v.number({"offset_spread", "Standard deviation of the pixels' offset over the range."}, detector.offset_spread, "%",
           range::between(0, 0.5));
  v.number({"bad_share", "Fraction of pixels that are dead, hot or noisy."}, detector.bad_share, "%",
           range::between(0, 0.5));
  v.number({"noise_correlation", "Correlation of a pixel's noise between successive frames."},
           detector.noise_correlation, "", range::between(0, 0.95));
  v.number(
      {"common_noise", "Standard deviation of the noise common to all pixels of a frame, in addition to their own."},
      detector.common_noise, "mK", range::not_negative);
  v.number({"common_flicker",
            "Standard deviation of 1/f noise common to all pixels, from one cycle per film to the Nyquist frequency."},
           detector.common_flicker, "mK", range::not_negative);
  v.number({"column_flicker", "Standard deviation of 1/f noise common to the pixels of a column."},
           detector.column_flicker, "mK", range::not_negative);
  v.number({"jump", "Step of all levels at jump_time, as after a correction by the camera's shutter."}, detector.jump,
           "mK", range::any);
  v.number({"jump_pattern", "Standard deviation of the additional step of every pixel."}, detector.jump_pattern, "mK",
           range::not_negative);
  v.number({"jump_time", "Time of that step after the first frame."}, detector.jump_time, "s", range::not_negative);
}

void declare(Visitor& v, Interference& line) {
  v.number({"line_frequency", "Frequency of a spectral line of the electronics in the film."}, line.frequency, "Hz",
           range::not_negative);
  v.number({"line_amplitude", "Amplitude of the line; 0: none."}, line.amplitude, "mK", range::not_negative);
  v.number({"line_advance", "Phase advance of the line from row to row, in cycles."}, line.advance, "", range::any);
}

void declare(Visitor& v, Surroundings& around) {
  v.number({"temperature", "Temperature of the sample."}, around.temperature, "K", range::positive);
  v.number({"ambient", "Temperature of the surroundings that the sample reflects."}, around.ambient, "K",
           range::positive);
  v.number({"background_emissivity", "Emissivity of the background between the grains."}, around.background_emissivity,
           "", range::above(0, 1));
  v.number({"container_emissivity", "Emissivity of the container.", false, "frame_emissivity"},
           around.container_emissivity, "", range::above(0, 1));
  v.number({"drift", "Drift rate of the temperature of the whole scene."}, around.drift, "mK/s", range::any);
  v.number({"drift_growth", "Rate of change of the drift rate."}, around.drift_growth, "mK/s^2", range::any);
  v.number({"warm_up", "Amplitude of an additional exponential warm-up of the scene."}, around.warm_up, "K",
           range::any);
  v.number({"warm_up_time", "Time constant of the warm-up."}, around.warm_up_time, "s", range::positive);
  v.number({"drift_wave", "Amplitude of an additional slow sine of the scene's temperature."}, around.drift_wave, "K",
           range::any);
  v.number({"drift_period", "Period of that sine."}, around.drift_period, "s", range::positive);
  v.number(
      {"emissivity_scatter", "Standard deviation of the grains' emissivities, relative to that of their material."},
      around.emissivity_scatter, "%", range::between(0, 0.5));
  v.flag({"radiometry",
          "Planck's law, emissivities and reflected surroundings; false: levels are linear in temperature and all "
          "surfaces are black."},
         around.radiometry);
}

void declare(Visitor& v, Timing& timing) {
  v.integer({"frames", "Frames that the camera takes."}, timing.frames, {8, 100'000'000});
  v.number({"frame_rate", "Frames per second."}, timing.frame_rate, "Hz", range::positive);
  v.number({"integration", "Integration time of a frame."}, timing.integration, "us", range::not_negative);
  v.number({"load_frequency", "Nominal frequency of the load."}, timing.load_frequency, "Hz", range::positive);
  v.number({"frequency_error", "Relative excess of the true frequency over the nominal one."}, timing.frequency_error,
           "%", range::between(-0.5, 0.5));
  v.number({"second_harmonic", "Second harmonic of the load, over the first."}, timing.second_harmonic, "%",
           range::between(0, 1));
  v.number({"dropped", "Fraction of frames that are lost."}, timing.dropped, "%", range::between(0, 0.9));
  v.integer({"dropped_together", "Successive frames in each loss."}, timing.dropped_together, {1, 1'000'000});
  v.flag({"time_stamps", "Frames carry time stamps, which show losses; false: the film states its frame rate only."},
         timing.time_stamps);
}

}  // namespace

void Parameters::declare(Visitor& v) {
  camera::declare(v, optics);
  camera::declare(v, photograph);
  camera::declare(v, detector);
  camera::declare(v, interference);
  camera::declare(v, surroundings);
  camera::declare(v, timing);
  v.number({"band_low", "Shortest wavelength."}, band.low, "um", range::positive);
  v.number({"band_high", "Longest wavelength."}, band.high, "um", range::positive);
  v.require(band.high > band.low, {"band_high", "band_low"}, "must be above band_low");
  v.flag({"motion", "Grains move between their positions in the two states."}, motion);
  v.number({"contact_arc", "Half angle of the contact area on a grain, rad; 0: a point."}, contact_arc, "",
           range::between(0, 0.8));
}

double Surroundings::warmer(double time) const {
  const double curved = 0.5 * drift_growth * time * time - warm_up * std::expm1(-time / warm_up_time);
  return drift * time + curved +
         (drift_wave == 0 ? 0 : drift_wave * std::sin(2 * std::numbers::pi * time / drift_period));
}

}  // namespace arenite::camera
