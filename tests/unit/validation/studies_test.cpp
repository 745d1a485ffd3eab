#include "validation/studies.hpp"

#include <gtest/gtest.h>

#include "support/temporary_folder.hpp"

namespace arenite::validation {
namespace {

TEST(Studies, FindTheRecipeThatTheyAreLaidOver) {
  const test::TemporaryFolder folder;
  const StudySource* source = find_study("paper-strength");
  ASSERT_NE(source, nullptr);
  const campaign::Study study = unpack_study(*source, folder.path() / "paper-strength", false);
  EXPECT_EQ(study.runs.size(), 30u);
  EXPECT_TRUE(std::filesystem::is_regular_file(folder.path() / "paper" / "recipe.toml"));
}

TEST(Studies, CanAllBeReadWholeAndSmall) {
  const test::TemporaryFolder folder;
  for (const StudySource& source : studies()) {
    if (!source.has_runs()) continue;
    for (const bool small : {false, true})
      EXPECT_FALSE(unpack_study(source, folder.path() / (small ? "small" : "whole") / source.name, small).runs.empty())
          << source.name;
  }
}

}  // namespace
}  // namespace arenite::validation
