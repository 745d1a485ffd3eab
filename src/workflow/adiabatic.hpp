#pragma once
#include <string>

namespace arenite::study {

/// Whether heat stays where it came to be within a cycle of the load.
struct Adiabatic {
  double length = 0, pixel = 0;     ///< that heat diffuses, and the side of a pixel, m; no pixel: unknown

  /// `diffusivity` of heat in the grains, m^2/s; `frequency` of the load, Hz.
  Adiabatic(double diffusivity, double frequency, double side = 0);
  double lost() const;              ///< share of the finest detail's swing
  /// At a fifth of a pixel the finest detail loses 2 % of its swing and lags by 11 degrees.
  bool holds() const { return length <= pixel / 5; }
  std::string sentence() const;     ///< what to say where it does not hold
};

}  // namespace arenite::study
