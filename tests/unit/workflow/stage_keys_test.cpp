#include "workflow/stage_keys.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "core/mapped.hpp"
#include "support/small_study.hpp"

namespace arenite::workflow {
namespace {

std::vector<PlannedStage> plan(const std::vector<std::string>& overrides) {
  return plan_of(recipe::parse_recipe(test::small_cemented_recipe, "recipe.toml", overrides));
}

recipe::Recipe with_contact(const std::string& contact) {
  std::string text = test::small_cemented_recipe;
  const std::string given = "[contact]\nfriction_law = \"cundall_strack\"\n";
  text.replace(text.find(given), given.size(), "[contact]\n" + contact);
  return recipe::parse_recipe(text, "recipe.toml");
}

std::vector<std::string> hashes(const std::string& contact) {
  return mapped(plan_of(with_contact(contact)), &PlannedStage::hash);
}

TEST(StageKeys, SeedsFollowFromTheNameThatVersion01GaveThePacking) {
  // A key that came later must not be in it, nor any law.
  EXPECT_EQ(seed_key(with_contact("friction_law = \"cundall_strack\"\nrestitution = 0.5\nattractive_dashpot = true\n")),
            "0840ec9a17f553ed681e5476a31a827e");
  EXPECT_EQ(seed_key(with_contact("restitution = 0.6\n")), "0840ec9a17f553ed681e5476a31a827e");
}

TEST(StageKeys, ThePackingDependsOnNoLawButItsLoadingDoes) {
  const auto a = hashes("restitution = 0.5\n"), b = hashes("restitution = 0.6\n");
  EXPECT_EQ(a[0], b[0]);
  for (std::size_t s = 1; s < a.size(); ++s) EXPECT_NE(a[s], b[s]);
}

TEST(StageKeys, AKeyAtItsDefaultChangesNoName) {
  const auto before = plan({});
  for (const char* set : {"packing.method=random", "contact.restitution=0.5", "contact.arms=contact_point",
                          "contact.wall_stiffness=stiffest", "integration.safety=0.1", "integration.rotations=true",
                          "stages.0.gravity=false", "stages.0.increments=1", "stages.0.equilibrium.unbalanced=0.0001",
                          "cement.full_width=false", "grid.eight_connected=false", "loads.0.strain=0.0001",
                          "loads.0.stiffness.matrix=1 GPa", "loads.0.statistics.clamp_rows=4"}) {
    const auto after = plan({set});
    ASSERT_EQ(after.size(), before.size());
    for (std::size_t s = 0; s < before.size(); ++s) EXPECT_EQ(after[s], before[s]) << set << ": " << before[s].name;
  }
}

TEST(StageKeys, AChangedKeyChangesTheNamesOfItsStageAndOfThoseAfterIt) {
  const auto before = plan({});
  const std::vector<std::pair<const char*, std::size_t>> changes{
      {"packing.solid_fraction=0.71", 0}, {"seed=4", 0},
      {"container.height=200 mm", 0},     {"contact.restitution=0.2", 1},
      {"stages.0.gravity=true", 1},       {"cement.width=0.31", 2},
      {"cement.full_width=true", 2},      {"grid.nodes=65", 2},
      {"loads.0.strain=0.0002", 3},       {"loads.0.axis=x", 3}};
  for (const auto& [set, first] : changes) {
    const auto after = plan({set});
    for (std::size_t s = 0; s < before.size(); ++s)
      EXPECT_EQ(after[s].hash == before[s].hash, s < first) << set << ": " << before[s].name;
  }
}

TEST(StageKeys, AValueThatIsTakenAwayAndASectionThatIsGivenDiffer) {
  EXPECT_NE(plan({"contact.wall_friction=0.3"})[1].hash, plan({})[1].hash);
  EXPECT_NE(plan({"stages.0.duration=1 s"})[1].hash, plan({})[1].hash);
  EXPECT_EQ(plan({"stages.0.mass_scaling=own"})[1].hash, plan({})[1].hash);
}

}  // namespace
}  // namespace arenite::workflow
