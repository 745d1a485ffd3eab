#include "core/threads.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace arenite {
namespace {

TEST(Team, CutsEveryRangeIntoPartsThatMeetAndDoNotOverlap) {
  for (const int size : {1, 2, 3, 5}) {
    const Team team(size);
    EXPECT_EQ(team.size(), size);
    for (const std::size_t n : {0, 1, 7, 8, 9, 1000}) {
      std::vector<int> visits(n, 0);
      team.for_ranges(n, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) ++visits[k];
      });
      EXPECT_EQ(visits, std::vector<int>(n, 1)) << size << " members, range of " << n;
    }
  }
}

TEST(Team, FinishesOneThingBeforeTheNext) {
  const Team team(2);
  constexpr std::size_t n = 64;
  std::vector<int> values(n, 0), mirrored(n, 0);
  for (int round = 0; round < 2000; ++round) {
    team.for_ranges(n, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) mirrored[k] = values[n - 1 - k];
    });
    team.for_ranges(n, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) values[k] = mirrored[k] + 1;
    });
  }
  EXPECT_EQ(values, std::vector<int>(n, 2000));
}

}  // namespace
}  // namespace arenite
