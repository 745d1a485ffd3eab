#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "core/parameters.hpp"
#include "core/vec.hpp"
#include "thermal/radiometry/band.hpp"

namespace arenite::camera {

constexpr double most_points =
    1e8;  ///< of a scene or a picture: minutes of work, and less memory than a laboratory's machine has

/// Lens and pixels. The defaults are those of T Table 1.2 and T 3.2.
struct Optics {
  std::int64_t width = 320, height = 240;  ///< pixels
  double pixel = 1.6e-3;                   ///< side of a pixel on the sample, m
  double blur = 0.5;                       ///< standard deviation of the lens' Gaussian blur, pixels
  double vignetting = 0;                   ///< loss of light in the corners over that in the middle
  double halo = 0;                         ///< share of the light that the lens scatters round its place
  double halo_width = 4;                   ///< standard deviation of that, Gaussian too, pixels
  std::int64_t supersampling = 6;          ///< points of the scene along a side of a pixel
};

/// From light to digital levels.
struct Detector {
  static constexpr double reference = 296;  ///< temperature of the black body whose light is the unit, K
  double electrons = 6e6;                   ///< in a pixel at `reference`; their square root is the shot noise
  double full_well = 1.2e7;                 ///< electrons at the highest level
  double netd = 0.020;  ///< noise equivalent temperature difference at `reference`, shot noise included, K
  std::int64_t bits = 14;
  double gain_spread = 0.02;     ///< standard deviation of the pixels' gain
  double offset_spread = 0.03;   ///< of their offset, share of the range
  double bad_share = 0.003;      ///< pixels that are dead, hot or noisy
  double noise_correlation = 0;  ///< of a pixel's noise in one frame with that in the next: first-order autoregressive
  double common_noise = 0;       ///< standard deviation of what all pixels of a frame share, as correlated, K
  double common_flicker = 0;     ///< of 1/f noise that all pixels share, from once in the film up, K
  double column_flicker = 0;     ///< of such noise that the pixels of a column share, K
  double jump = 0;               ///< by which all levels rise at `jump_time`, as after a shutter's correction, K
  double jump_pattern = 0;       ///< standard deviation of what every pixel rises by beside, K
  double jump_time = 0;          ///< s after the first frame
};

/// A line of the electronics in the film.
struct Interference {
  double frequency = 0;  ///< Hz
  double amplitude = 0;  ///< K
  double advance = 0.2;  ///< by which its phase goes on from row to row as they are read out, cycles
};

/// An ordinary camera beside the infrared one, with a place of its own.
struct Photograph {
  double pixel = 0.4e-3;      ///< side of a pixel on the sample, m
  double blur = 0.5;          ///< of its lens, pixels
  Vec2 shift{2e-3, -1.2e-3};  ///< of the sample in the picture against the film, m
  double rotation = 0.009;    ///< of the sample in the picture, counterclockwise, rad
  double exposure = 0.9;      ///< level of what is white, share of the range
  double noise = 0.01;        ///< standard deviation, share of the range
};

/// What the camera looks at, beside the stresses.
struct Surroundings {
  double temperature = 296;             ///< of the sample at rest, K
  double ambient = 291;                 ///< mirrored by what is not black, K
  double background_emissivity = 0.55;  ///< of what is seen between the grains
  double container_emissivity = 0.3;    ///< of the container round the sample
  std::vector<double> emissivity;       ///< one a material; the usual one where there is none
  double drift = 0.010;                 ///< K/s, of the whole scene
  double drift_growth = 0;              ///< K/s^2, of that rate
  double warm_up = 0;                   ///< K by which the scene warms beside, exponentially
  double warm_up_time = 10;             ///< s after which 1/e of that is left to come
  double drift_wave = 0;                ///< K, amplitude of a slow sine, as of a room whose heating goes on and off
  double drift_period = 30;             ///< s, of that sine
  double emissivity_scatter = 0;        ///< standard deviation of grains' emissivities about their material's, over it
  /// By how much the scene is warmer at a time than at the film's begin, K.
  double warmer(double time) const;
  bool radiometry = true;  ///< false: the level is linear in temperature and everything is black
};

/// When frames are taken, and how the load goes from its smallest to its largest value: s(t) = (1 - cos w t)/2 +
/// second_harmonic (1 - cos 2 w t)/2.
struct Timing {
  std::int64_t frames = 8880;
  double frame_rate = 148;        ///< Hz
  double integration = 1.5e-3;    ///< s; amplitudes are less by sinc(pi f integration)
  double load_frequency = 3;      ///< as given to the laboratory, Hz
  double frequency_error = 1e-3;  ///< the true one is larger by this share
  double second_harmonic = 0.02;
  double dropped = 0.001;             ///< share of frames that are missing; the time stamps show it
  std::int64_t dropped_together = 1;  ///< one after the other
  bool time_stamps = true;            ///< false: the film does not say when its frames were taken
};

struct Parameters {
  Optics optics;
  Photograph photograph;
  Detector detector;
  Interference interference;
  Surroundings surroundings;
  Timing timing;
  radiometry::Band band;
  bool motion = true;      ///< grains move between their places in the two states
  double contact_arc = 0;  ///< half angle over which a contact presses, rad; 0: a point
  void declare(ParameterVisitor& visitor);
};

}  // namespace arenite::camera
