#include "grains/fields/regime/until.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/error.hpp"

namespace arenite::fields {
namespace {

Packing two_by_two() {
  Packing packing;
  packing.materials = {{"clay", 1000, 1e6, 0}};
  packing.grains.resize(1);
  packing.grains.radius = {1};
  packing.domain.wall[right].position = 2;
  packing.domain.wall[top].position = 2;
  packing.domain.thickness = 1;
  return packing;
}

/// A sample of 2 m x 2 m whose top comes down, under 10 N from the sides and these forces from above.
History pressed(std::vector<double> height, std::vector<double> force) {
  const std::size_t n = height.size();
  History rows;
  const auto add = [&](const char* name, const char* unit, std::vector<double> values) {
    rows.columns.push_back({name, unit, std::move(values)});
  };
  std::vector<double> time;
  for (std::size_t k = 0; k < n; ++k) time.push_back(static_cast<double>(k));
  add("time", "s", time);
  add("left_position", "m", std::vector<double>(n, 0.0)), add("right_position", "m", std::vector<double>(n, 2.0));
  add("bottom_position", "m", std::vector<double>(n, 0.0)), add("top_position", "m", std::move(height));
  for (const char* side : {"left_force", "right_force"}) add(side, "N", std::vector<double>(n, 10.0));
  for (const char* side : {"bottom_force", "top_force"}) add(side, "N", force);
  add("unbalanced_ratio", "1", std::vector<double>(n, 0.1));
  return rows;
}

std::string met(const std::string& condition, const History& rows) {
  const Packing sample = two_by_two();
  return Until(condition).met(rows, 0, {}, &sample, sample).value_or("");
}

std::string refusal_of(const std::string& condition) {
  try {
    dem::Stage stage;
    Domain domain;
    domain.boundaries.emplace_back().name = "gate";
    Until(condition).check(history_numbers(stage, domain, false, false));
    return "";
  } catch (const InputError& error) { return error.what(); }
}

TEST(Until, HoldsWhereACurveOfTheLastRowIsBeyondItsLimit) {
  const History rows = pressed({2, 1.9, 1.58}, {10, 30, 40});
  EXPECT_EQ(met("axial_strain > 22 %", rows), "");
  EXPECT_NE(met("axial_strain > 20 %", rows).find("axial_strain > 20 % (axial_strain = 0.21)"), std::string::npos);
  EXPECT_EQ(met("top_force > 0.05 kN", rows), "");
  EXPECT_NE(met("top_force > 0.03 kN", rows), "");
}

TEST(Until, AShareOfTheLargestSoFarIsOfAllRowsBefore) {
  // q is half the difference of 10 Pa m and the forces over 2 m: 10, 30, 14 N make 0, 10, 2 N/m over 2.
  EXPECT_EQ(met("q < 0.5*max(q)", pressed({2, 1.9, 1.8}, {10, 30, 24})), "");
  EXPECT_NE(met("q < 0.5*max(q)", pressed({2, 1.9, 1.8, 1.7}, {10, 30, 24, 18})), "");
  // The largest itself is no fall.
  EXPECT_EQ(met("q < 0.5*max(q)", pressed({2, 1.9}, {10, 30})), "");
}

TEST(Until, ANumberMustHaveBeenAtTheLimitToFallBelowIt) {
  EXPECT_EQ(met("top_force < 20 N", pressed({2, 1.9, 1.8}, {10, 12, 14})), "");
  EXPECT_NE(met("top_force < 20 N", pressed({2, 1.9, 1.8}, {10, 22, 14})), "");
}

TEST(Until, AndAsksForAllAndOrForOne) {
  const History rows = pressed({2, 1.9, 1.58}, {10, 30, 40});
  EXPECT_NE(met("axial_strain > 20 % and top_force > 30 N", rows), "");
  EXPECT_EQ(met("axial_strain > 20 % and top_force > 50 N", rows), "");
  EXPECT_NE(met("top_force > 50 N or axial_strain > 20 % and top_force > 30 N", rows), "");
  EXPECT_EQ(met("top_force > 50 N or axial_strain > 30 %", rows), "");
}

TEST(Until, IsNotMetByWhatIsNotKnownYet) {
  EXPECT_EQ(met("axial_strain > 0", pressed({1.5}, {10})), "");  // one row has no curves
  History unloaded = pressed({2, 1.9}, {0, 0});
  for (auto& column : unloaded.columns)
    if (column.name.ends_with("_force")) column.values = {0, 0};
  EXPECT_EQ(met("q > 0.1*max(q)", unloaded), "");
}

TEST(Until, RefusesUnknownNumbersWithThoseThatThereAre) {
  const std::string slip = refusal_of("axal_strain > 20 %");
  EXPECT_NE(slip.find("did you mean axial_strain?"), std::string::npos) << slip;
  for (const char* known : {"q_over_p", "top_position", "gate_force_x", "unbalanced_ratio", "axial_stress", "work"})
    EXPECT_NE(slip.find(known), std::string::npos) << known << ": " << slip;
  EXPECT_NE(refusal_of("q < 0.5*max(qq)"), "");
  EXPECT_EQ(slip.find("passed"), std::string::npos) << "nothing is counted in this stage";
}

TEST(Until, RefusesOtherKindsOfQuantitiesAndWhatIsNoCondition) {
  EXPECT_NE(refusal_of("axial_strain > 20 kPa").find("compares"), std::string::npos);
  EXPECT_NE(refusal_of("q < 3").find("compares"), std::string::npos);
  for (const char* text : {"", "axial_strain", "axial_strain >= 20 %", "> 3", "1 < 2 < 3", "q > ", "2*q > 3 kPa"})
    EXPECT_NE(refusal_of(text), "") << text;
  for (const char* text :
       {"axial_strain > 20 %", "q < 0.5*max(q)", "q > 2 kPa and time > 0.1 s", "p < q_over_p*max(q)"})
    EXPECT_EQ(refusal_of(text), "") << text;
}

TEST(Until, KnowsTheNumbersOfWhatAStageCountsAndShears) {
  dem::Stage stage;
  stage.count_below = 0;
  stage.slide[top] = 1;
  const auto known = history_numbers(stage, {}, true, true);
  for (const char* name : {"discharge_rate", "passed_mass", "mu", "shear_strain", "bonds", "cohesive_pairs"})
    EXPECT_EQ(std::ranges::count(known, name, &HistoryNumber::name), 1) << name;
}

TEST(Until, KnowsTheNumbersOfSpheresThatAreCompressedShearedOrCounted) {
  const auto known = [](const dem::Stage& stage, const char* name) {
    DomainIn<3> domain;
    for (const int side : {right, top, front}) domain.wall[side].position = 2;
    return std::ranges::count(history_numbers_in_space(stage, domain, false, false), name, &HistoryNumber::name);
  };
  dem::Stage closing, sliding, flowing;
  closing.side[top] = {dem::SideDrive::Kind::velocity, 0.1};
  for (const char* name : {"axial_strain", "q_over_p", "inertial_number", "top_force"})
    EXPECT_EQ(known(closing, name), 1) << name;
  sliding.slide[top] = 0.1;
  for (const char* name : {"shear_strain", "mu"}) EXPECT_EQ(known(sliding, name), 1) << name;
  flowing.gravity = true;
  flowing.count_below = 0.1;
  for (const char* name : {"passed", "discharge_rate"}) EXPECT_EQ(known(flowing, name), 1) << name;
}

}  // namespace
}  // namespace arenite::fields
