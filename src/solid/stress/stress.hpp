#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/vec.hpp"
#include "model/phase_map.hpp"
#include "solid/stress/options.hpp"
#include "statistics/estimate.hpp"
#include "statistics/histogram.hpp"
#include "statistics/numbers.hpp"
#include "statistics/tails.hpp"

/// Statistics of node stresses by phase (P IV). Fits, errors and their types are those that grains and contacts use (src/statistics).
namespace arenite::stress {

using statistics::ByName;
using statistics::Curve;
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

/// Mean stress tensors of the grains of a map, and means by class with errors over blocks x blocks of the map. Without a field (of
/// size 0) nodes and centres alone are known.
GrainStresses measure_grains(const PhaseMap& map, const StressField& field, int clamp_rows, int blocks);

/// How two stresses of the same grains agree, each over the mean of its own set: slope and rms of
/// (field over its mean) against (contacts over their mean).
struct Agreement {
  std::size_t grains = 0;
  Estimate correlation;  ///< Pearson's; error by leaving out one grain at a time
  Estimate slope;
  double rms = unknown;  ///< of the difference
};

struct GrainComparison {
  ByName<Agreement> yy, hydrostatic;  ///< "all", "large", "small"
};

/// Compares the mean stresses of whole grains with stresses of the same grains from contact forces (one tensor a grain of the map, any unit;
/// texture's per_grain.sigma). Grains without contact stress (zero or NaN) are left out. Throws InputError where the numbers of grains differ.
GrainComparison compare(const PhaseMap& map, const GrainStresses& grains, const std::vector<Tensor2>& contact_stress);

/// One component in one set of nodes. x is the stress over the sample's mean, or over the set's own.
struct Distribution {
  std::size_t count = 0;   ///< nodes
  Estimate mean;           ///< Pa
  Estimate relative_mean;  ///< over the sample's
  Estimate variance;       ///< of the stress over the sample's mean
  Estimate own_variance;   ///< of the stress over the set's own mean
  Estimate skewness, excess_kurtosis;
  Estimate fraction_above_mean;                 ///< share of nodes above the set's own mean
  Estimate fraction_above_mean_of_all;          ///< above the sample's
  ByName<Estimate> quantiles;                   ///< over the sample's mean; "0.01 %" to "99.99 %"
  double minimum = unknown, maximum = unknown;  ///< over the sample's mean
  statistics::TailFit tail;                     ///< of the stress over the set's own mean (P IV.B, Fig. 14d)
  statistics::QGaussian q_gaussian;             ///< of the stress over the set's own mean (P IV.A)
  statistics::Peak peak;                        ///< of the pdf of the stress over the set's own mean
  statistics::Histogram histogram;              ///< of the stress over the sample's mean, in bins that all samples share
  statistics::Histogram own_histogram;          ///< of the stress over the set's own mean
  Curve pdf;                                    ///< of the stress over the sample's mean (P Figs. 9 and 13)
  Curve own_pdf;                                ///< of the stress over the set's own mean (P Fig. 14)
};

/// One component in every set. Names: "all" (particles and matrix), "particle", "large", "small" (where the map has
/// classes), "matrix"; sets without nodes are left out.
struct ComponentStatistics {
  Component component = Component::yy;
  bool over_mean = true;                     ///< false: the sample's mean is near zero (below a tenth of the root mean square);
                                             ///< the root mean square stands in for it, and nothing is given over own means
  Estimate sample_mean;                      ///< Pa; the one of the two below that stresses are divided by
  Estimate mean_over_nodes, mean_over_area;  ///< Pa; of particles and matrix, and with the void as zero
  ByName<Distribution> sets;
};

struct NodeCounts {
  std::size_t nodes = 0;                           ///< considered: particle or matrix
  std::size_t clamp_nodes = 0, surface_nodes = 0;  ///< left out as clamp rows, as outermost ones
  std::size_t unloaded_nodes = 0;                  ///< particle or matrix without any stress beyond the clamp rows
};

struct Statistics : NodeCounts {
  StressOptions options;
  std::vector<ComponentStatistics> components;
  GrainStresses grains;
  std::vector<std::string> notes;  ///< what could not be computed, and why
};

/// Measures everything. Throws InputError where map and field have other sizes, no node is left, a stress is not a
/// number, a component is zero everywhere, or an option makes no sense.
Statistics measure(const PhaseMap& map, const StressField& field, const StressOptions& options = {});

/// The statistics as JSON, each as {"value", "error"}; unknown ones are left out. `curves` adds pdfs and the rows by grain.
Numbers numbers(const Statistics& statistics, bool curves = false);

/// The main statistics as a table: name, value +- error, unit, meaning.
std::string to_text(const Statistics& statistics);

}  // namespace arenite::stress
