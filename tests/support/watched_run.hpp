#pragma once
#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <thread>

#include "support/program.hpp"
#include "support/small_study.hpp"
#include "support/temporary_folder.hpp"

/// A run in the background, and the page by which it is watched.
namespace arenite::test {

/// Some seconds of work, most of it in the last stage.
inline std::string recipe_of(const char* duration) {
  return small_packing_recipe + R"(solid_fraction = 0.7
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

inline void wait(int milliseconds) { std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds)); }

/// Until it is true, or for three minutes: runs with sanitizers take twenty times as long.
inline bool becomes(const std::function<bool()>& condition) {
  for (int look = 0; look < 1800; ++look, wait(100))
    if (condition()) return true;
  return condition();
}

/// A program of ours in the background, which is gone with this.
class Background {
 public:
  Background(const std::string& arguments, const std::filesystem::path& out, const std::filesystem::path& err) {
    for (const std::filesystem::path& of_an_earlier_one : {out, err}) std::filesystem::remove(of_an_earlier_one);
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
  /// Ended, but nobody has asked for its end yet.
  void end_as_zombie() {
    ::kill(process_, SIGKILL);
    siginfo_t ended{};
    ::waitid(P_PID, static_cast<id_t>(process_), &ended, WEXITED | WNOWAIT);
  }

 private:
  pid_t process_ = -1;
};

struct Answer {
  int status = 0;
  std::string text;
};

/// -1 where nobody listens.
inline int connection_to(int port) {
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
inline Answer ask(int port, const std::string& method, const std::string& path, const std::string& host,
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
  explicit Page(const std::filesystem::path& printed) {
    becomes([&] {
      return slurp(printed).find("/\n") != std::string::npos || slurp(printed).find("/page\n") != std::string::npos;
    });
    const std::string text = slurp(printed), begin = "http://127.0.0.1:";
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

/// A folder with a recipe, the run of it in the background or to its end, and the page by which it is watched.
class WatchedRun {
 public:
  explicit WatchedRun(const char* duration) : WatchedRun(recipe_of(duration)) {}
  explicit WatchedRun(const std::string& recipe) { std::ofstream(folder / "recipe.toml") << recipe; }
  /// The command that runs it, quietly, into that folder.
  std::string line(const std::filesystem::path& into) const {
    return "run " + (folder / "recipe.toml").string() + " --quiet --out " + into.string();
  }
  std::string line() const { return line(out); }
  Background begin(const std::string& more = "") const {
    return Background(line() + more, folder / "run.out", folder / "run.err");
  }
  /// Whether a run has begun that can be watched.
  bool begins() const {
    return becomes([&] { return std::filesystem::exists(out / "status.csv"); });
  }
  Background watch() const { return watch(out); }
  Background watch(const std::filesystem::path& what) const {
    return Background("watch " + what.string(), folder / "watch.out", folder / "watch.err");
  }
  Page page() const { return Page(folder / "watch.out"); }
  std::string printed() const {
    std::string all;
    for (const char* file : {"run.err", "watch.out", "watch.err"}) all += slurp(folder / file);
    return all;
  }

  const TemporaryFolder folder{};
  const std::filesystem::path out = folder / "out";
};

}  // namespace arenite::test
