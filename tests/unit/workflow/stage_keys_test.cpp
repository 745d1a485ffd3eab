#include "workflow/stage_keys.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/small_study.hpp"

namespace arenite::study {
namespace {

std::vector<std::string> hashes(const std::string& contact) {
  std::string text = test::small_cemented_recipe;
  const std::string given = "[contact]\nfriction_law = \"cundall_strack\"\n";
  text.replace(text.find(given), given.size(), "[contact]\n" + contact);
  std::vector<std::string> list;
  for (const PlannedStage& stage : plan_of(parse_recipe(text, "recipe.toml"))) list.push_back(stage.hash);
  return list;
}

TEST(StageKeys, OfARecipeThatStatesItsLawsDoNotFollowTheDefaults) {
  // As they were under the same laws when friction faded at rest and dashpots pulled unless told otherwise.
  const std::vector<std::string> then{
      "0840ec9a17f553ed681e5476a31a827e", "713edf97a3d4af188158ee980ae0e314", "aab9335786702e4c53728275d6cdaebd",
      "5365ff5b33ab251901cf938c3bd4ff7f"};
  EXPECT_EQ(hashes("friction_law = \"cundall_strack\"\nrestitution = 0.5\nattractive_dashpot = true\n"), then);
}

TEST(StageKeys, ThePackingDependsOnNoLawButItsLoadingDoes) {
  const auto a = hashes("restitution = 0.5\n"), b = hashes("restitution = 0.6\n");
  EXPECT_EQ(a[0], b[0]);
  for (std::size_t s = 1; s < a.size(); ++s) EXPECT_NE(a[s], b[s]);
}

}  // namespace
}  // namespace arenite::study
