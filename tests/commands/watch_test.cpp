#include <gtest/gtest.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "support/program.hpp"
#include "support/temporary_folder.hpp"
#include "support/watched_run.hpp"

namespace arenite {
namespace {

namespace fs = std::filesystem;
using test::ask;
using test::Background;
using test::becomes;
using test::connection_to;
using test::Page;
using test::recipe_of;
using test::wait;

double share_of(const nlohmann::json& state) {
  if (!state.is_object() || !state.contains("status") || state["status"]["name"] != "shear") return 0;
  return state["status"]["share"].get<double>();
}

TEST(Watch, ShowsARunAsItGrowsAndStopsIt) {
  const test::TemporaryFolder folder;
  const auto file = folder / "recipe.toml", out = folder / "out";
  std::ofstream(file) << recipe_of("20 s");
  const std::string line = "run " + file.string() + " --quiet --checkpoint-every 0.5 --out " + out.string();
  Background run(line, folder / "run.out", folder / "run.err");
  ASSERT_TRUE(becomes([&] { return fs::exists(out / "status.csv"); })) << test::slurp(folder / "run.err");
  Background watch("watch " + out.string(), folder / "watch.out", folder / "watch.err");
  const Page page(folder / "watch.out");
  ASSERT_GT(page.port, 0) << test::slurp(folder / "watch.out") << test::slurp(folder / "watch.err");

  ASSERT_TRUE(becomes([&] { return share_of(page.state()) > 0; }));
  const double before = share_of(page.state());
  EXPECT_TRUE(becomes([&] { return share_of(page.state()) > before; }));
  const auto state = page.state();
  EXPECT_EQ(state["life"], "running");
  EXPECT_EQ(state["stages"].size(), 2u);
  ASSERT_TRUE(becomes([&] { return page.state()["figures"].size() > 1; }));
  const auto drawn = page.state()["figures"];
  EXPECT_EQ(drawn[0]["sample"]["x"].size(), 60u);
  EXPECT_EQ(drawn[1]["id"], "test-curves");
  const auto points = [](const nlohmann::json& figures) {
    return figures[1]["drawing"]["panels"][0]["series"][0]["x"].size();
  };
  EXPECT_GT(points(drawn), 1u);
  EXPECT_TRUE(becomes([&] { return page.state()["at"] > state["at"]; })) << "the state of now is kept anew";
  EXPECT_NE(page.get("page").text.find("<html"), std::string::npos);
  const auto shown = test::arenite("show " + out.string());
  EXPECT_EQ(shown.out.find("Running: stage 3 of 3, shear"), 0u) << shown.out;
  EXPECT_EQ(test::arenite("watch " + out.string() + " --port " + std::to_string(page.port)).status, 2)
      << "the port is taken";

  EXPECT_EQ(page.post("stop").status, 200);
  EXPECT_EQ(run.status(), 1);
  EXPECT_TRUE(fs::exists(out / "run.checkpoint"));
  EXPECT_EQ(page.state()["life"], "stopped");
  EXPECT_FALSE(fs::exists(out / "run.now"));
  EXPECT_EQ(page.post("stop").status, 409);
  EXPECT_EQ(test::arenite("show " + out.string()).out.find("Stopped: stage 3 of 3, shear"), 0u);
  EXPECT_EQ(watch.end(SIGTERM), 0);
}

TEST(Watch, ARunThatIsWatchedAndStoppedEndsWithTheBytesOfOneThatIsNot) {
  const test::TemporaryFolder folder;
  const auto file = folder / "recipe.toml", out = folder / "out";
  std::ofstream(file) << recipe_of("4 s");
  const std::string line = "run " + file.string() + " --quiet --out ";
  int stops = 0;
  for (int life = 0; life < 20; ++life) {
    const fs::path printed = folder / ("run.err" + std::to_string(life));
    Background run(line + out.string() + " --watch", folder / "run.out", printed);
    const Page page(printed);
    ASSERT_GT(page.port, 0) << test::slurp(printed);
    if (stops < 2 &&
        becomes([&] { return share_of(page.state()) > 0.2 * (stops + 1) || fs::exists(out / "report.html"); }))
      page.post("stop");
    if (run.status() == 0) break;
    ++stops;
  }
  EXPECT_GT(stops, 0);
  ASSERT_TRUE(fs::exists(out / "report.html"));
  EXPECT_FALSE(fs::exists(out / "status.csv"));
  ASSERT_EQ(test::arenite(line + (folder / "alone").string()).status, 0);
  EXPECT_EQ(test::stage_files(out), test::stage_files(folder / "alone"));
}

TEST(Watch, AnswersBesideConnectionsThatSendNothing) {
  const test::TemporaryFolder folder;
  const auto file = folder / "recipe.toml", out = folder / "out";
  std::ofstream(file) << recipe_of("0.01 s");
  ASSERT_EQ(test::arenite("run " + file.string() + " --quiet --out " + out.string()).status, 0);
  Background watch("watch " + out.string(), folder / "watch.out", folder / "watch.err");
  const Page page(folder / "watch.out");
  ASSERT_GT(page.port, 0);
  std::vector<int> silent;
  for (int k = 0; k < 40; ++k) silent.push_back(connection_to(page.port));
  EXPECT_EQ(page.state()["life"], "ended");
  for (const int connection : silent) ::close(connection);
  std::string ranges = "Range: bytes=0-";
  for (int k = 0; k < 300; ++k) ranges += ",0-";
  EXPECT_EQ(ask(page.port, "GET", page.path + "page", page.host, ranges + "\r\n").text, page.get("page").text);
}

TEST(Status, OfARunThatWasKilledSaysThatItsProcessIsGone) {
  const test::TemporaryFolder folder;
  const auto file = folder / "recipe.toml", out = folder / "out";
  std::ofstream(file) << recipe_of("20 s");
  Background run("run " + file.string() + " --quiet --out " + out.string(), folder / "run.out", folder / "run.err");
  ASSERT_TRUE(becomes([&] { return fs::exists(out / "status.csv"); }));
  run.end(SIGKILL);
  const auto shown = test::arenite("show " + out.string());
  EXPECT_EQ(shown.status, 0) << shown.err;
  EXPECT_EQ(shown.out.find("Died: "), 0u) << shown.out;
  EXPECT_FALSE(nlohmann::json::parse(test::arenite("show --json " + out.string()).out)["running"]["alive"].get<bool>());
}

}  // namespace
}  // namespace arenite
