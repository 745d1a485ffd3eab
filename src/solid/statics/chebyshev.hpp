#pragma once
#include <vector>

namespace arenite::statics {

/// A step of the smoother: x + keep (x - older) + add D^-1 r.
struct ChebyshevStep {
  float keep, add;
};

/// The steps that damp the part of a spectrum between two eigenvalues.
inline std::vector<ChebyshevStep> chebyshev_steps(int degree, double lowest, double highest) {
  const double centre = (highest + lowest) / 2, half = (highest - lowest) / 2;
  double rho = half / centre;
  std::vector<ChebyshevStep> steps{{0, static_cast<float>(1 / centre)}};
  for (int k = 1; k < degree; ++k) {
    const double next = 1 / (2 * centre / half - rho);
    steps.push_back({static_cast<float>(next * rho), static_cast<float>(2 * next / half)});
    rho = next;
  }
  return steps;
}

}  // namespace arenite::statics
