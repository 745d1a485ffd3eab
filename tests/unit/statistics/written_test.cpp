#include "statistics/written.hpp"

#include <gtest/gtest.h>

#include <string>

#include "statistics/numbers_text.hpp"

using namespace arenite;
using namespace arenite::statistics;

TEST(Written, AUnitHasThePrefixThatSuitsTheNumbers) {
  EXPECT_EQ(scale_of(999.9, "N").unit, "kN") << "which three digits write as 1.00 kN";
  EXPECT_EQ(scale_of(2e6, "Pa m^0.5").unit, "MPa\u2009m^{1/2}");
  EXPECT_EQ(scale_of(5e-10, "m").unit, "nm");
  EXPECT_EQ(scale_of(5e-10, "m").factor, 1e-9);
  EXPECT_EQ(scale_of(5e-2, "m/s").unit, "mm/s");
  EXPECT_EQ(scale_of(1e6, "DL").unit, "DL");
  EXPECT_EQ(scale_of(1e6, "1/s^2").unit, "1/s\u00b2");
}

TEST(Written, TwoDigitsOfAnErrorAreCountedOnceItIsRounded) {
  EXPECT_EQ(decimals_of(0.029), 3);
  EXPECT_EQ(decimals_of(0.0994), 3);
  EXPECT_EQ(decimals_of(0.0996), 2);
  EXPECT_EQ(decimals_of(120), -1);
  EXPECT_EQ(with_error({12.3456, 0.0996}), "12.35 +- 0.10");
}

TEST(Written, PagesHaveTheTableByWhichUnitsArePrefixed) {
  const Numbers units = prefixed_units();
  for (const Numbers& unit : units["prefixed"])
    for (const Numbers& prefix : units["prefixes"])
      EXPECT_EQ(scale_of(prefix[0].get<double>(), unit.get<std::string>()).factor, prefix[0].get<double>());
}
