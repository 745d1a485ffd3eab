#include "io/hdf5/foreign.hpp"

#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstring>
#include <functional>
#include <numeric>
#include <stdexcept>
#include <thread>

#include "core/error.hpp"
#include "io/disk/file.hpp"
#include "io/film/film.hpp"
#include "io/hdf5/sandbox.hpp"
#include "support/films.hpp"
#include "support/pictures.hpp"
#include "support/temporary_folder.hpp"

namespace {
using namespace arenite;
using namespace arenite::io;
using test::TemporaryFolder;

constexpr hsize_t shape[] = {5, 7, 9};

struct Way {
  const char* name;
  std::vector<hsize_t> chunk = {};
  bool deflate = false, shuffle = false, checksum = false, compact = false, latest = false;
  hsize_t user_block = 0;
};

/// 0, 1, 2, ... in a file of its own, written by HDF5 itself.
void write(const std::filesystem::path& path, const Way& way) {
  const hid_t creation = H5Pcreate(H5P_FILE_CREATE), access = H5Pcreate(H5P_FILE_ACCESS),
              set = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_userblock(creation, way.user_block);
  if (way.latest) H5Pset_libver_bounds(access, H5F_LIBVER_LATEST, H5F_LIBVER_LATEST);
  if (!way.chunk.empty()) H5Pset_chunk(set, 3, way.chunk.data());
  if (way.compact) H5Pset_layout(set, H5D_COMPACT);
  if (way.shuffle) H5Pset_shuffle(set);
  if (way.deflate) H5Pset_deflate(set, 6);
  if (way.checksum) H5Pset_fletcher32(set);
  const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation, access),
              space = H5Screate_simple(3, shape, nullptr);
  const hid_t data = H5Dcreate2(file, "frames", H5T_STD_U16BE, space, H5P_DEFAULT, set, H5P_DEFAULT);
  std::vector<std::uint16_t> numbers(315);
  std::iota(numbers.begin(), numbers.end(), std::uint16_t{0});
  H5Dwrite(data, H5T_NATIVE_UINT16, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data());
  H5Dclose(data);
  H5Sclose(space);
  H5Fclose(file);
  for (const hid_t list : {creation, access, set}) H5Pclose(list);
}

TEST(Hdf5Numbers, AreReadHoweverTheyAreStored) {
  const TemporaryFolder folder;
  for (const Way& way :
       {Way{"piece"}, Way{"beside", {}, false, false, false, true}, Way{"chunks", {2, 3, 4}}, Way{"rows", {2, 3, 9}},
        Way{"one", {5, 7, 9}}, Way{"deflated", {2, 3, 4}, true}, Way{"all", {2, 3, 4}, true, true, true},
        Way{"odd sum", {1, 3, 3}, false, true, true}, Way{"newest", {2, 3, 4}, true, true, true, false, true},
        Way{"bytes before", {2, 3, 4}, true, false, false, false, false, 1024},
        Way{"bytes before a piece", {}, false, false, false, false, false, 512}}) {
    write(folder / "a.h5", way);
    for (const bool in_memory : {false, true}) {
      const auto film =
          in_memory ? open_film(bytes_in_memory(read_file(folder / "a.h5"), "a")) : open_film(folder / "a.h5");
      ASSERT_EQ(film->info().frames, 5) << way.name;
      for (const auto& [first, count] : {std::pair{0, 5}, {1, 3}, {4, 1}}) {
        FrameBlock block;
        film->read(first, static_cast<std::size_t>(count), block);
        for (std::size_t i = 0; i < block.level.size(); ++i)
          ASSERT_EQ(block.level[i], static_cast<std::size_t>(first) * 63 + i) << way.name;
      }
    }
  }
}

TEST(Hdf5Numbers, AChunkThatWasChangedIsRefused) {
  const TemporaryFolder folder;
  for (const Way& way : {Way{"sum", {5, 7, 9}, false, false, true}, Way{"deflated", {5, 7, 9}, true}}) {
    write(folder / "a.h5", way);
    std::string bytes = read_file(folder / "a.h5");
    bytes[bytes.size() - 40] = static_cast<char>(bytes[bytes.size() - 40] ^ 0x10);
    const std::string said = test::complaint([&] { open_film(bytes_in_memory(bytes, "a")); });
    EXPECT_NE(said.find("cannot be decompressed; copy the file again"), std::string::npos) << way.name << ": " << said;
  }
}

TEST(Hdf5Unpack, NothingLargerThanAskedForIsMade) {
  EXPECT_EQ(unpack_chunk("abcd", {}, 0, 4), "abcd");
  EXPECT_FALSE(unpack_chunk("abcd", {}, 0, 5));
  EXPECT_EQ(unpack_chunk("acbd", {{Hdf5Filter::Kind::shuffle, 2}}, 0, 4), "abcd");
  EXPECT_EQ(unpack_chunk("acbd", {{Hdf5Filter::Kind::shuffle, 2}}, 1, 4), "acbd");
  EXPECT_FALSE(unpack_chunk("abcd", {{Hdf5Filter::Kind::deflate, 1}}, 0, 4));
  EXPECT_FALSE(unpack_chunk("ab", {{Hdf5Filter::Kind::checksum, 1}}, 0, 2));
}

std::string is_killed() {
  std::raise(SIGKILL);
  return "";
}
std::string throws_a_number() { throw 1; }
std::string asks_for_a_tebibyte() {
  std::string all;
  all.resize(1'099'511'627'776);
  return all;
}
std::string says_more_than_announced() { return std::string(100, 'x'); }

TEST(OwnProcess, GivesBytesPassesRefusalsAndSurvivesDeath) {
  std::string long_one(3'000'000, 'x');
  EXPECT_EQ(in_sandbox(
                "a", [&] { return long_one; }, long_one.size()),
            long_one);
  EXPECT_EQ(in_sandbox(
                "a", [] { return std::string(); }, 10),
            "");
  EXPECT_EQ(test::complaint([] {
              in_sandbox(
                  "a", []() -> std::string { throw InputError("b", 3, "is wrong; correct it"); }, 10);
            }),
            "a: is wrong; correct it");
  for (const auto end : {is_killed, throws_a_number, asks_for_a_tebibyte, says_more_than_announced})
    EXPECT_EQ(test::complaint([&] { in_sandbox("a", end, 10); }), "a: is damaged; copy it again");
}

/// The work says that it runs and would go on for ever; a pipe that it holds tells its end.
struct EndlessWork {
  int started[2] = {}, alive[2] = {};
  EndlessWork() {
    if (::pipe(started) != 0 || ::pipe(alive) != 0) throw std::runtime_error("no pipe");
  }
  std::string operator()() const {
    const pid_t own = ::getpid();
    if (::write(started[1], &own, sizeof(own)) != sizeof(own)) return "";
    for (;;) ::pause();
  }
  pid_t wait_for_start() const {
    pid_t process = 0;
    return ::read(started[0], &process, sizeof(process)) == sizeof(process) ? process : 0;
  }
};

TEST(OwnProcess, EndsWithTheProcessThatWaitsForIt) {
  EndlessWork work;
  const pid_t waiting = ::fork();
  if (waiting == 0) {
    ::close(work.alive[0]);
    in_sandbox("a", std::cref(work), 10);
    ::_exit(0);
  }
  ::close(work.alive[1]);
  ASSERT_GT(work.wait_for_start(), 0);
  ::kill(waiting, SIGKILL);
  ::waitpid(waiting, nullptr, 0);
  char nothing = 0;
  EXPECT_EQ(::read(work.alive[0], &nothing, 1), 0);  // comes back when nobody holds the other end
}

TEST(OwnProcess, IsEndedByWhatEndsPrograms) {
  for (const int signal : {SIGTERM, SIGINT}) {
    EndlessWork work;
    std::thread ends([&] { ::kill(work.wait_for_start(), signal); });
    EXPECT_EQ(test::complaint([&] { in_sandbox("a", std::cref(work), 10); }),
              "a: was not read: its reading was stopped; start it again");
    ends.join();
  }
}

}  // namespace
