#include <gtest/gtest.h>

#include <cmath>

#include "grains/fields/loading.hpp"
#include "grains/fields/stage_numbers.hpp"
#include "report/stage_doubts.hpp"

namespace arenite::fields {
namespace {

/// 0.4 m by 0.2 m, 10 mm thick; the right side under these forces, the top under twice as much.
StageResult loaded(const std::vector<double>& forces) {
  StageResult r;
  r.name = "load";
  r.snapshots.emplace_back();
  r.snapshots.back().packing.domain.thickness = 0.01;
  std::vector<double> time, twice;
  for (std::size_t k = 0; k < forces.size(); ++k) time.push_back(0.01 * static_cast<double>(k + 1));
  for (const double f : forces) twice.push_back(2 * f);
  const auto column = [&](const char* name, const char* unit, std::vector<double> values) {
    r.history.columns.push_back({name, unit, std::move(values)});
  };
  column("time", "s", time);
  column("left_position", "m", std::vector<double>(forces.size(), 0.1));
  column("right_position", "m", std::vector<double>(forces.size(), 0.5));
  column("bottom_position", "m", std::vector<double>(forces.size(), 0));
  column("top_position", "m", std::vector<double>(forces.size(), 0.2));
  column("right_force", "N", forces);
  column("top_force", "N", twice);
  return r;
}

/// 20 N and what fluctuates about it by 2 N, behind a peak.
std::vector<double> fluctuating(double mean) {
  std::vector<double> forces;
  for (int k = 0; k < 1200; ++k) forces.push_back(k < 40 ? 5 * mean : mean + 2 * std::sqrt(2.0) * std::sin(2.4 * k));
  return forces;
}

TEST(LoadNumbers, TellWhatWasAskedForAndReachedWhileAStageLasts) {
  dem::Stage stage;
  stage.duration = 12;
  stage.side[right] = {dem::SideDrive::Kind::pressure, 1e4};
  stage.side[top] = {dem::SideDrive::Kind::force, 40};
  StageResult result = loaded(fluctuating(20));
  const Numbers loads = load_numbers({result, stage, nullptr, {}})["loads"];
  EXPECT_EQ(loads["right"]["asked_Pa"].get<double>(), 1e4);
  EXPECT_NEAR(loads["right"]["reached_Pa"]["value"].get<double>(), 1e4, 20);
  EXPECT_LT(loads["right"]["reached_Pa"]["error"].get<double>(), 20);
  EXPECT_NEAR(loads["right"]["spread_Pa"].get<double>(), 1000, 20);
  EXPECT_NEAR(loads["top"]["reached_N"]["value"].get<double>(), 40, 0.1);
  EXPECT_TRUE(loads["top"]["held"].get<bool>());
  result.texture = {{"loads", loads}};
  EXPECT_EQ(report::loads_in_words(result.texture).size(), 2u);
  EXPECT_TRUE(report::doubts_about(result.texture).empty());
}

TEST(LoadNumbers, AreDoubtedBeyondFivePerCent) {
  dem::Stage stage;
  stage.duration = 12;
  stage.side[right] = {dem::SideDrive::Kind::pressure, 1e4};
  for (const double mean : {18.8, 19.2, 20.8, 21.2}) {
    StageResult result = loaded(fluctuating(mean));
    result.texture = load_numbers({result, stage, nullptr, {}});
    EXPECT_EQ(report::doubts_about(result.texture).size(), std::abs(mean - 20) > 1 ? 1u : 0u) << mean;
  }
}

TEST(LoadNumbers, AreThoseOfTheEndWhereAStageEndsInEquilibrium) {
  dem::Stage stage;
  stage.side[right] = {dem::SideDrive::Kind::pressure, 1e4};
  const StageResult result = loaded({0, 35, 28, 20});
  const Numbers load = load_numbers({result, stage, nullptr, {}})["loads"]["right"];
  EXPECT_EQ(load["reached_Pa"]["value"].get<double>(), 1e4);
  EXPECT_FALSE(load.contains("spread_Pa"));
  EXPECT_FALSE(load_numbers({result, dem::Stage{}, nullptr, {}}).contains("loads"));
}

TEST(LoadNumbers, FollowTheTableOfAProgramme) {
  dem::Stage stage;
  stage.duration = 12;
  stage.side[right] = {dem::SideDrive::Kind::pressure, 0};
  stage.programmes = {{{dem::Programme::What::pressure, right}, {{0, 0}, {12, 12e3}}}};
  std::vector<double> forces;
  for (int k = 1; k <= 1200; ++k) forces.push_back(2e-3 * 10 * k);  // 2e-3 m^2 under 1000 Pa a second
  const Numbers load = load_numbers({loaded(forces), stage, nullptr, {}})["loads"]["right"];
  EXPECT_NEAR(load["asked_Pa"].get<double>(), load["reached_Pa"]["value"].get<double>(), 1e-6);
  EXPECT_NEAR(load["spread_Pa"].get<double>(), 0, 1e-6);
}

TEST(EnergyNumbers, TellWhatTheBalanceLeavesOpenAndDoubtItBeyondOnePerCent) {
  for (const double missing : {1e-3, 0.05}) {
    StageResult result = loaded({1, 1, 1});
    result.history.columns.push_back({"work_walls", "J", {1, 2, 3}});
    result.history.columns.push_back({"elastic", "J", {0.5, 0.8, 1}});
    result.history.columns.push_back({"dissipated_friction", "J", {0, 1, 1.5 - 2 * missing}});
    result.texture = energy_numbers({result, dem::Stage{}, nullptr, {}});
    EXPECT_NEAR(result.texture["energy_balance"]["open"].get<double>(), missing, 1e-12);
    EXPECT_EQ(report::doubts_about(result.texture).size(), missing > 0.01 ? 1u : 0u);
  }
  EXPECT_TRUE(energy_numbers({loaded({1, 1, 1}), dem::Stage{}, nullptr, {}}).empty());
}

TEST(EnergyNumbers, AreNoneWhereOnlyBrokenBondsAreCounted) {
  StageResult result = loaded({1, 1, 1});
  result.history.columns.push_back({"elastic", "J", {0, 0.8, 0.1}});
  for (const char* name : {"dissipated_normal", "dissipated_friction", "dissipated_drag", "work_walls", "work_gravity"})
    result.history.columns.push_back({name, "J", {0, 0, 0}});
  result.history.columns.push_back({"dissipated_breakage", "J", {0, 0.1, 0.5}});
  EXPECT_TRUE(energy_numbers({result, dem::Stage{}, nullptr, {}}).empty());
  EXPECT_TRUE(energies_of(result.history).list.empty());
}

}  // namespace
}  // namespace arenite::fields
