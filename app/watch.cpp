#include <fmt/core.h>

#include <cstdio>
#include <filesystem>
#include <memory>

#include "commands.hpp"
#include "core/error.hpp"
#include "print.hpp"
#include "progress.hpp"
#include "run_status.hpp"
#include "watch_server.hpp"

namespace arenite::app {
namespace {

struct WatchArguments {
  std::string folder;
  int port = 0;
};

void watch(const WatchArguments& a) {
  const bool runs = read_run_status(a.folder).has_value();
  if (!runs) refuse_no_result(a.folder);
  if (!std::filesystem::is_directory(a.folder))
    throw InputError(a.folder, 0, "is not a folder; give the one that `arenite run` writes");
  watch_for_signals();
  const auto tell = [&](const std::string& url) {
    if (!runs) print("the run in {} has ended; its page: ", a.folder);
    print("{}{}\n", url, runs ? "" : "page");
    std::fflush(stdout);
  };
  serve_watch(a.folder, a.port, tell, stop_requested);
}

}  // namespace

void add_watch(Options& command, int&) {
  const auto arguments = std::make_shared<WatchArguments>();
  command.add("folder", arguments->folder, "Folder of a run, in progress or ended").required().type("FOLDER");
  command.add("--port", arguments->port, "Port on the loopback address (default: a free one)")
      .between(1, 65535)
      .type("N");
  command.work = [arguments] { watch(*arguments); };
}

}  // namespace arenite::app
