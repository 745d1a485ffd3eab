#include "io/disk/store_file.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <vector>

#include "io/disk/file.hpp"
#include "support/temporary_folder.hpp"

namespace arenite::io {
namespace {

std::vector<std::string> lines_in(const std::filesystem::path& folder) {
  std::vector<std::string> lines;
  read_log(folder, [&](std::string_view line) { lines.emplace_back(line); });
  return lines;
}

TEST(AppendLog, KeepsItsLinesWithoutBreaks) {
  const test::TemporaryFolder folder;
  {
    const AppendLog log(folder.path());
    log.add("one");
    log.add("two\nlines");
  }
  EXPECT_EQ(lines_in(folder.path()), (std::vector<std::string>{"one", "two lines"}));
}

/// What becomes of a file that may hold `bytes` at most, in a process of its own: as on a disk that is full.
int with_room_for(rlim_t bytes, int (*work)(const std::filesystem::path&), const std::filesystem::path& folder) {
  const pid_t child = ::fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{bytes, bytes};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    ::_exit(work(folder));
  }
  int raw = 0;
  ::waitpid(child, &raw, 0);
  return WIFEXITED(raw) ? WEXITSTATUS(raw) : -1;
}

TEST(AppendLog, TellsOnceThatLinesAreLost) {
  const test::TemporaryFolder folder;
  const int told = with_room_for(
      10,
      [](const std::filesystem::path& where) {
        int count = 0;
        const AppendLog log(where, [&](const std::string& sentence) {
          count += sentence.find("lines are being lost") != std::string::npos ? 1 : 100;
        });
        log.add("seven77");
        log.add("this one is torn");
        log.add("this one is lost");
        return count;
      },
      folder.path());
  EXPECT_EQ(told, 1);
  EXPECT_EQ(lines_in(folder.path()), (std::vector<std::string>{"seven77"}));
}

TEST(AppendLog, WriteAllSaysWhatWentOut) {
  std::size_t written = 7;
  EXPECT_NE(write_all(-1, "text", &written), 0);
  EXPECT_EQ(written, 0u);
}

}  // namespace
}  // namespace arenite::io
