#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "model/kinds.hpp"
#include "model/phase_map.hpp"
#include "solid/grid/cavities.hpp"
#include "statistics/estimate.hpp"

namespace arenite::grid {

/// Probability density of the volumes; integrates to 1 over the bins, at most 30 of like width in the logarithm. Edges
/// lie half-way between whole numbers of nodes, so that narrow bins merge.
struct VolumeDensity {
  std::vector<double> edge;  ///< one more than bins, rising
  std::vector<std::size_t> count;
  std::vector<double> density, error;  ///< standard error by counting: sqrt(k (1 - k/n))/(n width)
};

/// Volumes of single cavities over pi rbar_L^2 (P III, Figs. 6-8).
struct CavityStatistics {
  CavityRules rules;
  std::size_t count = 0, specks = 0, cut = 0;
  /// Errors from the moments of the sample; those of deviation (with n - 1) and cv hold for many cavities. 0 where
  /// fewer than two cavities count.
  statistics::Estimate mean{0, 0}, deviation{0, 0}, cv{0, 0};
  double peak = 0;               ///< where the density is highest (density_peak)
  double tenth = 0, median = 0;  ///< volumes that a tenth and half of the cavities stay below
  VolumeDensity density;
};

/// `nodes` a cavity, of dx by dx, over pi large_radius^2. Throws InputError for a radius or spacing that is not
/// positive.
CavityStatistics cavity_statistics(const Cavities& cavities, double dx, double large_radius);

/// Shares of the nodes of a map (P II.A), by counting.
struct PhaseFractions {
  double particle = 0, matrix = 0, empty = 0;  ///< rho_p, rho_m, rho_v
  double large = 0, small = 0;                 ///< rho_L, rho_S: the particle nodes of classed grains
  double unclassed = 0;                        ///< the particle nodes of other grains
  /// S_m = rho_m/(1 - rho_p) (P III); 0 where all is grain.
  double saturation = 0;
};

PhaseFractions phase_fractions(const PhaseMap& map);

/// The same by NodeKind.
std::array<double, node_kinds.size()> fractions_by_kind(const PhaseMap& map);

/// Where the probability density of positive volumes is highest, in their unit: the density of their logarithms under a
/// Gaussian kernel of Silverman's width, over the volume. NaN for fewer than two different volumes.
double density_peak(const std::vector<double>& volumes);

}  // namespace arenite::grid
