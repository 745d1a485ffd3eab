#include "study/film_recipe.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "core/error.hpp"

namespace arenite::study {
namespace {

std::vector<Problem> problems_of(const std::string& text) {
  try {
    parse_film_recipe(text, "film.toml");
  } catch (const InputError& error) {
    return error.problems();
  }
  return {};
}

TEST(FilmRecipe, TemplateReadsBackWhateverWayItIsWritten) {
  const FilmRecipe recipe = film_template();
  const std::string resolved = to_toml(recipe);
  EXPECT_EQ(to_toml(parse_film_recipe(resolved, "film.toml")), resolved);
  EXPECT_EQ(to_toml(parse_film_recipe(to_commented_toml(recipe), "film.toml")), resolved);
}

TEST(FilmRecipe, CameraReadsBack) {
  FilmRecipe recipe = film_template();
  recipe.camera.emplace();
  recipe.camera->high = "high";
  recipe.camera->parameters.detector.netd = 0.01;
  const FilmRecipe read = parse_film_recipe(to_toml(recipe), "film.toml");
  ASSERT_TRUE(read.camera);
  EXPECT_DOUBLE_EQ(read.camera->parameters.detector.netd, 0.01);
  EXPECT_EQ(to_toml(read), to_toml(recipe));
}

TEST(FilmRecipe, EveryProblemIsReportedInOnePass) {
  const auto problems = problems_of(
      "[materials.POM]\nthermoelastic_factor = \"0.015 K\"\n[frame]\nwidth = 350\nheight = \"350 mm\"\nthickness = \"60 mm\"\n"
      "[picture]\npixels = \"1.6 mm\"\n[lockin]\nfrequency = \"-3 Hz\"\n[temperature]\nfrom = \"film\"\n");
  ASSERT_GE(problems.size(), 5u);
  EXPECT_EQ(problems[0].line, 2);
}

TEST(FilmRecipe, PlatesNeedTheirTemperatures) {
  FilmRecipe recipe = film_template();
  recipe.temperature.from = TemperatureSection::From::plates;
  const auto problems = problems_of(to_toml(recipe));
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_NE(problems[0].message.find("correction.cold"), std::string::npos);
}

TEST(FilmRecipe, PlatesAreNeededWhetherOrNotTheSectionIsWritten) {
  std::string text = to_toml(film_template());
  const auto section = text.find("[temperature]"), next = text.find("\n[", section);
  ASSERT_NE(section, std::string::npos);
  text.erase(section, next - section);
  const auto problems = problems_of(text);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_NE(problems[0].message.find("temperature: from is \"plates\" unless given, and needs correction.cold"), std::string::npos) << problems[0].message;
}

TEST(FilmRecipe, TemperaturesOfPlatesWithoutTheirFilmsDoNotSuffice) {
  FilmRecipe recipe = film_template();
  recipe.temperature.from = TemperatureSection::From::plates;
  recipe.correction.cold_temperature = 291;
  recipe.correction.warm_temperature = 301;
  EXPECT_EQ(problems_of(to_toml(recipe)).size(), 1u);
}

TEST(FilmRecipe, OneOfACameraNeedsNoPlatesAndReadsBackAsResolved) {
  FilmRecipe recipe = film_template();
  recipe.temperature.from = TemperatureSection::From::plates;
  recipe.camera.emplace();
  recipe.camera->high = "high";
  EXPECT_EQ(to_toml(parse_film_recipe(to_toml(recipe), "film.toml")), to_toml(recipe));
}

TEST(FilmRecipe, EmptyOneNamesTheTemplate) {
  const auto problems = problems_of(" \n");
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_NE(problems[0].message.find("arenite init film"), std::string::npos);
}

TEST(FilmRecipe, OneOfASimulationIsKnownForWhatItIs) {
  const auto problems = problems_of("title = \"a sample\"\n[packing]\ngrains = 10\n[[stages]]\nname = \"load\"\n");
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_NE(problems[0].message.find("arenite run"), std::string::npos);
}

TEST(FilmRecipe, ReferencePageIsUpToDate) {
  std::ifstream file(ARENITE_SOURCE_DIR "/docs/film-recipe.md");
  std::ostringstream page;
  page << file.rdbuf();
  EXPECT_EQ(page.str(), film_key_reference()) << "write it anew: build/arenite man --film-keys > docs/film-recipe.md";
}

}  // namespace
}  // namespace arenite::study
