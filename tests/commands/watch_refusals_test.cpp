#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>

#include "support/program.hpp"
#include "support/temporary_folder.hpp"
#include "support/watched_run.hpp"

namespace arenite {
namespace {

namespace fs = std::filesystem;
using test::ask;
using test::Background;
using test::Page;
using test::WatchedRun;

TEST(Watch, RefusesWhoLacksTheTokenComesByAnotherNameOrAsksForAnythingElse) {
  const WatchedRun watched("0.01 s");
  ASSERT_EQ(test::arenite(watched.line()).status, 0);
  const Background watch = watched.watch();
  const Page page = watched.page();
  ASSERT_GT(page.port, 0) << watched.printed();
  EXPECT_EQ(test::slurp(watched.folder / "watch.out").find("the run in " + watched.out.string() + " has ended"), 0u);

  EXPECT_EQ(page.get("").status, 200);
  EXPECT_EQ(page.state()["life"], "ended");
  EXPECT_NE(page.get("page").text.find("<html"), std::string::npos);
  for (const std::string path : {"/", "/state", "//state", "/00000000000000000000000000000000/state", "/..", ""})
    EXPECT_EQ(ask(page.port, "GET", path.empty() ? page.path.substr(0, 20) : path, page.host).status, 403) << path;
  for (const std::string& host :
       {std::string("example.org"), std::string("127.0.0.1"), "evil.localhost:" + std::to_string(page.port)})
    EXPECT_EQ(ask(page.port, "GET", page.path, host).status, 403) << host;
  EXPECT_EQ(ask(page.port, "GET", page.path, "localhost:" + std::to_string(page.port)).status, 200);
  EXPECT_EQ(page.get("../recipe.toml").status, 404);
  EXPECT_EQ(page.get("stop").status, 404);
  EXPECT_EQ(page.post("state").status, 405);
  EXPECT_EQ(ask(page.port, "DELETE", page.path, page.host).status, 405);
  EXPECT_EQ(page.post("stop", "Origin: http://example.org\r\n").status, 403);
  EXPECT_EQ(page.post("stop").status, 409) << "nothing runs";
}

/// A status as a run writes it, with this process and host.
std::string status_naming(long process) {
  char host[256] = {};
  ::gethostname(host, sizeof host - 1);
  std::string text = "name,value\n";
  for (const char* cell : {"stage,1", "stages,2", "name,shear", "share,0.5", "step,7", "unbalanced_ratio,0.1",
                           "field,false", "key,k", "increment,1", "increments,1", "time_s,1", "stopped,false",
                           "began,1", "stage_began,1", "heard,1", "seconds_left,unknown", "process_start,"})
    text += std::string(cell) + "\n";
  return text + "process," + std::to_string(process) + "\nhost," + host + "\n";
}

/// A process that does nothing, and is gone with this.
class Bystander {
 public:
  Bystander() : process(::fork()) {
    if (process != 0) return;
    ::pause();
    ::_exit(0);
  }
  ~Bystander() {
    ::kill(process, SIGKILL);
    ::waitpid(process, nullptr, 0);
  }
  Bystander(const Bystander&) = delete;
  Bystander& operator=(const Bystander&) = delete;
  const pid_t process;
};

TEST(Watch, StopsNoProcessThatAFileNames) {
  const WatchedRun watched("1 s");  // which does not begin
  const Bystander bystander;
  // The second is -1 where it is cut to the 32 bits of a process number.
  for (const long named : {static_cast<long>(bystander.process), 0xffffffffL}) {
    std::ofstream(watched.folder / "status.csv") << status_naming(named);
    Background watch = watched.watch(watched.folder.path());
    const Page page = watched.page();
    ASSERT_GT(page.port, 0) << watched.printed();
    EXPECT_EQ(page.state()["life"], "died");
    EXPECT_EQ(page.post("stop").status, 409);
    EXPECT_EQ(watch.end(SIGTERM), 0);
  }
  int ended = 0;
  EXPECT_EQ(::waitpid(bystander.process, &ended, WNOHANG), 0) << "it was signalled";
}

TEST(Run, ASecondOneIntoTheSameFolderIsRefused) {
  const WatchedRun watched("20 s"), other("10 s");
  const fs::path& out = watched.out;
  Background run = watched.begin();
  ASSERT_TRUE(watched.begins()) << watched.printed();
  const auto second = test::arenite(other.line(out));
  EXPECT_EQ(second.status, 2);
  EXPECT_NE(second.err.find("another run writes into this folder"), std::string::npos) << second.err;
  EXPECT_FALSE(fs::exists(out / "earlier"));
  EXPECT_TRUE(fs::exists(out / "status.csv")) << "of the first run";
  EXPECT_EQ(run.end(SIGTERM), 1);
}

TEST(Watch, OfWhatIsNoResultIsBadInput) {
  const test::TemporaryFolder folder;
  fs::create_directory(folder / "empty");
  for (const auto& path : {folder / "none", folder / "empty"})
    EXPECT_EQ(test::arenite("watch " + path.string()).status, 2) << path;
}

}  // namespace
}  // namespace arenite
