#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "model/phase_map.hpp"
#include "solid/stress/grains.hpp"
#include "solid/stress/options.hpp"
#include "statistics/estimate.hpp"
#include "statistics/numbers.hpp"
#include "statistics/numbers_text.hpp"

/// Statistics of node stresses by phase (P IV). Fits, errors and their types are those that grains and contacts use
/// (src/statistics).
namespace arenite::stress {

using statistics::ByName;
using statistics::Estimate;
using statistics::TensorEstimate;
using statistics::unknown;

/// "sigma_yy", "sigma_xx", "sigma_xy", "sigma_hyd".
const char* name_of(Component component);

/// Names of sets: "all" (particles and matrix), "particle", "large", "small" (where the map has classes), "matrix";
/// sets without nodes are left out.
struct Statistics {
  Numbers numbers;  ///< of nodes, components and grains, curves among them
  GrainStresses grains;
  std::vector<std::pair<Component, std::string>> notes;  ///< what could not be computed, and why
};

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
