#include <gtest/gtest.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include <csignal>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "support/program.hpp"
#include "support/small_spheres.hpp"
#include "support/watched_run.hpp"

namespace arenite {
namespace {

namespace fs = std::filesystem;
using test::ask;
using test::Background;
using test::becomes;
using test::connection_to;
using test::Page;
using test::WatchedRun;

double share_of(const nlohmann::json& state) {
  if (!state.is_object() || !state.contains("status") || state["status"]["name"] != "shear") return 0;
  return state["status"]["share"].get<double>();
}

TEST(Watch, ShowsARunAsItGrowsAndStopsIt) {
  const WatchedRun watched("20 s");
  const fs::path& out = watched.out;
  Background run = watched.begin(" --checkpoint-every 0.5");
  ASSERT_TRUE(watched.begins()) << watched.printed();
  Background watch = watched.watch();
  const Page page = watched.page();
  ASSERT_GT(page.port, 0) << watched.printed();

  ASSERT_TRUE(becomes([&] { return share_of(page.state()) > 0; }));
  const double before = share_of(page.state());
  EXPECT_TRUE(becomes([&] { return share_of(page.state()) > before; }));
  const auto state = page.state();
  EXPECT_EQ(state["life"], "running");
  EXPECT_EQ(state["stages"].size(), 2u);
  nlohmann::json drawn;
  ASSERT_TRUE(becomes([&] {
    drawn = page.state()["figures"];
    return drawn.size() > 1 && drawn[1]["id"] == "test-curves";
  })) << "a curve wants two samples of a stage; the newest forces are drawn from the first";
  EXPECT_EQ(drawn[0]["sample"]["x"].size(), 60u);
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

TEST(Watch, ShowsSpheresAsTheyAreNow) {
  std::string recipe = test::small_triaxial;
  for (const auto& [what, slowly] : {std::pair{"20 mm/s", "0.1 mm/s"}, {"0.06 s", "20 s"}})
    recipe.replace(recipe.find(what), std::string(what).size(), slowly);
  const WatchedRun watched(recipe);
  Background run = watched.begin(" --checkpoint-every 0.5");
  ASSERT_TRUE(watched.begins()) << watched.printed();
  Background watch = watched.watch();
  const Page page = watched.page();
  ASSERT_GT(page.port, 0) << watched.printed();
  nlohmann::json state;
  ASSERT_TRUE(becomes([&] {
    state = page.state();
    return state["figures"].size() > 1 && state["figures"][1]["id"] == "test-curves";
  })) << "of the stage that closes along one axis";
  const auto drawn = state["figures"];
  EXPECT_EQ(drawn[0]["spheres"]["states"][0]["count"], 150);
  EXPECT_EQ(drawn[0]["spheres"]["states"][0]["forces"]["fn"]["as"], "f4");
  EXPECT_FALSE(drawn[0]["block"].get<std::string>().empty());
  EXPECT_EQ(state["stages"][1]["name"], "confine");
  EXPECT_TRUE(becomes([&] { return page.state()["at"] > state["at"]; })) << "the state of now is kept anew";
  EXPECT_EQ(page.post("stop").status, 200);
  EXPECT_EQ(run.status(), 1);
  EXPECT_FALSE(fs::exists(watched.out / "run.now"));
  EXPECT_EQ(watch.end(SIGTERM), 0);
}

TEST(Watch, ARunThatIsWatchedAndStoppedEndsWithTheBytesOfOneThatIsNot) {
  const WatchedRun watched("4 s");
  const fs::path& out = watched.out;
  int stops = 0;
  for (int life = 0; life < 20; ++life) {
    Background run = watched.begin(" --watch");
    const Page page(watched.folder / "run.err");
    ASSERT_GT(page.port, 0) << watched.printed();
    if (stops < 2 &&
        becomes([&] { return share_of(page.state()) > 0.2 * (stops + 1) || fs::exists(out / "report.html"); }))
      page.post("stop");
    if (run.status() == 0) break;
    ++stops;
  }
  EXPECT_GT(stops, 0);
  ASSERT_TRUE(fs::exists(out / "report.html"));
  EXPECT_FALSE(fs::exists(out / "status.csv"));
  const fs::path alone = watched.folder / "alone";
  ASSERT_EQ(test::arenite(watched.line(alone)).status, 0);
  EXPECT_EQ(test::stage_files(out), test::stage_files(alone));
}

TEST(Watch, AnswersBesideConnectionsThatSendNothing) {
  const WatchedRun watched("0.01 s");
  ASSERT_EQ(test::arenite(watched.line()).status, 0);
  const Background watch = watched.watch();
  const Page page = watched.page();
  ASSERT_GT(page.port, 0) << watched.printed();
  std::vector<int> silent;
  for (int k = 0; k < 40; ++k) silent.push_back(connection_to(page.port));
  EXPECT_EQ(page.state()["life"], "ended");
  for (const int connection : silent) ::close(connection);
  std::string ranges = "Range: bytes=0-";
  for (int k = 0; k < 300; ++k) ranges += ",0-";
  EXPECT_EQ(ask(page.port, "GET", page.path + "page", page.host, ranges + "\r\n").text, page.get("page").text);
}

TEST(Status, OfARunThatWasKilledSaysThatItsProcessIsGone) {
  const WatchedRun watched("20 s");
  const fs::path& out = watched.out;
  Background run = watched.begin();
  ASSERT_TRUE(watched.begins()) << watched.printed();
  run.end_as_zombie();
  const auto shown = test::arenite("show " + out.string());
  EXPECT_EQ(shown.status, 0) << shown.err;
  EXPECT_EQ(shown.out.find("Died: "), 0u) << shown.out;
  run.end(SIGKILL);
  EXPECT_FALSE(nlohmann::json::parse(test::arenite("show --json " + out.string()).out)["running"]["alive"].get<bool>());
}

}  // namespace
}  // namespace arenite
