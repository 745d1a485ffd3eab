#include "core/threads.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <thread>
#include <vector>

namespace arenite {
namespace {

TEST(ThreadPool, CutsEveryRangeIntoPartsThatMeetAndDoNotOverlap) {
  for (const int size : {1, 2, 3, 5}) {
    const ThreadPool pool(size);
    EXPECT_EQ(pool.size(), size);
    for (const std::size_t n : {0, 1, 7, 8, 9, 1000}) {
      std::vector<int> visits(n, 0);
      pool.for_ranges(n, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) ++visits[k];
      });
      EXPECT_EQ(visits, std::vector<int>(n, 1)) << size << " members, range of " << n;
    }
  }
}

TEST(ThreadPool, FinishesOneThingBeforeTheNext) {
  const ThreadPool pool(2);
  constexpr std::size_t n = 64;
  std::vector<int> values(n, 0), mirrored(n, 0);
  for (int round = 0; round < 2000; ++round) {
    pool.for_ranges(n, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) mirrored[k] = values[n - 1 - k];
    });
    pool.for_ranges(n, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) values[k] = mirrored[k] + 1;
    });
  }
  EXPECT_EQ(values, std::vector<int>(n, 2000));
}

TEST(ThreadPool, DoesWhatAMemberThatIsKeptAwayHasNotBegun) {
  const auto caller = std::this_thread::get_id();
  constexpr std::size_t n = 4096;
  for (int round = 0; round < 20; ++round) {
    const ThreadPool pool(2);
    std::atomic<std::size_t> of_caller{0}, of_member{0};
    bool helped = true;
    pool.for_ranges(n, [&](std::size_t begin, std::size_t end) {
      if (std::this_thread::get_id() == caller) {
        of_caller += end - begin;
        return;
      }
      // Kept in the middle of its first range until the caller has done all the others; that it gives up is for a
      // caller that never does.
      const auto late = std::chrono::steady_clock::now() + std::chrono::seconds(5);
      if ((of_member += end - begin) > n / 4) helped = false;
      while (helped && of_caller + of_member < n) helped = std::chrono::steady_clock::now() < late;
    });
    EXPECT_TRUE(helped) << "the caller did " << of_caller << " of " << n << ", its member " << of_member;
    EXPECT_EQ(of_caller + of_member, n);
  }
}

TEST(ThreadPool, GivesTheSameWhereMembersAreManyAndLate) {
  const ThreadPool pool(7);  // more than there are processors, most of the time
  std::vector<std::uint64_t> value(3000), expected(3000);
  for (std::uint64_t round = 0; round < 3000; ++round) {
    const std::size_t n = 8 + round * 37 % (value.size() - 8);
    pool.for_ranges(n, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) value[k] = value[k] * 3 + round + k;
    });
    for (std::size_t k = 0; k < n; ++k) expected[k] = expected[k] * 3 + round + k;
  }
  EXPECT_EQ(value, expected);
}

}  // namespace
}  // namespace arenite
