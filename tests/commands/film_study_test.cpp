#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <tuple>

#include "io/disk/store_file.hpp"
#include "support/program.hpp"
#include "support/virtual_film.hpp"

namespace {

namespace fs = std::filesystem;
using namespace arenite;
using Json = nlohmann::json;

/// A film and its recipe, beside which studies of it stand.
class FilmStudy : public testing::Test {
 protected:
  static const test::VirtualFilm& virtual_film() {
    static const test::VirtualFilm made;
    return made;
  }
  /// A study of the film's recipe with these lines, under this name.
  static std::string study(const std::string& name, const std::string& lines) {
    const fs::path file = virtual_film().at("film/" + name + ".toml");
    std::ofstream(file) << "base = \"film.toml\"\n" + lines;
    return file.string();
  }
  static test::Outcome act(const std::string& what, const std::string& recipe, const std::string& out,
                           const std::string& more = "") {
    return test::arenite("study " + what + " " + recipe + " --out " + virtual_film().at(out).string() + " " + more);
  }
};

const std::string of_film = "[film]\nfile = \"film.ptw\"\n";
const std::string two_blurs = of_film + "[sweep.grid]\n\"forces.blur\" = [0.3, 0.6]\n";

TEST_F(FilmStudy, MeasuresAFilmUnderEachChoiceAsTheCommandDoes) {
  ASSERT_EQ(virtual_film().filmed.status, 0) << virtual_film().filmed.err;
  const std::string recipe = study("blurs", two_blurs);
  const auto checked = test::arenite("check " + recipe);
  EXPECT_EQ(checked.status, 0) << checked.err;
  EXPECT_TRUE(test::contains(checked.out, "2 runs of forces.blur")) << checked.out;
  const auto run = act("run", recipe, "blurs", "--quiet --jobs 1");
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(test::contains(run.out, "2 runs: 2 done")) << run.out;
  EXPECT_TRUE(test::contains(test::slurp(virtual_film().at("blurs/study.html")), "Mean normal force"));

  const auto collected = act("collect", recipe, "blurs");
  ASSERT_EQ(collected.status, 0) << collected.err;
  const std::string table = test::slurp(virtual_film().at("blurs/numbers.csv"));
  EXPECT_TRUE(test::contains(table, "forces.blur")) << table.substr(0, 200);
  EXPECT_TRUE(test::contains(table, "forces.mean_N")) << table.substr(0, 2000);

  // The same names and bytes as of single commands, which know nothing of studies.
  for (const std::string blur : {"0.3", "0.6"}) {
    const auto alone = virtual_film().film("--set forces.blur=" + blur);
    ASSERT_EQ(alone.status, 0) << alone.err;
    const fs::path file = io::stage_files(virtual_film().at("result")).front();
    int found = 0;
    for (const auto& entry : fs::directory_iterator(virtual_film().at("blurs/runs"))) {
      const fs::path same = entry.path() / file.filename();
      if (!fs::exists(same)) continue;
      ++found;
      const Json numbers = Json::parse(test::slurp(entry.path() / "numbers.json"));
      const Json shown = Json::parse(test::arenite("show " + file.string() + " --json").out);
      EXPECT_EQ(numbers["forces"], (shown.contains("films") ? shown["films"][0] : shown)["forces"]) << shown.dump(1);
    }
    EXPECT_EQ(found, 1) << blur << ": " << file;
  }
}

TEST_F(FilmStudy, DoesAgainOnlyWhatChanged) {
  const auto written = [&](const std::string& out) {
    std::map<std::string, fs::file_time_type> files;
    for (const auto& entry : fs::directory_iterator(virtual_film().at(out + "/runs")))
      files[entry.path().filename().string()] = fs::last_write_time(entry.path() / "numbers.json");
    return files;
  };
  const std::string recipe = study("again", two_blurs);
  ASSERT_EQ(act("run", recipe, "again", "--quiet --jobs 1").status, 0);
  const auto before = written("again");
  ASSERT_EQ(before.size(), 2u);
  study("again", of_film + "[sweep.grid]\n\"forces.blur\" = [0.3, 0.6, 0.9]\n");
  ASSERT_EQ(act("run", recipe, "again", "--quiet --jobs 1").status, 0);
  const auto after = written("again");
  EXPECT_EQ(after.size(), 3u);
  for (const auto& [run, time] : before) EXPECT_EQ(after.at(run), time) << run;
}

TEST_F(FilmStudy, SharesItsRunsWithOtherStudiesAndKnowsWhatTheyCost) {
  const std::string shared = "--store " + virtual_film().at("shared").string();
  const std::string first = study("first", two_blurs),
                    second = study("second", of_film + "[sweep.grid]\n\"forces.blur\" = [0.6, 0.9]\n");
  const auto plan = act("plan", first, "first", shared);
  EXPECT_TRUE(test::contains(plan.out, "not known until the first run has ended")) << plan.out;
  ASSERT_EQ(act("run", first, "first", "--quiet --jobs 1 " + shared).status, 0);
  const auto next = act("plan", second, "second", shared);
  EXPECT_TRUE(test::contains(next.out, "of CPU time left")) << next.out;
  const std::string film_line = next.out.substr(next.out.find("\nfilm ") + 1);
  std::istringstream columns(film_line);
  std::string name;
  int wanted = 0, different = 0, there = 0;
  columns >> name >> wanted >> different >> there;
  EXPECT_EQ(std::tuple(wanted, different, there), std::tuple(2, 2, 1)) << next.out;
  const auto run = act("run", second, "second", "--quiet --jobs 1 " + shared);
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(test::contains(run.out, "store: 3 stages computed")) << run.out;
  EXPECT_TRUE(test::contains(run.out, "; 1 reused")) << run.out;
}

TEST_F(FilmStudy, OfWhatCannotBeMeasuredIsRefusedBeforeAFolderIsMade) {
  const auto refused = [&](const std::string& lines, const std::string& sentence) {
    const auto done = act("run", study("refused", lines), "refused", "--quiet");
    EXPECT_EQ(done.status, 2) << lines;
    EXPECT_TRUE(test::contains(done.err, sentence)) << done.err;
    EXPECT_FALSE(fs::exists(virtual_film().at("refused")));
  };
  refused("[sweep.grid]\n\"forces.blur\" = [0.3]\n", "names no film; give it as [film] file = ");
  refused(of_film + "[sweep.grid]\n\"forces.blur\" = [-1]\n", "forces.blur");
  refused(of_film + "[sweep.grid]\n\"forces.blurr\" = [0.3]\n", "did you mean blur");
  refused(of_film + "[sweep]\nreplicates = 3\n", "a film is measured alike with any seed");
  refused("[film]\nfile = \"none.ptw\"\n[sweep.grid]\n\"forces.blur\" = [0.3]\n", "none.ptw");
}

TEST_F(FilmStudy, TheRecipeNamesTheFilmToTheCommandToo) {
  const std::string recipe = study("alone", of_film);
  const auto done = test::arenite("film --recipe " + recipe + " --quiet --out " + virtual_film().at("alone").string());
  ASSERT_EQ(done.status, 0) << done.err;
  ASSERT_EQ(virtual_film().film().status, 0);
  EXPECT_EQ(io::stage_files(virtual_film().at("alone")).front().filename(),
            io::stage_files(virtual_film().at("result")).front().filename())
      << "where a film lies changes nothing";
  const auto unnamed = test::arenite("film --recipe " + virtual_film().at("film/film.toml").string() + " --quiet");
  EXPECT_EQ(unnamed.status, 2);
  EXPECT_TRUE(test::contains(unnamed.err, "names no film")) << unnamed.err;
  const auto swept = test::arenite("film --recipe " + study("swept", two_blurs) + " --quiet");
  EXPECT_EQ(swept.status, 2);
  EXPECT_TRUE(test::contains(swept.err, "is a study of many runs")) << swept.err;
}

}  // namespace
