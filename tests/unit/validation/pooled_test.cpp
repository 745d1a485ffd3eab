#include "validation/pooled.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "unit/validation/made_up_table.hpp"

namespace arenite::validation {
namespace {

Results made_up(const std::vector<std::string>& names, const std::vector<MadeUpRun>& runs) {
  Results results;
  results.add("made-up", made_up_table({"ratio", "seed"}, names, runs));
  return results;
}

TEST(Pooled, ModesAddAsVectorsWeighedByContacts) {
  const std::vector<std::string> names{"fabric.contacts", "fabric.modes.2.amplitude", "fabric.modes.2.phase_deg"};
  const Results cancel = made_up(names, {{{"1", "1"}, {100, 0.5, 10}}, {{"1", "2"}, {100, 0.5, 100}}});
  EXPECT_NEAR(pooled_mode(cancel.runs("made-up"), "", 2).amplitude.value, 0, 1e-12);
  const Results add = made_up(names, {{{"1", "1"}, {300, 0.5, 179}}, {{"1", "2"}, {100, 0.1, 179}}});
  const PooledMode mode = pooled_mode(add.runs("made-up"), "", 2);
  EXPECT_NEAR(mode.amplitude.value, 0.4, 1e-12);
  EXPECT_NEAR(mode.phase_deg.value, 179, 1e-9);
  EXPECT_NEAR(mode.noise, 0.886 / 20, 1e-12);
  EXPECT_TRUE(std::isnan(pooled_mode(add.runs("made-up"), "strong", 2).amplitude.value));
}

TEST(Pooled, ModesHaveErrorsFromTheScatterOfSeeds) {
  const std::vector<std::string> names{"fabric.contacts", "fabric.modes.2.amplitude", "fabric.modes.2.phase_deg"};
  const PooledMode along =
      pooled_mode(made_up(names, {{{"1", "1"}, {100, 0.3, 90}}, {{"1", "2"}, {100, 0.5, 90}}}).runs("made-up"), "", 2);
  EXPECT_NEAR(along.amplitude.value, 0.4, 1e-12);
  EXPECT_NEAR(along.amplitude.error, 0.1, 1e-12);
  EXPECT_NEAR(along.phase_deg.error, 0, 1e-9);
  const PooledMode across =
      pooled_mode(made_up(names, {{{"1", "1"}, {100, 0.5, 89}}, {{"1", "2"}, {100, 0.5, 91}}}).runs("made-up"), "", 2);
  EXPECT_NEAR(across.phase_deg.value, 90, 1e-9);
  EXPECT_NEAR(across.phase_deg.error, 1, 1e-3);
  EXPECT_TRUE(
      std::isnan(pooled_mode(made_up(names, {{{"1", "1"}, {100, 0.5, 89}}}).runs("made-up"), "", 2).amplitude.error));
}

TEST(Pooled, AnglesRepeat) {
  EXPECT_DOUBLE_EQ(angle_between(175, 5, 180), 10);
  EXPECT_DOUBLE_EQ(angle_between(59, 0, 60), 1);
}

TEST(Pooled, SlopesOfSeedsLeaveOutWhatSeedsDifferBy) {
  std::vector<MadeUpRun> runs;
  for (const int seed : {1, 2, 3})
    for (const int ratio : {1, 2, 3})
      runs.push_back({{std::to_string(ratio), std::to_string(seed)}, {100.0 * seed + 2.0 * ratio}});
  const Results results = made_up({"z"}, runs);
  const Value slope = slope_over_seeds(results.runs("made-up"), swept("ratio"), "z");
  EXPECT_NEAR(slope.value, 2, 1e-9);
  EXPECT_NEAR(slope.error, 0, 1e-9);
  const Value mean = mean_over_seeds(results.runs("made-up"), "z");
  EXPECT_NEAR(mean.value, 204, 1e-9);
  EXPECT_NEAR(mean.error, 100 / std::sqrt(3.0), 1e-9);
}

TEST(Pooled, ChangesOfSeedsLeaveOutWhatPackingsDifferBy) {
  std::vector<MadeUpRun> runs;
  for (const int seed : {1, 2, 3})
    for (const int treated : {0, 1})
      runs.push_back({{std::to_string(treated), std::to_string(seed)}, {100.0 * seed * (treated ? 0.9 : 1)}});
  runs.push_back({{"1", "4"}, {7}});
  const Results results = made_up({"z"}, runs);
  const Value change =
      paired_change(results.runs("made-up", {{"ratio", "1"}}), results.runs("made-up", {{"ratio", "0"}}), "z");
  EXPECT_NEAR(change.value, -0.1, 1e-12);
  EXPECT_NEAR(change.error, 0, 1e-12);
  EXPECT_EQ(change.freedom, 2) << "the fourth has no partner";
}

TEST(Pooled, TailsAreMeansOverSeeds) {
  const std::vector<std::string> names{"force.log_likelihood_ratio", "force.line_r2", "force.beta"};
  const Results results =
      made_up(names, {{{"1", "1"}, {2, 0.98, 1.2}}, {{"2", "1"}, {4, 0.98, 1.2}}, {{"1", "2"}, {5, 0.96, 1.4}}});
  const PooledTail tail = pooled_tail(results.runs("made-up"), "force");
  EXPECT_DOUBLE_EQ(tail.lead.value, 4);  // seeds have 3 and 5
  EXPECT_DOUBLE_EQ(tail.lead.error, 1);
  EXPECT_EQ(tail.lead.freedom, 1);
  EXPECT_NEAR(tail.r2.value, 0.97, 1e-12);
  EXPECT_NEAR(tail.beta.value, 1.3, 1e-12);
}

TEST(Pooled, RandomDirectionsLieNowhereAlongAnAxis) {
  // Seeds that each have an amplitude of 0.2 in directions spread evenly: none along any axis, where amplitudes would
  // add up to 0.2.
  std::vector<MadeUpRun> runs;
  for (int seed = 0; seed < 12; ++seed) runs.push_back({{"1", std::to_string(seed)}, {100, 0.2, 15.0 * seed}});
  const Results results = made_up({"fabric.contacts", "fabric.modes.2.amplitude", "fabric.modes.2.phase_deg"}, runs);
  const Value none = pooled_along(results.runs("made-up"), "", 2, 90);
  EXPECT_NEAR(none.value, 0, 1e-12);
  EXPECT_NEAR(none.error, 0.2 / std::sqrt(2.0) / std::sqrt(11.0), 1e-9);
  EXPECT_EQ(none.freedom, 11);
  EXPECT_NEAR(mean_over_seeds(results.runs("made-up"), "fabric.modes.2.amplitude").value, 0.2, 1e-12);
  const Results across = made_up({"fabric.contacts", "fabric.modes.2.amplitude", "fabric.modes.2.phase_deg"},
                                 {{{"1", "1"}, {100, 0.3, 0}}, {{"1", "2"}, {300, 0.1, 0}}});
  EXPECT_NEAR(pooled_along(across.runs("made-up"), "", 2, 90).value, -0.15, 1e-12);
}

}  // namespace
}  // namespace arenite::validation
