#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/phase_map.hpp"
#include "model/stress_field.hpp"
#include "statistics/estimate.hpp"
#include "statistics/even_density.hpp"
#include "statistics/numbers.hpp"
#include "statistics/q_gaussian.hpp"
#include "statistics/tail_fit.hpp"
#include "solid/stress/grains.hpp"

/// Statistics of node stresses by phase (P IV). Fits, errors and their types are those that grains and
/// contacts use (src/statistics).
namespace arenite::stress {

/// What of a node's stress is looked at; hydrostatic is (xx + yy)/2.
enum class Component { yy, xx, xy, hydrostatic };

/// "sigma_yy", "sigma_xx", "sigma_xy", "sigma_hyd".
const char* name_of(Component component);

/// Choices that the definitions leave open.
struct StressOptions {
  std::vector<Component> components{Component::yy};
  int clamp_rows = 4;                ///< left out at the lower and the upper edge
  bool leave_out_surface = false;    ///< nodes with a neighbour (of eight) of another phase or grain
  bool leave_out_unloaded = false;   ///< nodes without any stress: parts that no bond ties to a clamp
  bool mean_over_area = false;       ///< the sample's mean counts the void as zero stress: the mean over the whole area;
                                     ///< otherwise over particles and matrix, so that a mean over classes is 1
  int blocks = 6;                    ///< a side, for errors by leaving one block out
  bool operator==(const StressOptions&) const = default;
};

/// One component in one set of nodes. x is the stress over the sample's mean, or over the set's own.
struct Distribution {
  std::size_t count = 0;             ///< nodes
  Estimate mean;                     ///< Pa
  Estimate relative_mean;            ///< over the sample's
  Estimate variance;                 ///< of the stress over the sample's mean
  Estimate own_variance;             ///< of the stress over the set's own mean
  Estimate skewness, excess_kurtosis;
  Estimate share_above;              ///< share of nodes above the set's own mean
  Estimate share_above_all;          ///< above the sample's
  ByName<Estimate> quantiles;        ///< over the sample's mean; "0.01 %" to "99.99 %"
  double minimum = unknown, maximum = unknown;  ///< over the sample's mean
  statistics::TailFit tail;          ///< of the stress over the set's own mean (P IV.B, Fig. 14d)
  statistics::QGaussian q_gaussian;  ///< of the stress over the set's own mean (P IV.A)
  statistics::Peak peak;             ///< of the pdf of the stress over the set's own mean
  statistics::EvenDensity even_pdf;      ///< of the stress over the sample's mean, in bins that all samples share
  statistics::EvenDensity own_even_pdf;  ///< of the stress over the set's own mean
  Curve pdf;                         ///< of the stress over the sample's mean (P Figs. 9 and 13)
  Curve own_pdf;                     ///< of the stress over the set's own mean (P Fig. 14)
};

/// One component in every set. Names: "all" (particles and matrix), "particle", "large", "small" (where the map has
/// classes), "matrix"; sets without nodes are left out.
struct ComponentStatistics {
  Component component = Component::yy;
  bool over_mean = true;             ///< false: the sample's mean is near zero (below a tenth of the root mean square);
                                     ///< the root mean square stands in for it, and nothing is given over own means
  Estimate sample_mean;              ///< Pa; the one of the two below that stresses are divided by
  Estimate mean_over_nodes, mean_over_area;  ///< Pa; of particles and matrix, and with the void as zero
  ByName<Distribution> sets;
};

struct Statistics {
  StressOptions options;
  std::size_t nodes = 0;             ///< considered: particle or matrix
  std::size_t clamp_nodes = 0, surface_nodes = 0;  ///< left out as clamp rows, as outermost ones
  std::size_t unloaded_nodes = 0;    ///< particle or matrix without any stress beyond the clamp rows
  std::vector<ComponentStatistics> components;
  GrainStresses grains;
  std::vector<std::string> notes;    ///< what could not be computed, and why
};

/// Measures everything. Throws InputError where map and field have other sizes, no node is left, a stress is not a
/// number, a component is zero everywhere, or an option makes no sense.
Statistics measure(const PhaseMap& map, const StressField& field, const StressOptions& options = {});

/// The statistics as JSON, each as {"value", "error"}; unknown ones are left out. `curves` adds pdfs and the rows by
/// grain.
Numbers numbers(const Statistics& statistics, bool curves = false);

/// The main statistics as lines of text, value +- error.
std::string to_text(const Statistics& statistics);

}  // namespace arenite::stress
