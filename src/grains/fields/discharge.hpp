#pragma once
#include <optional>
#include <vector>

#include "model/packing.hpp"
#include "model/result.hpp"
#include "statistics/columns.hpp"
#include "statistics/measured.hpp"

namespace arenite::fields {

/// How fast something passes while it does so steadily.
struct Discharge {
  bool steady = false;  ///< there is a part in which the rate only fluctuates; else the rate is that between the first
                        ///< and the last passing
  statistics::Measured
      rate;  ///< of what passes, per s; its error, by blocks of the steady part, only where there is one
  double begin = statistics::unknown, end = statistics::unknown;  ///< of that part, s
  bool stopped =
      false;  ///< nothing passes any more in the end, for longer than a tenth of the time of flow: empty or clogged
};

/// From amounts passed at times, s, that never shrink but by rounding (1e-9 of the largest): steady part without the
/// beginning, where it sets in, and the end, where it runs dry, each cut where the error of the rest is least
/// (steady_state.hpp). Unknown where nothing passes. Throws InputError for lists of unlike lengths, numbers that are
/// not finite, and times that do not grow.
Discharge find_discharge(const std::vector<double>& time, const std::vector<double>& passed);

/// The rate at which something passes now, per s, row by row: of an `amount` (grains, mass) over the time that the last
/// twenty grains took, up to now; before so many have passed over the time since the first. 0 before anything passes.
std::vector<double> discharge_rate(const std::vector<double>& time, const std::vector<double>& grains,
                                   const std::vector<double>& amount);

/// What has passed so far, row by row: what a history counts below a height, else what left through outlets. Null where
/// it counts neither.
struct Passed {
  const std::vector<double>*grains, *mass;
};
Passed passed_in(const History& rows);

/// As curves of a history that counts what passes, `discharge_rate` and `discharge_mass_rate`; nothing of others.
void put_discharge_rates(const History& rows, const std::vector<double>& time, statistics::Columns& to);

/// The discharge of a stage whose history counts what passes: rates over the steady part, when it began and ended.
/// Empty of others, and where nothing passes.
Numbers discharge_numbers(const History& history);

/// The narrowest way between two of the boundaries that are there, m; unknown where there are fewer than two.
double narrowest_opening(const Domain& domain);
/// In space the narrowest opening in one of them: four times its area over the length of its rim, m, which is the
/// diameter of a round one. Unknown where none has an opening.
double narrowest_opening(const DomainIn<3>& domain);

/// How many openings high the filling was, of a stage with these numbers, where that is too low for a rate that does
/// not depend on it: above an opening that is wide beside its height a filling sinks in as it empties, and passes less
/// than a silo would. Nothing of others.
std::optional<double> too_low_filling(const Numbers& stage);

/// The discharge of a stage of disks or spheres, with how wide the opening is that it goes through.
template <int D> Numbers discharge_of(const StageResultIn<D>& result);

}  // namespace arenite::fields
