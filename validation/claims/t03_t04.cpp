#include <fmt/core.h>

#include <cmath>

#include "validation/claims/chapter3.hpp"
#include "validation/claims/claims.hpp"
#include "validation/claims/thesis_choices.hpp"
#include "validation/pooled.hpp"
#include "validation/trends.hpp"

namespace arenite::validation {
namespace {

/// The mode of each type of contact.
struct Modes {
  Family amplitude, angle;  ///< angle from the wanted direction, degrees
};
Modes six_fold(const std::vector<Run>& runs) {
  Modes modes;
  for (const std::string set : {"", "POM-POM", "HDPE-HDPE", "HDPE-POM"}) {
    const PooledMode mode = pooled_mode(runs, set, 6);
    modes.amplitude.push_back({set.empty() ? "all" : set, mode.amplitude});
    modes.angle.push_back({set.empty() ? "all" : set, angle_from(mode, 0, 60)});
  }
  return modes;
}

/// `wanted` degrees, or any that is `period` away.
Check near_direction(const std::string& what, const PooledMode& mode, const std::string& source, double wanted,
                     double period) {
  return below(fmt::format("{} (noise of a_c {:.2g})", what, 2 * mode.noise), source, angle_from(mode, wanted, period),
               15, "deg");
}

/// How far a random filling of the same disks gets.
std::string random_filling(const Results& results) {
  const auto runs = results.runs("thesis-ch3-random");
  if (runs.empty()) return {};
  const PooledMode all = pooled_mode(runs, "", 6);
  return fmt::format(
      " From random fillings ({} samples) the pooled 6-fold amplitude is {} (noise {:.2g}), that of a single sample {} "
      "on average, at a solid fraction of {}.",
      runs.size(), text_of(all.amplitude), all.noise, text_of(mean_over_seeds(runs, "fabric.modes.6.amplitude")),
      text_of(mean_over_seeds(runs, "solid_fraction")));
}

}  // namespace

/// Sample #2 is stacked: 1235 disks of one size fit the container only as a crystal.
Judgement judge_t3(const Results& results) {
  Judgement judgement;
  const Modes modes = six_fold(runs_of(results, sample_2));
  judgement.checks = {every("6-fold amplitude by type of contact", "peaks", modes.amplitude, {.low = 0.5}),
                      every("angle of its peaks from 0, 60, 120 degrees", "0", modes.angle, {.high = 10}, "deg")};
  if (const Value& all = modes.amplitude.front().value; std::isfinite(all.value)) {
    judgement.ours =
        fmt::format("6-fold amplitude {}, peaks off by {} degrees", text_of(all), text_of(modes.angle.front().value));
    judgement.decides =
        "Sample #2 starts as a stacked crystal, because 1235 disks of one size fit the container in no other way." +
        random_filling(results);
  }
  add_choices(judgement, results, "6-fold amplitude of #2", sample_2, "fabric.modes.6.amplitude", wanted_above(0.5));
  return judgement;
}

/// POM-POM contacts of #8 and #12, pooled over seeds.
Judgement judge_t4(const Results& results) {
  Judgement judgement;
  const PooledMode pom_8 = pooled_mode(runs_of(results, sample_8), "POM-POM", 2),
                   pom_12 = pooled_mode(runs_of(results, sample_12), "POM-POM", 2);
  const std::vector<Draw> of_8{{"thesis-ch3", where(sample_8)}};
  judgement.checks = {
      drawn(of_8, below("a_c of all contacts, #8", "quasi-isotropic",
                        mean(results, "thesis-ch3", "fabric.a_c", where(sample_8)), 0.15)),
      drawn(of_8, near_direction("deviation of POM-POM orientations from the load axis, #8", pom_8, "0", 90, 180)),
      decided_by(Decider::lost, number(near_direction("deviation of POM-POM orientations from 45 degrees, #12", pom_12,
                                                      "0", 45, 90)))};
  if (pom_8.contacts > 0) {
    judgement.ours =
        fmt::format("POM-POM of #8 at {}, of #12 at {} degrees", text_of(pom_8.phase_deg), text_of(pom_12.phase_deg));
    judgement.decides = fmt::format(
        "#12 has {:.0f} POM-POM contacts in all samples together; the laboratory had a single sample, in which the "
        "direction is noise.",
        pom_12.contacts);
  }
  for (const auto& [name, mode] : {std::pair{"#8", pom_8}, {"#12", pom_12}})
    judgement.checks.push_back(reported(
        fmt::format("a_c of POM-POM contacts, {} (noise {:.2g}, {:.0f} contacts)", name, 2 * mode.noise, mode.contacts),
        weighted_sum({{2, mode.amplitude}})));
  add_choices(judgement, results, "a_c of all contacts of #8", sample_8, "fabric.a_c", wanted_below(0.15));
  add_choices(judgement, results, "Signed a_c of POM-POM contacts of #8", sample_8, "fabric.sets.POM-POM.a_c_signed");
  return judgement;
}

}  // namespace arenite::validation
