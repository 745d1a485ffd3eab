#include "report/number_words.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <set>
#include <string>

namespace arenite::report {
namespace {

TEST(NumberWords, AreWrittenAsQuantitiesAreAndSayEachOneThing) {
  std::set<std::string> names;
  const Numbers words = number_words();
  for (const auto& [key, named] : words.items()) {
    const auto name = named[0].get<std::string>();
    EXPECT_TRUE(names.insert(name).second) << name;
    for (std::size_t at = name.find('_'); at != std::string::npos; at = name.find('_', at + 1))
      EXPECT_EQ(name[at + 1], '{') << name;
  }
}

TEST(NumberWords, CallStressesByTheSymbolsOfPictures) {
  const Numbers words = number_words();
  EXPECT_EQ(words["sigma_yy"], Numbers::list({"\u03c3_{yy}", ""}));
  EXPECT_EQ(words["sigma_hyd"], Numbers::list({"\u03c3_{hyd}", ""}));
  EXPECT_EQ(words["modulus"], Numbers::list({"apparent modulus", "E"}));
  EXPECT_FALSE(words.contains("ux"));
}

}  // namespace
}  // namespace arenite::report
