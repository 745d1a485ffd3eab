#include "io/disk/file.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <functional>

#include "core/error.hpp"
#include "support/temporary_folder.hpp"

namespace {
using arenite::InputError;
using arenite::io::read_file;
using arenite::io::write_atomically;
using arenite::test::TemporaryFolder;
namespace fs = std::filesystem;

std::string complaint(const std::function<void()>& act) {
  try {
    act();
  } catch (const InputError& error) { return error.what(); }
  return "";
}

/// Files may not grow beyond `bytes` while this lives: what a full disk looks like to a writer without a disk to fill.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit small{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallDisk() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  void (*handler_)(int);
  rlimit before_{};
};

TEST(AtomicFile, WritesAllBytesAndNothingElse) {
  const TemporaryFolder folder;
  const std::string bytes("a\0b\n\xff", 5);
  write_atomically(folder / "x", bytes);
  EXPECT_EQ(read_file(folder / "x"), bytes);
  write_atomically(folder / "x", "");
  EXPECT_EQ(read_file(folder / "x"), "");
  EXPECT_EQ(folder.count(), 1);
}

TEST(AtomicFile, FullDiskLeavesTheOldFileAndNoRemains) {
  const TemporaryFolder folder;
  write_atomically(folder / "x", "old");
  std::string said;
  {
    const SmallDisk disk(4096);
    said = complaint([&] { write_atomically(folder / "x", std::string(10'000, 'n')); });
  }
  EXPECT_NE(said.find("size limit"), std::string::npos) << said;
  EXPECT_EQ(read_file(folder / "x"), "old");
  EXPECT_EQ(folder.count(), 1);
}

TEST(AtomicFile, AKilledWriterLeavesTheOldFileAndItsRemainsAreTakenOver) {
  const TemporaryFolder folder;
  write_atomically(folder / "x", "old");
  const pid_t child = ::fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_DFL);  // the limit kills the child in the middle of its write
    const rlimit small{4096, 4096};
    ::setrlimit(RLIMIT_FSIZE, &small);
    const rlimit no_core{0, 0};
    ::setrlimit(RLIMIT_CORE, &no_core);
    write_atomically(folder / "x", std::string(10'000, 'n'));
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(read_file(folder / "x"), "old");
  ASSERT_EQ(folder.count(), 2) << "the killed writer should have left its unfinished file for this test to mean something";
  write_atomically(folder / "x", "new");
  EXPECT_EQ(read_file(folder / "x"), "new");
  EXPECT_EQ(folder.count(), 1);
}

TEST(AtomicFile, ProcessesThatWriteTheSameFileNeverMixTheirBytes) {
  const TemporaryFolder folder;
  std::vector<pid_t> children;
  for (const char letter : {'a', 'b', 'c'}) {
    const pid_t child = ::fork();
    if (child == 0) {
      for (int k = 0; k < 20; ++k) write_atomically(folder / "x", std::string(50'000, letter));
      ::_exit(0);
    }
    children.push_back(child);
  }
  for (const pid_t child : children) {
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
  }
  const std::string bytes = read_file(folder / "x");
  EXPECT_EQ(bytes, std::string(50'000, bytes.at(0)));
  EXPECT_EQ(folder.count(), 1);
}

TEST(AtomicFile, SaysWhatIsWrongAndHowToMendIt) {
  const TemporaryFolder folder;
  const auto missing = complaint([&] { write_atomically(folder / "no/such/x", "a"); });
  EXPECT_NE(missing.find("there is no folder"), std::string::npos) << missing;
  write_atomically(folder / "file", "a");
  const auto below = complaint([&] { write_atomically(folder / "file/x", "a"); });
  EXPECT_NE(below.find("is not a folder"), std::string::npos) << below;
  const auto on_folder = complaint([&] { write_atomically(folder.path(), "a"); });
  EXPECT_NE(on_folder.find("it is a folder"), std::string::npos) << on_folder;
  const auto device = complaint([&] { write_atomically("/dev/full", "a"); });
  EXPECT_NE(device.find("not a regular file"), std::string::npos) << device;
  const auto long_name = complaint([&] { write_atomically(folder / std::string(300, 'x'), "a"); });
  EXPECT_NE(long_name.find("too long"), std::string::npos) << long_name;
}

TEST(AtomicFile, NoPermissionIsSaidToAnOrdinaryUser) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "locked");
  fs::permissions(folder / "locked", fs::perms::owner_read | fs::perms::owner_exec | fs::perms::others_read | fs::perms::others_exec);
  fs::permissions(folder.path(), fs::perms::all);
  const pid_t child = ::fork();  // permissions do not bind root: a child gives its rights up first
  if (child == 0) {
    if (::geteuid() == 0 && ::setuid(65534) != 0) ::_exit(2);
    const auto said = complaint([&] { write_atomically(folder / "locked/x", "a"); });
    ::_exit(said.find("no permission") != std::string::npos ? 0 : 1);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  EXPECT_FALSE(fs::exists(folder / "locked/x"));
}

TEST(AtomicFile, FollowsASymbolicLinkInsteadOfReplacingIt) {
  const TemporaryFolder folder;
  write_atomically(folder / "target", "old");
  fs::create_symlink(folder / "target", folder / "link");
  write_atomically(folder / "link", "new");
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(read_file(folder / "target"), "new");
}

TEST(ReadFile, SaysWhatIsMissing) {
  const TemporaryFolder folder;
  EXPECT_NE(complaint([&] { read_file(folder / "none.csv"); }).find("no such file"), std::string::npos);
  EXPECT_NE(complaint([&] { read_file(folder.path()); }).find("is a folder"), std::string::npos);
}

}  // namespace
