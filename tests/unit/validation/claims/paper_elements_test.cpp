#include "validation/claims/paper_elements.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "unit/validation/made_up_table.hpp"
#include "validation/claims/paper_checks.hpp"

namespace arenite::validation {
namespace {

const std::vector<std::string> sample_keys{"bidisperse.size_ratio", "bidisperse.volume_ratio", "cement.kind", "seed"};
const std::vector<std::string> sample_numbers{"stress.sigma_yy.sets.large.variance"};

std::vector<MadeUpRun> samples_with(double variance, const std::vector<const char*>& seeds) {
  std::vector<MadeUpRun> runs;
  for (const char* seed : seeds) runs.push_back({{"5", "1.4", "full", seed}, {variance + 0.01 * std::stod(seed)}});
  return runs;
}

Judgement judged(double bonds, double elements, const std::vector<const char*>& seeds_of_bonds) {
  Results results;
  results.add("paper", made_up_table(sample_keys, sample_numbers, samples_with(bonds, seeds_of_bonds)));
  results.add("paper-elements", made_up_table(sample_keys, sample_numbers, samples_with(elements, {"1", "2", "3"})));
  Judgement j;
  add_elements(j, results, [](const Samples& samples) {
    std::vector<Check> checks;
    for (const PairMean& m : stress_means(samples, "large", "variance"))
      checks = {above("variance", "", m.value, 0), below("variance", "", m.value, 3)};
    return checks;
  });
  return j;
}

TEST(PaperElements, WhatEndsAlikeIsOfTheMaterial) {
  const Judgement j = judged(1, 2, {"1", "2", "3", "4"});  // a fourth sample, which elements did not solve
  ASSERT_EQ(j.findings.size(), 2u);
  EXPECT_EQ(j.findings[0], "By elements, 2 of 2 corresponding checks hold.");
  EXPECT_EQ(j.findings[1],
            "Judged twice, by bonds and by elements in the same 3 samples: 2 checks end alike and are of the material, "
            "none is of the lattice.");
  EXPECT_EQ(j.verdict(), Verdict::unknown) << "what is told beside decides nothing";
}

TEST(PaperElements, WhatEndsOtherwiseIsOfTheLattice) {
  const Judgement j = judged(1, 5, {"1", "2", "3"});
  ASSERT_EQ(j.findings.size(), 2u);
  EXPECT_NE(j.findings[1].find("1 checks end alike"), std::string::npos) << j.findings[1];
  EXPECT_NE(j.findings[1].find("of the lattice: variance: bonds 1.02"), std::string::npos) << j.findings[1];
  EXPECT_NE(j.findings[1].find("(holds), elements 5.02"), std::string::npos) << j.findings[1];
}

TEST(PaperElements, OtherSamplesAreNotCompared) { EXPECT_TRUE(judged(1, 5, {"1", "2"}).findings.empty()); }

}  // namespace
}  // namespace arenite::validation
