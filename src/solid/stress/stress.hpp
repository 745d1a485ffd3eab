#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/vec.hpp"
#include "model/phase_map.hpp"
#include "solid/stress/options.hpp"
#include "statistics/estimate.hpp"
#include "statistics/numbers.hpp"

/// Statistics of node stresses by phase (P IV). Fits, errors and their types are those that grains and contacts use
/// (src/statistics).
namespace arenite::stress {

using statistics::ByName;
using statistics::Estimate;
using statistics::TensorEstimate;
using statistics::unknown;

/// Mean stress of every grain over its nodes, Pa, tension positive; arrays as long as PhaseMap::grain_class.
struct GrainStresses {
  std::vector<std::int64_t> nodes;  ///< in the map, surface nodes included; 0: the grain has none
  std::vector<std::uint8_t> whole;  ///< 1 where no node lies on the map's edge or in a clamp row
  std::vector<Vec2> centre;         ///< of its nodes, m from the map's lower left corner
  std::vector<Tensor2> stress;      ///< zero without nodes
  ByName<TensorEstimate> mean;      ///< of whole grains, each grain alike: "all", "large", "small"
};

/// Mean stress tensors of the grains of a map, and means by class with errors over blocks x blocks of the map. Without
/// a field (of size 0) nodes and centres alone are known.
GrainStresses measure_grains(const PhaseMap& map, const StressField& field, int clamp_rows, int blocks);

/// How many are whole, the means, and the rows by grain.
Numbers numbers(const GrainStresses& grains);

/// How the mean stresses of whole grains agree with those of the same grains from contact forces (one tensor a grain of
/// the map, any unit, such as texture's per_grain.sigma): of "sigma_yy" and "sigma_hyd", and of "all", "large" and
/// "small" grains, Pearson's correlation, and slope and root mean square difference of (field over its mean) against
/// (contacts over their mean). Grains without contact stress (zero or NaN) are left out. Throws InputError where the
/// numbers of grains differ.
Numbers compare(const PhaseMap& map, const GrainStresses& grains, const std::vector<Tensor2>& contact_stress);

/// Names of sets: "all" (particles and matrix), "particle", "large", "small" (where the map has classes), "matrix";
/// sets without nodes are left out.
struct Statistics {
  Numbers numbers;  ///< of nodes, components and grains, curves among them
  GrainStresses grains;
  std::vector<std::pair<Component, std::string>> notes;  ///< what could not be computed, and why
};

/// Throws InputError where so many rows at each clamp leave no row of the map.
void check_clamp_rows(const PhaseMap& map, int rows);

/// Measures everything. Throws InputError where map and field have other sizes, no node is left, a stress is not a
/// number, all components are zero everywhere, or an option makes no sense.
Statistics measure(const PhaseMap& map, const StressField& field, const StressOptions& options = {});

/// The statistics, each as {"value", "error"}; unknown ones are left out. `curves` adds pdfs and the rows by grain. Of
/// the components that were measured these alone are there.
Numbers numbers(const Statistics& statistics, bool curves = false,
                std::span<const Component> components = all_components);

/// The main statistics as a table: name, value +- error, unit, meaning.
std::string to_text(const Statistics& statistics);

}  // namespace arenite::stress
