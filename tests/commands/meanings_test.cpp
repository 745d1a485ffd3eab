#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "campaign/collect.hpp"
#include "io/film/film.hpp"
#include "recipe/recipe.hpp"
#include "report/film_text.hpp"
#include "report/summary/summary.hpp"
#include "support/filmed_study.hpp"
#include "support/small_study.hpp"
#include "support/virtual_film.hpp"
#include "workflow/identify/identify_curves.hpp"
#include "workflow/predict.hpp"

namespace {
using namespace arenite;
using test::arenite;
using test::TemporaryFolder;
namespace fs = std::filesystem;

const std::string examples = ARENITE_SOURCE_DIR "/examples/";

/// What needs no meaning of its own, and why. Lists need none either: they are curves, with their axes beside them, or
/// rows by grain.
const std::map<std::string, const char*> excused{{"provenance", "what made the result"},
                                                 {"options", "what was asked for"},
                                                 {"cavity_rules", "what was asked for"},
                                                 {"stated", "what a source says"},
                                                 {"rev", "curves with their axes"}};

/// Names of the numbers and truths without a meaning; how many numbers there are.
std::size_t look(const Numbers& node, const std::string& name, const Meaning* of_group, std::string& without) {
  const Meaning* meaning = node.meaning() ? node.meaning() : of_group;
  if (node.is_number() || node.is_truth() || (node.is_tree() && node.contains("value"))) {
    if (!meaning || meaning->sentence.empty()) without += name + " ";
    return 1;
  }
  std::size_t count = 0;
  for (const auto& [own, item] : node.items())
    if (!excused.contains(own)) count += look(item, name.empty() ? own : name + "." + own, meaning, without);
  for (const Numbers& item : node)
    if (node.is_list() && item.is_tree()) count += look(item, name, meaning, without);
  return count;
}

std::string without_meaning(const Numbers& numbers) {
  std::string without;
  EXPECT_GT(look(numbers, "", nullptr, without), 3u);
  return without;
}

/// Of what is stored, so of what files keep.
Numbers numbers_of_run(const std::string& recipe, const std::string& settings) {
  const TemporaryFolder folder;
  const auto ran = arenite("run " + examples + recipe + " --quiet --out " + folder.path().string() + settings);
  EXPECT_TRUE(ran.status == 0 || ran.status == 3) << ran.err;
  return report::Summary(folder.path()).numbers();
}

TEST(Meanings, OfGrainsThatFlowThroughAnOpening) {
  const Numbers silo =
      numbers_of_run("12-silo/recipe.toml", " --set populations.0.count=120 --set 'stages.1.duration=\"0.6 s\"'");
  EXPECT_TRUE(silo.contains("discharge")) << to_json(silo);
  EXPECT_EQ(without_meaning(silo), "");
}

TEST(Meanings, OfGrainsThatCohereAndAreDrawnApart) {
  const Numbers wet =
      numbers_of_run("19-wet-grains/recipe.toml", " --set populations.0.count=60 --set 'container.width=\"20 mm\"'");
  EXPECT_TRUE(wet.contains("cohesion")) << to_json(wet);
  EXPECT_EQ(without_meaning(wet), "");
}

TEST(Meanings, OfASampleThatIsShearedToItsCriticalState) {
  EXPECT_EQ(without_meaning(numbers_of_run("05-biaxial-test/recipe.toml", " --set packing.grains=200")), "");
}

TEST(Meanings, OfALoadedCementedSample) {
  for (const char* cement : {"", " --set cement.kind=menisci --set cement.saturation=0.2"}) {
    const Numbers loaded = numbers_of_run(
        "07-cemented-packing/recipe.toml",
        " --set bidisperse.box_area=60 --set grid.nodes=96 --set 'grid.crop=\"8 mm\"' --set loads.0.moduli=true" +
            std::string(cement));
    EXPECT_TRUE(loaded.contains("stress"));
    EXPECT_EQ(without_meaning(loaded), "") << cement;
  }
}

TEST(Meanings, OfATestToFailure) {
  const Numbers broken = numbers_of_run("08-failure/recipe.toml",
                                        " --set bidisperse.box_area=30 --set grid.nodes=48 --set 'grid.crop=\"5 mm\"'");
  EXPECT_TRUE(broken.contains("strength_Pa"));
  EXPECT_EQ(without_meaning(broken), "");
}

TEST(Meanings, OfAFilmAndOfItsAgreementWithTheSimulation) {
  const test::VirtualFilm example;
  example.edit(
      "compared.toml", "[picture]",
      "[simulation]\nrecipe = \"" + example.states() + "/recipe.toml\"\nlow = \"low\"\nhigh = \"high\"\n\n[picture]");
  ASSERT_EQ(example.film("", "film", "compared.toml").status, 0);
  Numbers film = report::Summary(example.at("result")).numbers();
  EXPECT_EQ(without_meaning(film), "");
  EXPECT_EQ(without_meaning(report::film_summary(*io::open_film(example.at("film/film.ptw")))), "");
  const test::FilmedStudy study(example);
  ASSERT_TRUE(study.make());
  EXPECT_EQ(without_meaning(campaign::film_numbers(study.folder())), "");
}

TEST(Meanings, OfAPredictionAndOfWhatTestsOfTheLaboratoryGive) {
  EXPECT_EQ(without_meaning(
                workflow::numbers(workflow::predict(recipe::parse_recipe(test::small_cemented_recipe, "recipe.toml")))),
            "");
  const auto found = workflow::identify_adhesion(examples + "data/thesis-identification/separation-force.csv", {});
  EXPECT_EQ(without_meaning(identify::numbers(found)), "");
}

TEST(Meanings, OfEveryColumnThatAStudyCollects) {
  const TemporaryFolder folder;
  std::ofstream(folder / "study.toml") << test::small_study;
  const auto out = folder / "out", file = folder / "study.toml";
  ASSERT_EQ(arenite("study run " + file.string() + " --quiet --out " + out.string()).status, 0);
  const auto study = campaign::read_study(file.string(), {}, out);
  const auto table = campaign::collect(study, campaign::StudyFolder(out));
  ASSERT_GT(table.names.size(), 100u);
  std::string without;
  for (const auto& name : table.names)
    if (!table.meanings.contains(name) &&
        std::ranges::none_of(excused, [&](const auto& part) { return test::contains(name, part.first); }))
      without += name + " ";
  EXPECT_EQ(without, "");
  EXPECT_TRUE(test::contains(table.csv(), ",texture.stress.0.0 [Pa],")) << table.csv().substr(0, 2000);
}

}  // namespace
