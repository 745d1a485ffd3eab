#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/phase_map.hpp"
#include "statistics/estimate.hpp"
#include "statistics/numbers.hpp"

namespace arenite::grid {

/// Pores are connected sets of nodes that are not grain, voids of nodes that are neither grain nor matrix (P III).
enum class Cavity { pore, void_ };

/// Rules of the flood fill; results are reported with them.
struct CavityRules {
  bool eight_connected = false;  ///< otherwise the four nearest nodes are neighbours
  int fewest_nodes = 5;          ///< smaller ones are specks of the grid and left out
  bool leave_out_border = true;  ///< those that touch the edge of the map are cut
  bool operator==(const CavityRules&) const = default;
};

struct Cavities {
  CavityRules rules;
  std::vector<std::int32_t> label;  ///< one a node: index of its cavity, -1 outside or left out
  std::vector<std::int64_t> nodes;  ///< one a cavity that counts, in order of their first node
  std::size_t specks = 0, cut = 0;  ///< left out as too small, as touching the border (whatever their size)
};

/// Throws InputError for a negative least size.
Cavities find_cavities(const PhaseMap& map, Cavity kind, const CavityRules& rules = {});

/// What runs through a map from side to side. Solid is grain and matrix together. Where voids are 4-connected solid is
/// 8-connected and the other way round, so that just one of a void from left to right and a solid from bottom to top
/// is there. Bonds of the solver reach further than neighbours: a solid that does not connect may still carry a little.
struct Percolation {
  bool solid_bottom_top = false, solid_left_right = false;
  bool void_bottom_top = false, void_left_right = false;
};

Percolation find_percolation(const PhaseMap& map, bool eight_connected_voids = false);

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
  /// S_m = rho_m/(1 - rho_p) (P III); 0 where all is grain.
  double saturation = 0;
};

PhaseFractions phase_fractions(const PhaseMap& map);

/// Where the probability density of positive volumes is highest, in their unit: the density of their logarithms under a
/// Gaussian kernel of Silverman's width, over the volume. NaN for fewer than two different volumes.
double density_peak(const std::vector<double>& volumes);

/// Size, phases, S_m, grains, pores and voids of any map. Volumes of pores and voids are over pi reference_radius^2.
Numbers map_numbers(const PhaseMap& map, const CavityRules& rules, double reference_radius);

}  // namespace arenite::grid
