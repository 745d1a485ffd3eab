#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <string>
#include <thread>

#include "support/program.hpp"
#include "support/small_study.hpp"
#include "support/temporary_folder.hpp"

namespace arenite {
namespace {

namespace fs = std::filesystem;

/// Some seconds of work, most of it in the last stage.
std::string recipe_of(const char* duration) {
  return test::small_packing_recipe + R"(solid_fraction = 0.7
[contact]
friction = 0.3
[[stages]]
name = "densify"
right = { pressure = "50 kPa" }
top = { pressure = "50 kPa" }
[[stages]]
name = "shear"
right = { pressure = "50 kPa" }
top = { velocity = "1 mm/s" }
duration = ")" +
         std::string(duration) + "\"\n";
}

void wait(int milliseconds) { std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds)); }

/// Until it is true, or for a minute.
bool becomes(const std::function<bool()>& condition) {
  for (int look = 0; look < 600; ++look, wait(100))
    if (condition()) return true;
  return condition();
}

/// A program of ours in the background, which is gone with this.
class Background {
 public:
  Background(const std::string& arguments, const fs::path& out, const fs::path& err) {
    for (const fs::path& of_an_earlier_one : {out, err}) fs::remove(of_an_earlier_one);
    const std::string line =
        "exec " ARENITE_BINARY " " + arguments + " >" + out.string() + " 2>" + err.string() + " </dev/null";
    process_ = ::fork();
    if (process_ == 0) {
      ::execl("/bin/sh", "sh", "-c", line.c_str(), nullptr);
      ::_exit(127);
    }
  }
  ~Background() {
    if (process_ > 0) end(SIGKILL);
  }
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;
  int status() { return end(0); }  ///< waits for its end
  int end(int signal) {
    if (signal != 0) ::kill(process_, signal);
    int raw = 0;
    ::waitpid(process_, &raw, 0);
    process_ = -1;
    return WIFEXITED(raw) ? WEXITSTATUS(raw) : 128 + WTERMSIG(raw);
  }

 private:
  pid_t process_ = -1;
};

struct Answer {
  int status = 0;
  std::string text;
};

/// -1 where nobody listens.
int connection_to(int port) {
  const int connection = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in to{};
  to.sin_family = AF_INET;
  to.sin_port = htons(static_cast<std::uint16_t>(port));
  to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (::connect(connection, reinterpret_cast<const sockaddr*>(&to), sizeof to) == 0) return connection;
  ::close(connection);
  return -1;
}

/// One request, as it stands.
Answer ask(int port, const std::string& method, const std::string& path, const std::string& host,
           const std::string& more = "") {
  const int connection = connection_to(port);
  std::string all;
  if (connection >= 0) {
    const std::string request = method + " " + path + " HTTP/1.1\r\nHost: " + host + "\r\n" + more +
                                "Connection: close\r\nContent-Length: 0\r\n\r\n";
    if (::send(connection, request.data(), request.size(), MSG_NOSIGNAL) > 0) {
      char part[4096];
      for (ssize_t n = 0; (n = ::recv(connection, part, sizeof part, 0)) > 0;)
        all.append(part, static_cast<std::size_t>(n));
    }
  }
  if (connection >= 0) ::close(connection);
  if (all.size() < 12) return {};
  const auto body = all.find("\r\n\r\n");
  return {std::stoi(all.substr(9, 3)), body == std::string::npos ? "" : all.substr(body + 4)};
}

/// The page of a run by its address.
class Page {
 public:
  /// Waits for the address in what a program prints.
  explicit Page(const fs::path& printed) {
    becomes([&] {
      return test::slurp(printed).find("/\n") != std::string::npos ||
             test::slurp(printed).find("/page\n") != std::string::npos;
    });
    const std::string text = test::slurp(printed), begin = "http://127.0.0.1:";
    const auto at = text.find(begin);
    if (at == std::string::npos) return;
    const auto slash = text.find('/', at + begin.size());
    port = std::stoi(text.substr(at + begin.size(), slash - at - begin.size()));
    path = text.substr(slash, 34);  // with the token's 32 digits
    host = "127.0.0.1:" + std::to_string(port);
  }
  Answer get(const std::string& what) const { return ask(port, "GET", path + what, host); }
  Answer post(const std::string& what, const std::string& more = "") const {
    return ask(port, "POST", path + what, host, more);
  }
  nlohmann::json state() const { return nlohmann::json::parse(get("state").text, nullptr, false); }
  int port = 0;
  std::string path, host;
};

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

TEST(Watch, RefusesWhoLacksTheTokenComesByAnotherNameOrAsksForAnythingElse) {
  const test::TemporaryFolder folder;
  const auto file = folder / "recipe.toml", out = folder / "out";
  std::ofstream(file) << recipe_of("0.01 s");
  ASSERT_EQ(test::arenite("run " + file.string() + " --quiet --out " + out.string()).status, 0);
  Background watch("watch " + out.string(), folder / "watch.out", folder / "watch.err");
  const Page page(folder / "watch.out");
  ASSERT_GT(page.port, 0);
  EXPECT_EQ(test::slurp(folder / "watch.out").find("the run in " + out.string() + " has ended"), 0u);

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
  const test::TemporaryFolder folder;
  const Bystander bystander;
  // The second is -1 where it is cut to the 32 bits of a process number.
  for (const long named : {static_cast<long>(bystander.process), 0xffffffffL}) {
    std::ofstream(folder / "status.csv") << status_naming(named);
    Background watch("watch " + folder.path().string(), folder / "watch.out", folder / "watch.err");
    const Page page(folder / "watch.out");
    ASSERT_GT(page.port, 0) << test::slurp(folder / "watch.err");
    EXPECT_EQ(page.state()["life"], "died");
    EXPECT_EQ(page.post("stop").status, 409);
    EXPECT_EQ(watch.end(SIGTERM), 0);
  }
  int ended = 0;
  EXPECT_EQ(::waitpid(bystander.process, &ended, WNOHANG), 0) << "it was signalled";
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

TEST(Run, ASecondOneIntoTheSameFolderIsRefused) {
  const test::TemporaryFolder folder;
  const auto file = folder / "recipe.toml", other = folder / "other.toml", out = folder / "out";
  std::ofstream(file) << recipe_of("20 s");
  std::ofstream(other) << recipe_of("10 s");
  const auto line = [&](const fs::path& recipe) { return "run " + recipe.string() + " --quiet --out " + out.string(); };
  Background run(line(file), folder / "run.out", folder / "run.err");
  ASSERT_TRUE(becomes([&] { return fs::exists(out / "status.csv"); }));
  const auto second = test::arenite(line(other));
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
