#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace arenite {

/// How the size of an oscillation is given: the amplitude of its cosine, or twice that, from its smallest to its
/// largest value.
enum class AmplitudeConvention { amplitude, peak_to_peak };

/// "amplitude" or "peak_to_peak", as in files and JSON.
inline const char* name_of(AmplitudeConvention convention) {
  return convention == AmplitudeConvention::peak_to_peak ? "peak_to_peak" : "amplitude";
}
/// What makes a value of this convention peak to peak.
inline double to_peak_to_peak(AmplitudeConvention convention) {
  return convention == AmplitudeConvention::peak_to_peak ? 1 : 2;
}

/// A frame from which on pixels have another level, in the film's unit: by so much in all of them, and by so much
/// (standard deviation) from one to another.
struct LevelJump {
  std::size_t frame = 0;
  double common = 0, own = 0;
};

/// Changes of the level beside a film's load and the polynomial by which its pixels drift.
struct LevelChanges {
  std::vector<LevelJump> jumps;
  std::vector<double> course;  ///< that all pixels share, one value a frame; empty: none
  bool empty() const { return jumps.empty() && course.empty(); }
};

/// What a lock-in finds in every pixel of a film, in the film's unit (digital level or K), rows from the top. The
/// oscillation at the load frequency f is a_1 cos(2 pi f t - phase); `in_phase` is a_1 cos(phase - reference): signed,
/// positive where the pixel warms when the load rises.
struct LockinMaps {
  int width = 0, height = 0;
  double frequency = 0;             ///< refined, Hz
  double frequency_error = 0;       ///< standard error, Hz
  double reference_phase = 0;       ///< rad
  std::size_t frames = 0;           ///< used
  std::vector<std::int64_t> blank;  ///< frames of the film that hold no whole picture and were left out
  double noise_ratio =
      1;  ///< variance of the noise at the load's frequency over what the residual would be there if it were white
  /// How often noise alone has as much amplitude in one phase as the pixels have at this frequency; NaN: unknown.
  double chance = std::numeric_limits<double>::quiet_NaN();
  /// Share of the amplitude above the noise that has one phase, or its opposite, in all pixels; NaN: unknown.
  double one_phase = std::numeric_limits<double>::quiet_NaN();
  double other_frequency = 0;  ///< Hz, at which the film oscillates where the load's frequency shows nothing; 0: none
  int drift_order = 0, harmonics = 1;  ///< that were fitted
  double own_share = 1;  ///< of the variance of a pixel's noise at the load's frequency, that no other pixel shares
  double common_error = 0,
         column_error = 0;  ///< standard errors of in_phase that all pixels share, and those of a column
  std::vector<double> shared_cosine,
      shared_sine;              ///< of what was taken off every pixel of a column; empty: nothing was
  std::size_t lost_frames = 0;  ///< that no time stamp shows, but the phase of the load does
  std::vector<double> time;     ///< of all frames where some were lost so, s after the first; else as the film says
  LevelChanges levels;          ///< that were fitted to every pixel beside its drift; of the frames used
  std::vector<std::string> disturbances;  ///< what the film shows beside the load and its drift, each a sentence
  AmplitudeConvention convention = AmplitudeConvention::amplitude;  ///< of every amplitude below
  std::vector<float> mean;                                          ///< at the middle of the film
  std::vector<float> drift;                                         ///< slope of the mean, unit/s
  std::vector<float> amplitude, phase;                              ///< -, rad
  std::vector<float> in_phase, quadrature;
  std::vector<float> standard_error;   ///< of in_phase, from the residual, the noise's ratio and the normal matrix
  std::vector<float> noise_floor;      ///< amplitude that noise alone shows on the mean, sqrt(pi/2) standard errors
  std::vector<float> second_harmonic;  ///< amplitude at 2 f; empty where it was not fitted
  std::vector<float> residual;         ///< root mean square of what the fit leaves (noise, slip, plasticity)

  std::size_t size() const { return mean.size(); }
};

/// A map by its name in files and Python, with its unit for a film in kelvin.
struct LockinMap {
  const char *name, *unit;
  std::vector<float> LockinMaps::*values;
};
inline constexpr std::array lockin_maps{LockinMap{"mean", "K", &LockinMaps::mean},
                                        LockinMap{"drift", "K/s", &LockinMaps::drift},
                                        LockinMap{"amplitude", "K", &LockinMaps::amplitude},
                                        LockinMap{"phase", "rad", &LockinMaps::phase},
                                        LockinMap{"in_phase", "K", &LockinMaps::in_phase},
                                        LockinMap{"quadrature", "K", &LockinMaps::quadrature},
                                        LockinMap{"standard_error", "K", &LockinMaps::standard_error},
                                        LockinMap{"noise_floor", "K", &LockinMaps::noise_floor},
                                        LockinMap{"second_harmonic", "K", &LockinMaps::second_harmonic},
                                        LockinMap{"residual", "K", &LockinMaps::residual}};

}  // namespace arenite
