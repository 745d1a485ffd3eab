#include "io/hdf5/handle.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <thread>
#include <vector>

#include "io/film/film.hpp"
#include "io/results/results.hpp"
#include "support/films.hpp"
#include "support/sample_results.hpp"
#include "support/temporary_folder.hpp"

namespace arenite::io {
namespace {

/// A film is read in a process of its own, forked while the other threads are somewhere in HDF5.
TEST(Hdf5Turn, ThreadsReadFilmsAndWriteResultsSideBySide) {
  const test::TemporaryFolder folder;
  Film film = test::counted(40, 30, 20);
  write_film(folder / "film.h5", film);
  std::atomic<int> films = 0, results = 0;
  const auto reads_films = [&] {
    for (int n = 0; n < 40; ++n) films += test::all_of(*open_film(folder / "film.h5")).level == film.level;
  };
  const auto stores_results = [&](const std::filesystem::path& file) {
    for (int n = 0; n < 150; ++n) {
      write_stage(file, test::two_snapshots(50));
      results += read_stage(file).snapshots.size() == 2;
    }
  };
  std::vector<std::thread> threads;
  threads.emplace_back(reads_films);
  threads.emplace_back(stores_results, folder / "a.h5");
  threads.emplace_back(reads_films);
  threads.emplace_back(stores_results, folder / "b.h5");
  for (auto& thread : threads) thread.join();
  EXPECT_EQ(films, 80);
  EXPECT_EQ(results, 300);
}

/// A process that is forked while another thread has the turn must be able to take it: nobody there would give it back.
TEST(Hdf5Turn, AForkedProcessMayTakeIt) {
  std::atomic<bool> done = false;
  std::thread speaks([&] {
    while (!done) {
      const Hdf5Turn turn;
      H5open();
    }
  });
  int whole = 0;
  constexpr int forks = 60;
  for (int n = 0; n < forks; ++n) {
    const pid_t child = ::fork();
    if (child == 0) {
      ::alarm(20);  // for one that waits for ever
      const Hdf5Turn turn;
      ::_exit(0);
    }
    int status = 1;
    ::waitpid(child, &status, 0);
    whole += status == 0 ? 1 : 0;
  }
  done = true;
  speaks.join();
  EXPECT_EQ(whole, forks);
}

TEST(Hdf5Turn, WhoHasItMayTakeItAgain) {
  const Hdf5Turn first;
  const Hdf5Turn second;
}

}  // namespace
}  // namespace arenite::io
