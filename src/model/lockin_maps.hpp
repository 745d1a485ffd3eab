#pragma once
#include <cstddef>
#include <vector>

namespace arenite {

/// How the size of a swing is told: half of it (the amplitude of its cosine) or all of it (from smallest to largest).
enum class SwingConvention { half, full };

/// What a lock-in finds in every pixel of a film, in the film's unit (digital level or K), rows from the top. A swing
/// at the load frequency f is a_1 cos(2 pi f t - phase); `in_phase` is a_1 cos(phase - reference): signed, positive where
/// the pixel warms when the load rises.
struct LockinMaps {
  int width = 0, height = 0;
  double frequency = 0;             ///< refined, Hz
  double frequency_error = 0;       ///< standard error, Hz
  double reference_phase = 0;       ///< rad
  std::size_t frames = 0;           ///< used
  double noise_ratio = 1;           ///< variance of the noise at the load's frequency over what the residual would be there if it were white
  double chance = 0;                ///< how often noise alone swings as much in one phase as the pixels do at this frequency
  double one_phase = 1;             ///< share of the swing above the noise that has one phase, or its opposite, in all pixels
  double swings_at = 0;             ///< Hz, elsewhere, where the load's frequency shows nothing; 0: nowhere
  int drift_order = 0, harmonics = 1;  ///< that were fitted
  SwingConvention convention = SwingConvention::half;  ///< of every amplitude below
  std::vector<float> mean;          ///< at the middle of the film
  std::vector<float> drift;         ///< slope of the mean, unit/s
  std::vector<float> amplitude, phase;  ///< -, rad
  std::vector<float> in_phase, quadrature;
  std::vector<float> standard_error;    ///< of in_phase, from the residual, the noise's ratio and the normal matrix
  std::vector<float> noise_floor;       ///< amplitude that noise alone shows on the mean, sqrt(pi/2) standard errors
  std::vector<float> second_harmonic;   ///< amplitude at 2 f; empty where it was not fitted
  std::vector<float> residual;      ///< root mean square of what the fit leaves (noise, slip, plasticity)

  std::size_t size() const { return mean.size(); }
};

}  // namespace arenite
