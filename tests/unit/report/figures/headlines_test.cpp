#include "report/figures/headlines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "core/text.hpp"

namespace arenite::report::figures {
namespace {

TEST(Headlines, AreAmongTheRowsThatShowPrintsFirst) {
  using enum fields::TestKind;
  const std::string rows = first_rows(Numbers::tree());
  const auto is_shown = [&](std::string_view name) {
    return std::ranges::any_of(split_blanks(rows), [&](std::string_view row) {
      return name == row || name.starts_with(std::string(row) + ".");
    });
  };
  for (const auto kind : {none, biaxial, shear, uniaxial, oedometer, cycles, discharge, collapse, deposit, drum}) {
    for (const Headline& one : headlines_of(kind)) EXPECT_TRUE(is_shown(one.name)) << one.name;
    for (const Headline& one : headlines_of_grains(kind)) EXPECT_TRUE(is_shown(one.name)) << one.name;
  }
  EXPECT_FALSE(is_shown("stages"));
}

TEST(Headlines, OfAFreeSurfaceLeaveOutTheSolidFractionOfTheBox) {
  const auto shown = [](const Numbers& numbers) {
    const std::string rows = first_rows(numbers);
    return std::ranges::count(split_blanks(rows), std::string_view("solid_fraction"));
  };
  EXPECT_EQ(shown(Numbers::tree()), 1);
  EXPECT_EQ(shown(Numbers{{"surface", {{"angle_deg", 20.0}}}}), 0);
}

}  // namespace
}  // namespace arenite::report::figures
