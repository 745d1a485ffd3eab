#include <fmt/core.h>

#include <cmath>

#include "campaign/virtual_film.hpp"
#include "validation/checks.hpp"
#include "validation/claims/claims.hpp"
#include "validation/pooled.hpp"

namespace arenite::validation {

/// Stresses from a film of a simulated sample against those of the simulation.
Judgement judge_t17(const Results& results) {
  Judgement judgement;
  const auto runs = results.runs(campaign::filmed_study);
  const Value correlation =
      mean_over_seeds(runs, [](const Run& run) { return campaign::film_number(run.folder(), "correlation"); });
  const Value rms =
      mean_over_seeds(runs, [](const Run& run) { return campaign::film_number(run.folder(), "rms_sigma_norm"); });
  judgement.checks = {
      above("correlation of sigma_norm with the simulation's, NETD 20 mK", "same field", correlation, 0.98),
      below("rms error of sigma_norm, NETD 20 mK", "same field", rms, 0.05)};
  if (std::isfinite(correlation.value))
    judgement.ours = fmt::format("correlation {}, rms error {}", text_of(correlation), text_of(rms));
  judgement.checks.push_back(
      reported("slope of recovered against true stresses",
               mean_over_seeds(runs, [](const Run& run) { return campaign::film_number(run.folder(), "slope"); })));
  judgement.checks.push_back(reported("grains with a stress from the films", mean_over_seeds(runs, [](const Run& run) {
                                        return campaign::film_number(run.folder(), "count");
                                      })));
  judgement.decides =
      "The virtual camera films the stress field of the simulation; friction and damping determine that field, but not "
      "the accuracy with which it is recovered.";
  return judgement;
}

}  // namespace arenite::validation
