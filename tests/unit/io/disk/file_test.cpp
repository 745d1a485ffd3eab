#include "io/disk/file.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <functional>

#include "core/error.hpp"
#include "support/small_disk.hpp"
#include "support/temporary_folder.hpp"

namespace {
using arenite::InputError;
using arenite::io::AtomicFile;
using arenite::io::read_file;
using arenite::io::write_atomically;
using arenite::test::SmallDisk;
using arenite::test::TemporaryFolder;
namespace fs = std::filesystem;

std::string complaint(const std::function<void()>& act) {
  try {
    act();
  } catch (const InputError& error) { return error.what(); }
  return "";
}

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

/// Writes until the limit kills the process in the middle of it.
void write_and_die(const fs::path& path, AtomicFile::Until until) {
  const pid_t child = ::fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_DFL);
    const rlimit small{4096, 4096};
    ::setrlimit(RLIMIT_FSIZE, &small);
    const rlimit no_core{0, 0};
    ::setrlimit(RLIMIT_CORE, &no_core);
    AtomicFile file(path, until);
    file.write(std::string(10'000, 'n'));
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  ASSERT_TRUE(WIFSIGNALED(status));
}

void write_by(const fs::path& path, AtomicFile::Until until, const std::string& bytes) {
  AtomicFile file(path, until);
  file.write(bytes);
  file.commit();
}

TEST(AtomicFile, AKilledWriterLeavesTheOldFileAndItsRemainsAreTakenOver) {
  const TemporaryFolder folder;
  write_atomically(folder / "x", "old");
  write_and_die(folder / "x", AtomicFile::Until::named);
  EXPECT_EQ(read_file(folder / "x"), "old");
  ASSERT_EQ(folder.count(), 2)
      << "the killed writer should have left its unfinished file for this test to mean something";
  write_by(folder / "x", AtomicFile::Until::named, "new");
  EXPECT_EQ(read_file(folder / "x"), "new");
  EXPECT_EQ(folder.count(), 1);
}

TEST(AtomicFile, AKilledWriterOfANamelessFileLeavesNothing) {
  const TemporaryFolder folder;
  if (AtomicFile(folder / "x").beside().parent_path() == folder.path()) GTEST_SKIP() << "no files without a name here";
  write_atomically(folder / "x", "old");
  write_and_die(folder / "x", AtomicFile::Until::nameless);
  EXPECT_EQ(read_file(folder / "x"), "old");
  EXPECT_EQ(folder.count(), 1);
}

TEST(AtomicFile, NothingThatSomebodyPutThereIsWrittenThrough) {
  const TemporaryFolder folder;
  const auto put_there = [&](const std::function<void(const fs::path&)>& put) {
    SCOPED_TRACE(testing::Message() << "planted");
    write_atomically(folder / "victim", "untouched");
    fs::remove(folder / ".x.tmp");
    put(folder / ".x.tmp");
    const std::string said = complaint([&] { write_by(folder / "x", AtomicFile::Until::named, "mine"); });
    EXPECT_NE(said.find(".x.tmp is there already and is not a file of its own; remove it"), std::string::npos) << said;
    EXPECT_EQ(read_file(folder / "victim"), "untouched");
    EXPECT_FALSE(fs::exists(folder / "x"));
    write_atomically(folder / "y", "mine");  // whatever lies beside
    EXPECT_EQ(read_file(folder / "y"), "mine");
  };
  put_there([&](const fs::path& at) { fs::create_symlink(folder / "victim", at); });
  put_there([&](const fs::path& at) { fs::create_symlink(folder / "nowhere", at); });
  EXPECT_FALSE(fs::exists(folder / "nowhere"));
  put_there([&](const fs::path& at) { fs::create_hard_link(folder / "victim", at); });
  put_there([&](const fs::path& at) { ASSERT_EQ(::mkfifo(at.c_str(), 0666), 0); });
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
  fs::permissions(folder / "locked",
                  fs::perms::owner_read | fs::perms::owner_exec | fs::perms::others_read | fs::perms::others_exec);
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
