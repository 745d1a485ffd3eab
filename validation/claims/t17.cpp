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
  const Value correlation = mean_over_seeds(runs, [](const Run& run) { return campaign::film_number(run.folder(), "correlation"); });
  const Value rms = mean_over_seeds(runs, [](const Run& run) { return campaign::film_number(run.folder(), "rms_sigma_norm"); });
  judgement.checks = {above("correlation of sigma_norm with the simulation's, NETD 20 mK", "the same field", correlation, 0.98),
                      below("rms error of sigma_norm, NETD 20 mK", "the same field", rms, 0.05)};
  if (std::isfinite(correlation.value)) judgement.ours = fmt::format("correlation {}, rms error {}", text_of(correlation), text_of(rms));
  judgement.checks.push_back(reported("slope of stresses found against true ones",
                                      mean_over_seeds(runs, [](const Run& run) { return campaign::film_number(run.folder(), "slope"); })));
  judgement.checks.push_back(
      reported("grains whose stress the films give", mean_over_seeds(runs, [](const Run& run) { return campaign::film_number(run.folder(), "count"); })));
  judgement.decides =
      "The camera films the field of stress that the simulation has; friction and damping decide which field that is, not how well it is found.";
  return judgement;
}

}  // namespace arenite::validation
