#include "recipe/film_recipe.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "core/error.hpp"

namespace arenite::recipe {
namespace {

std::vector<Problem> problems_of(const std::string& text) {
  try {
    parse_film_recipe(text, "film.toml");
  } catch (const InputError& error) { return error.problems(); }
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
      "[materials.POM]\nthermoelastic_factor = \"0.015 K\"\n[frame]\nwidth = 350\nheight = \"350 mm\"\nthickness = "
      "\"60 mm\"\n"
      "[picture]\npixels = \"1.6 mm\"\n[lockin]\nfrequency = \"-3 Hz\"\n[temperature]\nfrom = \"film\"\n");
  ASSERT_GE(problems.size(), 5u);
  EXPECT_EQ(problems[0].line, 2);
}

TEST(FilmRecipe, PlatesNeedTheirTemperatures) {
  FilmRecipe recipe = film_template();
  recipe.temperature.from = TemperatureSection::From::references;
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
  EXPECT_NE(problems[0].message.find("temperature: from is \"references\" unless given, and needs correction.cold"),
            std::string::npos)
      << problems[0].message;
}

TEST(FilmRecipe, TemperaturesOfPlatesWithoutTheirFilmsDoNotSuffice) {
  FilmRecipe recipe = film_template();
  recipe.temperature.from = TemperatureSection::From::references;
  recipe.correction.cold_temperature = 291;
  recipe.correction.warm_temperature = 301;
  EXPECT_EQ(problems_of(to_toml(recipe)).size(), 1u);
}

TEST(FilmRecipe, OneOfACameraNeedsNoPlatesAndReadsBackAsResolved) {
  FilmRecipe recipe = film_template();
  recipe.temperature.from = TemperatureSection::From::references;
  recipe.camera.emplace();
  recipe.camera->high = "high";
  EXPECT_EQ(to_toml(parse_film_recipe(to_toml(recipe), "film.toml")), to_toml(recipe));
}

/// The template with these lines at the end of its section [temperature], or of that of POM.
std::string with_lines(const std::string& section, const std::string& lines) {
  std::string text = to_toml(film_template());
  const auto at = text.find('\n', text.find("[" + section + "]"));
  return text.insert(at + 1, lines);
}

TEST(FilmRecipe, EmissivitiesThatNothingReadsAreRefusedWithTheirPlace) {
  for (const auto& text :
       {with_lines("materials.POM", "emissivity = 0.95\n"), with_lines("temperature", "ambient = \"291 K\"\n"),
        with_lines("temperature", "band = [\"8 um\", \"12 um\"]\n")}) {
    const auto problems = problems_of(text);
    ASSERT_EQ(problems.size(), 1u) << text;
    EXPECT_GT(problems[0].line, 0);
    EXPECT_NE(problems[0].message.find("assumed_emissivity"), std::string::npos) << problems[0].message;
  }
  EXPECT_TRUE(problems_of(with_lines("temperature", "assumed_emissivity = 1\nemissivity = 0.95\nambient = \"291 K\"\n"))
                  .empty());
  std::string twice = with_lines("materials.POM", "emissivity = 0.95\n");
  twice.insert(twice.find('\n', twice.find("[materials.HDPE]")) + 1, "emissivity = 0.8\n");
  twice.insert(twice.find('\n', twice.find("[temperature]")) + 1, "assumed_emissivity = 1\nemissivity = 0.9\n");
  const auto problems = problems_of(twice);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_NE(problems[0].message.find("every material has one"), std::string::npos) << problems[0].message;
}

TEST(FilmRecipe, ABandIsTwoWavelengths) {
  for (const char* band : {"[\"8 um\"]", "[\"12 um\", \"8 um\"]", "[\"1 um\", \"2 um\", \"3 um\"]"})
    EXPECT_EQ(
        problems_of(with_lines("temperature", std::string("assumed_emissivity = 1\nband = ") + band + "\n")).size(), 1u)
        << band;
}

TEST(FilmRecipe, APhaseIsAnAngleWithItsUnit) {
  const auto recipe = parse_film_recipe(with_lines("lockin", "phase = \"90 deg\"\n"), "film.toml");
  EXPECT_NEAR(recipe.lockin.phase.value_or(0), 1.5707963267948966, 1e-15);
  EXPECT_NE(to_toml(recipe).find("phase = \"90 deg\""), std::string::npos) << to_toml(recipe);
  EXPECT_EQ(to_toml(parse_film_recipe(to_toml(recipe), "film.toml")), to_toml(recipe));
  const auto problems = problems_of(with_lines("lockin", "phase = 0.25\n"));
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_NE(problems[0].message.find("\"90 deg\""), std::string::npos) << problems[0].message;
}

TEST(FilmRecipe, SaysWhatAFilmDoesNotSay) {
  const auto recipe = parse_film_recipe(
      to_toml(film_template()) + "\n[film]\nframe_rate = \"148 Hz\"\nscale = \"10 mK\"\noffset = \"-273.15 K\"\n",
      "film.toml");
  ASSERT_TRUE(recipe.film);
  EXPECT_EQ(recipe.film->frame_rate, 148);
  EXPECT_DOUBLE_EQ(recipe.film->scale.value_or(0), 0.01);
  EXPECT_DOUBLE_EQ(recipe.film->offset.value_or(0), -273.15);
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
}  // namespace arenite::recipe
