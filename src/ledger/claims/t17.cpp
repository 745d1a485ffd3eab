#include <fmt/format.h>

#include <cmath>

#include "ledger/claims/claims.hpp"
#include "ledger/pooled.hpp"
#include "ledger/virtual_film.hpp"

namespace arenite::ledger {

/// Stresses from a film of a simulated sample against those of the simulation.
Judgement judge_t17(const Results& results) {
  Judgement judgement;
  const auto runs = results.runs(filmed_study);
  const Value correlation = mean_over_seeds(runs, [](const Run& run) { return film_agreement(run).correlation; });
  const Value rms = mean_over_seeds(runs, [](const Run& run) { return film_agreement(run).rms_sigma_norm; });
  judgement.stated.checks = {above("correlation of sigma_norm with the simulation's", "the same field", correlation, 0.98)};
  judgement.sharpened.checks = {above("correlation of sigma_norm with the simulation's, NETD 20 mK", "the same field", correlation, 0.98),
                                below("rms error of sigma_norm, NETD 20 mK", "the same field", rms, 0.05)};
  const Value slope = mean_over_seeds(runs, [](const Run& run) { return film_agreement(run).slope; });
  if (std::isfinite(slope.value)) judgement.findings.push_back(fmt::format("Stresses found over true ones: slope {}.", text_of(slope)));
  if (const Value found = mean_over_seeds(runs, [](const Run& run) { return film_agreement(run).grains; }); std::isfinite(found.value))
    judgement.findings.push_back(fmt::format("Grains whose stress the films give: {} of {:.0f}.", text_of(found), mean_over_seeds(runs, "grains").value));
  judgement.findings.emplace_back("Friction and damping decide which field of stress there is; the camera films that field, and the simulation it is held against has the same. Seeds: the errors above.");
  return judgement;
}

}  // namespace arenite::ledger
