#pragma once
#include <string>
#include <vector>

#include "statistics/numbers.hpp"

namespace arenite::statistics {

/// Mean over runs: y with the standard error over the runs that have it, of which there are `samples`.
struct SampleMean : Curve {
  std::size_t samples = 0;
};

/// Deviation of single samples that the standard error of the mean of so many tells.
double deviation_of_samples(double standard_error, std::size_t samples);

/// What a mean of lists is of sectors of directions.
struct Sectors {
  std::size_t count = 0;  ///< other ones are shared out into so many, as if they were even within; 0: as they are
  bool shares = true;     ///< over the mean of the whole list, or the numbers themselves
};

/// Mean over runs of a density in their numbers, at the dotted `path`: {"low", "width", "density"} or {"x", "y"} with
/// the middles of bins, which all runs share, or {"edge", "density"} with bins of their own, which is then given in 40
/// bins of like width in the logarithm. Empty if no run has it.
SampleMean mean_density(const std::vector<Numbers>& runs, const std::string& path);

/// The same for the survival function, the share above x, of densities in bins of one width from 0 or elsewhere, at
/// their lower edges.
SampleMean mean_survival(const std::vector<Numbers>& runs, const std::string& path);

/// Mean over runs of the list at `path`, against that at `path_x`, or if this is empty against the middles of sectors
/// of half a turn, degrees.
SampleMean mean_list(const std::vector<Numbers>& runs, const std::string& path_x, const std::string& path,
                     Sectors sectors = {});

/// The number at that path, or the "value" of an estimate there; NaN if there is none.
double number_at(const Numbers& run, const std::string& path);

/// Whether there is anything at that path.
bool has_numbers(const Numbers& run, const std::string& path);

/// The exponential tail k exp(-s x) of a mean density, as a line from one end of the fitted range to the other. Slope s
/// and range are means over runs of {"slope", "low", "high"} in their numbers, at the dotted `path`; k is what fits the
/// density best in its logarithm between the ends. Where there is {"beta_line"} instead, the straight line of
/// regression of ln P on x beyond the mean, P the survival function. Empty if no run has a tail there or the density
/// has no point in it.
Curve tail_line(const std::vector<Numbers>& runs, const std::string& path, const Curve& density);

}  // namespace arenite::statistics
