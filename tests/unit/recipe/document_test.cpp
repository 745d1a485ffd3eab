#include "recipe/document.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "campaign/study.hpp"
#include "core/error.hpp"
#include "recipe/recipe.hpp"
#include "support/temporary_folder.hpp"
#include "unit/recipe/smallest_recipe.hpp"

namespace arenite::recipe {
namespace {

namespace fs = std::filesystem;

const std::string whole = "seed = 3\n" + smallest + R"([[stages]]
name = "more"
bottom = { force = "60 kN" }
)";

class RecipeBase : public ::testing::Test {
 protected:
  std::string put(const std::string& name, const std::string& text) {
    const fs::path file = folder_.path() / name;
    fs::create_directories(file.parent_path());
    std::ofstream(file) << text;
    return file.string();
  }
  /// What main would print.
  std::string refusal(const std::string& file) {
    try {
      read_recipe(file);
    } catch (const InputError& error) {
      EXPECT_EQ(error.problems().size(), 1u);
      return to_string(error.problems().front());
    }
    return {};
  }

 private:
  test::TemporaryFolder folder_;
};

TEST_F(RecipeBase, GivesWhatTheRecipeDoesNot) {
  put("a/recipe.toml", whole);
  const std::string file = put("b/recipe.toml",
                               "base = \"../a/recipe.toml\"\n[frame]\nwidth = \"400 mm\"\n[[stages]]\nname = "
                               "\"other\"\nbottom = { force = \"10 kN\" }\n");
  const Recipe recipe = read_recipe(file);
  EXPECT_EQ(recipe.container.width, 0.4);
  EXPECT_EQ(recipe.container.thickness, 0.06);
  EXPECT_EQ(recipe.seed, 3u);
  ASSERT_EQ(recipe.stages.size(), 1u);
  EXPECT_EQ(recipe.stages[0].name, "other");
  EXPECT_EQ(read_recipe(file, {"container.thickness=50 mm"}).container.thickness, 0.05);
}

TEST_F(RecipeBase, MayHaveABaseOfItsOwnBesideItself) {
  put("a/recipe.toml", whole);
  put("a/middle.toml", "base = \"recipe.toml\"\n[frame]\nwidth = \"500 mm\"\n");
  EXPECT_EQ(read_recipe(put("b/recipe.toml", "base = \"../a/middle.toml\"\n")).container.width, 0.5);
}

TEST_F(RecipeBase, MakesTheSameRunsAsTheRecipeWrittenOut) {
  const std::string sweep = "[sweep]\nreplicates = 2\n[sweep.grid]\n\"contact.friction\" = [0, 0.3]\n";
  const std::string base = put("a/recipe.toml", whole + "[sweep]\nreplicates = 7\n");
  const campaign::Study laid = campaign::read_study(put("b/recipe.toml", "base = \"../a/recipe.toml\"\n" + sweep), {});
  const campaign::Study written = campaign::read_study(put("c/recipe.toml", whole + sweep), {});
  ASSERT_EQ(laid.runs.size(), 4u);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(laid.runs[k].name, written.runs[k].name);
  ASSERT_EQ(laid.inputs.size(), 2u);
  EXPECT_TRUE(fs::equivalent(laid.inputs[1].first, base));
}

TEST_F(RecipeBase, ThatIsNotThereIsOneSentence) {
  const std::string said = refusal(put("b/recipe.toml", "\nbase = \"../a/recipe.toml\"\n"));
  EXPECT_NE(said.find("recipe.toml:2:"), std::string::npos) << said;
  EXPECT_NE(said.find("base: there is no file"), std::string::npos) << said;
  EXPECT_NE(refusal(put("b/number.toml", "base = 3\n")).find("must be the name of another recipe"), std::string::npos);
}

TEST_F(RecipeBase, CannotBeTheRecipeItself) {
  put("a.toml", "base = \"b.toml\"\n");
  EXPECT_NE(refusal(put("b.toml", "base = \"a.toml\"\n")).find("leads back to itself"), std::string::npos);
}

TEST_F(RecipeBase, HasItsOwnMistakes) {
  put("base.toml", whole + "[contact]\nfrction = 0.3\n");
  const std::string said = refusal(put("recipe.toml", "base = \"base.toml\"\n"));
  EXPECT_NE(said.find("base.toml:19:"), std::string::npos) << said;
  EXPECT_NE(said.find("did you mean friction?"), std::string::npos) << said;
}

TEST_F(RecipeBase, IsForFilesOnly) { EXPECT_THROW(parse_recipe("base = \"a.toml\"\n", "memory"), InputError); }

TEST_F(RecipeBase, ATextInAnotherEncodingIsToldSo) {
  const std::string told = "this is not UTF-8, in which recipes are written; save it as UTF-8";
  std::string utf_16 = "\xFF\xFE";
  for (const char c : whole) utf_16.append(1, c).append(1, '\0');
  const std::string latin = put("latin.toml", "title = \"a\"\ntitel = \"K\xF6rner\"\n" + whole),
                    wide = put("wide.toml", utf_16), without_mark = put("bare.toml", utf_16.substr(2));
  EXPECT_EQ(refusal(wide), wide + ": " + told);
  EXPECT_EQ(refusal(without_mark), without_mark + ": " + told);
  EXPECT_EQ(refusal(latin).find(latin + ":2:"), 0u) << refusal(latin);
  EXPECT_NE(refusal(latin).find(told), std::string::npos) << refusal(latin);
}

}  // namespace
}  // namespace arenite::recipe
