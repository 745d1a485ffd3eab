#include "recipe/film_recipe_keys.hpp"

namespace arenite::study {
namespace {

using Visitor = ParameterVisitor;

void declare(Visitor& v, camera::Optics& optics) {
  v.integer({"width", "Pixels in a row."}, optics.width, {8, 8192});
  v.integer({"height", "Rows."}, optics.height, {8, 8192});
  v.number({"pixel", "Side of a pixel on the sample."}, optics.pixel, "mm", range::positive);
  v.number({"blur", "Standard deviation of the lens' blur, in pixels."}, optics.blur, "", range::between(0, 5));
  v.number({"vignetting", "Loss of light in the corners."}, optics.vignetting, "%", range::between(0, 0.9));
  v.integer({"supersampling", "Points of the scene along a side of a pixel."}, optics.supersampling, {1, 32});
}

void declare(Visitor& v, camera::Photograph& photograph) {
  v.number({"optical_pixel", "Side of an ordinary camera's pixel on the sample, in the picture that is taken beside the film."}, photograph.pixel, "mm",
           range::positive);
  v.number({"optical_blur", "Standard deviation of its lens' blur, in its pixels."}, photograph.blur, "", range::between(0, 5));
  v.number({"optical_right", "How far to the right the sample is seen in the picture, against the film."}, photograph.shift.x, "mm", range::any);
  v.number({"optical_up", "How far up."}, photograph.shift.y, "mm", range::any);
  v.number({"optical_rotation", "How far it is turned counterclockwise, rad."}, photograph.rotation, "", range::between(-3.2, 3.2));
  v.number({"optical_exposure", "Level of what is white in it, share of the range."}, photograph.exposure, "%", range::above(0, 4));
  v.number({"optical_noise", "Standard deviation of its noise, share of the range."}, photograph.noise, "%", range::between(0, 0.5));
}

void declare(Visitor& v, camera::Detector& detector) {
  v.number({"electrons", "In a pixel at 296 K; their square root is the shot noise."}, detector.electrons, "", range::positive);
  v.number({"full_well", "Electrons at the highest level."}, detector.full_well, "", range::positive);
  v.number({"netd", "Noise equivalent temperature difference at 296 K."}, detector.netd, "mK", range::not_negative);
  v.integer({"bits", "Of a digital level."}, detector.bits, {4, 16});
  v.number({"gain_spread", "Standard deviation of the pixels' gain."}, detector.gain_spread, "%", range::between(0, 0.5));
  v.number({"offset_spread", "Standard deviation of their offset over the range."}, detector.offset_spread, "%", range::between(0, 0.5));
  v.number({"bad_share", "Share of pixels that are dead, hot or noisy."}, detector.bad_share, "%", range::between(0, 0.5));
  v.number({"noise_correlation", "Of a pixel's noise in one frame with that in the next."}, detector.noise_correlation, "", range::between(0, 0.95));
  v.number({"common_noise", "Standard deviation of what all pixels of a frame share beside their own noise."}, detector.common_noise, "mK", range::not_negative);
}

void declare(Visitor& v, camera::Interference& line) {
  v.number({"line_frequency", "Of a line of the electronics in the film."}, line.frequency, "Hz", range::not_negative);
  v.number({"line_amplitude", "Half of its swing; 0: there is none."}, line.amplitude, "mK", range::not_negative);
  v.number({"line_advance", "Cycles by which its phase goes on from row to row."}, line.advance, "", range::any);
}

void declare(Visitor& v, camera::Surroundings& around) {
  v.number({"temperature", "Of the sample."}, around.temperature, "K", range::positive);
  v.number({"ambient", "Of the surroundings that the sample mirrors."}, around.ambient, "K", range::positive);
  v.number({"background_emissivity", "Of what is seen between the grains."}, around.background_emissivity, "", range::above(0, 1));
  v.number({"frame_emissivity", "Of the frame."}, around.frame_emissivity, "", range::above(0, 1));
  v.number({"drift", "Warming of the whole scene."}, around.drift, "mK/s", range::any);
  v.number({"drift_growth", "By which this rate grows."}, around.drift_growth, "mK/s^2", range::any);
  v.number({"warm_up", "By how much the scene warms beside, exponentially."}, around.warm_up, "K", range::any);
  v.number({"warm_up_time", "After which 1/e of that is left to come."}, around.warm_up_time, "s", range::positive);
  v.flag({"radiometry", "Planck's law, emissivities and mirrored surroundings; false: levels are linear in temperature and all is black."},
         around.radiometry);
}

void declare(Visitor& v, camera::Timing& timing) {
  v.integer({"frames", "Frames that the camera takes."}, timing.frames, {8, 100'000'000});
  v.number({"frame_rate", "Frames in a second."}, timing.frame_rate, "Hz", range::positive);
  v.number({"integration", "Time over which a frame gathers light."}, timing.integration, "us", range::not_negative);
  v.number({"load_frequency", "Of the load, as it is told."}, timing.load_frequency, "Hz", range::positive);
  v.number({"frequency_error", "The true frequency is larger by this share."}, timing.frequency_error, "%", range::between(-0.5, 0.5));
  v.number({"second_harmonic", "Of the load, over the first."}, timing.second_harmonic, "%", range::between(0, 1));
  v.number({"dropped", "Share of frames that are lost."}, timing.dropped, "%", range::between(0, 0.9));
}

}  // namespace

void declare(ParameterVisitor& v, CameraSection& camera) {
  v.text({"low", "Stage at whose end the load is smallest; without it the swing is from no load."}, camera.low);
  v.text({"high", "Stage at whose end the load is largest, or a load of the cemented sample.", true}, camera.high);
  declare(v, camera.parameters.optics);
  declare(v, camera.parameters.photograph);
  declare(v, camera.parameters.detector);
  declare(v, camera.parameters.interference);
  declare(v, camera.parameters.surroundings);
  declare(v, camera.parameters.timing);
  v.number({"band_low", "Shortest wavelength."}, camera.parameters.band.low, "um", range::positive);
  v.number({"band_high", "Longest wavelength."}, camera.parameters.band.high, "um", range::positive);
  v.require(camera.parameters.band.high > camera.parameters.band.low, {"band_high", "band_low"}, "must be above band_low");
  v.flag({"motion", "Grains move between their places in the two states."}, camera.parameters.motion);
  v.number({"contact_arc", "Half angle over which a contact presses on a grain, rad; 0: a point."}, camera.parameters.contact_arc, "", range::between(0, 0.8));
  v.integer({"plate_frames", "Frames in each of the two films of an even plate."}, camera.plate_frames, {1, 1'000'000});
  v.number({"plate_cold", "Temperature of the first plate."}, camera.plate_cold, "K", range::positive);
  v.number({"plate_warm", "Temperature of the second plate."}, camera.plate_warm, "K", range::positive);
  v.require(camera.plate_warm > camera.plate_cold, {"plate_warm", "plate_cold"}, "must be above plate_cold");
}

}  // namespace arenite::study
