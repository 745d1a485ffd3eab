#include "core/hash.hpp"

#include <gtest/gtest.h>

namespace {
using arenite::content_hash;
using arenite::HashBuilder;

TEST(Hash, IsTheSameOnEveryMachineAndInEveryVersion) {
  EXPECT_EQ(content_hash(""), "99aa06d3014798d86001c324468d497f");
  EXPECT_EQ(content_hash("abc"), "06b05ab6733a618578af5f94892f3950");
}

TEST(Hash, ChangesWithOneBit) { EXPECT_NE(content_hash("grain"), content_hash("graio")); }

TEST(Hash, KeyAndValueDoNotRunTogether) {
  EXPECT_NE(HashBuilder().add("ab", "c").hex(), HashBuilder().add("a", "bc").hex());
  EXPECT_NE(HashBuilder().add("a", "b").add("c", "d").hex(), HashBuilder().add("c", "d").add("a", "b").hex());
}

TEST(Hash, TypesAndSignsAreTold) {
  EXPECT_NE(HashBuilder().add("k", 1.0).hex(), HashBuilder().add("k", std::int64_t{1}).hex());
  EXPECT_NE(HashBuilder().add("k", 0.0).hex(), HashBuilder().add("k", -0.0).hex());
  EXPECT_NE(HashBuilder().add("k", 1.0).hex(), HashBuilder().add("k", std::vector<double>{1.0}).hex());
}

TEST(Hash, SamePartsGiveTheSameName) {
  const auto name = [] { return HashBuilder().add("stage", "load").add("mu", 0.3).add("seed", std::int64_t{7}).hex(); };
  EXPECT_EQ(name(), name());
  EXPECT_EQ(name().size(), 32u);
}

}  // namespace
