// Dates and times in the names of a series' files are the times of its frames.
#include "io/film/file_names.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <functional>
#include <numeric>

#include "support/temporary_folder.hpp"
#include "unit/io/film/stated.hpp"

namespace arenite::io {
namespace {

/// Text frames of two pixels, named by `name`.
void write_named(const std::filesystem::path& folder, const std::vector<std::int64_t>& numbers,
                 const std::function<std::string(std::int64_t)>& name) {
  std::filesystem::remove_all(folder);
  std::filesystem::create_directory(folder);
  for (const auto n : numbers) test::spill(folder / name(n), std::to_string(n) + " 1\n");
}

/// Frames at 30 Hz from 12 o'clock, but for every tenth one, named by the milliseconds at which they were taken.
std::vector<std::int64_t> milliseconds_but_tenths() {
  std::vector<std::int64_t> taken;
  for (std::int64_t n = 0; n < 90; ++n)
    if (n % 10 != 5) taken.push_back(n * 1000 / 30);
  return taken;
}

TEST(FileNames, DatesAndTimesInNamesAreTimes) {
  const test::TemporaryFolder folder;
  const auto named = [](const char* form) {
    return [form](std::int64_t ms) { return fmt::format(fmt::runtime(form), ms / 1000, ms % 1000); };
  };
  for (const char* form : {"rec_2026-11-27_12-00-{:02}-{:03}.asc", "20261127-1200{:02}.{:03}.asc",
                           "a 20261127T1200{:02}_{:03} b2.asc", "2026112712 00{:02},{:03}.asc"}) {
    write_named(folder / "f", milliseconds_but_tenths(), named(form));
    const auto film = open_film(folder / "f");
    ASSERT_EQ(film->info().time.size(), 81U) << form;
    EXPECT_NEAR(film->info().time[5], 0.2, 1e-9) << form;
    EXPECT_EQ(frame_intervals(film->info()).dropped, 9) << form;
    EXPECT_TRUE(tells(*film, "in the names of its files")) << form;
    const auto even = open_film(folder / "f", {.frame_rate = 30.0});
    ASSERT_EQ(even->info().number.size(), 81U) << form;
    EXPECT_EQ(even->info().number.back(), 89) << form;
    EXPECT_TRUE(tells(*even, "9 frames are missing, the first before frame 5")) << form;
    EXPECT_TRUE(tells(*open_film(folder / "f", {.frame_rate = 47.0}), "do not fit 47 Hz")) << form;
  }
}

TEST(FileNames, DigitsBehindADateAndTimeThatCountAreNoFractions) {
  const test::TemporaryFolder folder;
  const auto recorded = [](std::int64_t n) { return fmt::format("20261127-120000_{:03}.asc", n); };
  write_named(folder / "f", {0, 1, 2, 3}, recorded);
  EXPECT_TRUE(open_film(folder / "f")->info().time.empty());
  const auto counted_anew = [](std::int64_t n) { return fmt::format("20261127-1200{:02}_{:03}.asc", n / 9, n % 9); };
  std::vector<std::int64_t> all(40);
  std::iota(all.begin(), all.end(), 0);
  write_named(folder / "f", all, counted_anew);
  EXPECT_TRUE(open_film(folder / "f")->info().time.empty());
  EXPECT_TRUE(tells(*open_film(folder / "f"), "do not count frames one by one"));
  const auto impossible = [](std::int64_t n) { return fmt::format("20261327-1200{:02}.asc", n); };  // a 13th month
  write_named(folder / "f", {1, 2, 4}, impossible);
  EXPECT_TRUE(open_film(folder / "f")->info().time.empty());
}

}  // namespace
}  // namespace arenite::io
