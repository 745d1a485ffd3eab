#include "statistics/numbers.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "support/numbers_of.hpp"

namespace {
using namespace arenite;
using test::from_json;

TEST(Numbers, BracesMakeTreesAndLists) {
  const Numbers n{{"z", 3.5},
                  {"fabric", {{"a_c", {{"value", 0.1}, {"error", 0.01}}}, {"sectors", {1, 2, 3}}}},
                  {"notes", Numbers::list()},
                  {"twice", {"a", "b"}}};
  EXPECT_TRUE(n.is_tree());
  EXPECT_EQ(n["z"].get<double>(), 3.5);
  EXPECT_EQ(n["fabric"]["sectors"].get<std::vector<int>>(), (std::vector<int>{1, 2, 3}));
  EXPECT_TRUE(n["notes"].is_list());
  EXPECT_EQ(n["twice"].get<std::vector<std::string>>(), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(to_json(n),
            R"({"z":3.5,"fabric":{"a_c":{"value":0.1,"error":0.01},"sectors":[1,2,3]},"notes":[],"twice":["a","b"]})");
}

TEST(Numbers, OfAGroupMeanWhatItMeansUnlessTheySayIt) {
  Numbers group{{"glass", {{"value", 3}, {"error", 1}}},
                {"steel", statistics::described(4, "m", "of steel")},
                {"sectors", {1, 2}}};
  const Numbers n{{"sets", statistics::described(group, "N", "of a set")}, {"word", "none"}, {"count", 7}};
  const auto all = named_numbers(n);
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0].name, "sets.glass");
  EXPECT_EQ(all[0].meaning->unit, "N");
  EXPECT_EQ(all[1].meaning->sentence, "of steel");
  EXPECT_EQ(all[2].name, "count");
  EXPECT_EQ(all[2].meaning, nullptr);
}

TEST(Numbers, KeepTheirOrderAndEveryDigitThroughJson) {
  const std::string text =
      R"({"b":18446744073709551615,"a":-9223372036854775808,"pi":3.141592653589793,"yes":true,"none":null,)"
      R"("word":"\u00e4\n","list":[[1,2.5],{}]})";
  const auto n = from_json(text);
  ASSERT_TRUE(n);
  EXPECT_EQ((*n)["b"].get<std::uint64_t>(), std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ((*n)["a"].get<std::int64_t>(), std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(*from_json(to_json(*n)), *n);
  EXPECT_EQ(n->items().front().first, "b");
  EXPECT_FALSE(from_json("{\"a\": "));
  EXPECT_FALSE(from_json("{\"a\": \"\xff\"}"));
}

TEST(Numbers, WhatIsNotFiniteIsNotKnown) {
  EXPECT_FALSE(Numbers(std::numeric_limits<double>::quiet_NaN()).is_known());
  EXPECT_FALSE(Numbers(std::numeric_limits<double>::infinity()).is_known());
  EXPECT_EQ(to_json(Numbers{{"x", std::numeric_limits<double>::quiet_NaN()}}), R"({"x":null})");
  Numbers angles = Numbers::tree();
  statistics::put_angle(angles, "axis", statistics::Estimate{30, 2}, statistics::half_turn, "An axis");
  EXPECT_EQ(to_json(angles), R"({"axis":{"value":30.0,"error":2.0,"period":180.0}})");
}

TEST(Numbers, PathsLeadToWhatIsThere) {
  const Numbers n{{"a.b", {{"c", {5, 6}}}}};
  ASSERT_NE(n.at_path("/a.b/c/1"), nullptr);
  EXPECT_EQ(n.at_path("/a.b/c/1")->get<int>(), 6);
  EXPECT_EQ(n.at_path("/a.b/c/2"), nullptr);
  EXPECT_EQ(n.at_path("/a.b/c/x"), nullptr);
  EXPECT_EQ(n.at_path("/a/b"), nullptr);
}

TEST(Numbers, WhatIsAskedOfTheWrongKindIsRefused) {
  const Numbers n{{"a", 1}, {"word", "x"}};
  EXPECT_THROW(n["b"], NumbersError);
  EXPECT_THROW(n["word"].get<double>(), NumbersError);
  EXPECT_THROW(n["a"].get<std::string>(), NumbersError);
  EXPECT_THROW(n["a"].get<std::vector<double>>(), NumbersError);
  EXPECT_EQ(n.value("b", 7), 7);
  Numbers five = 5;
  EXPECT_THROW(five["x"] = 1, NumbersError);
  EXPECT_THROW(five.push_back(1), NumbersError);
}

TEST(Numbers, AreTakenOutByWhatTheyWerePutWith) {
  Numbers n = Numbers::tree();
  statistics::put(n, "z", 4, "", "Contacts");
  statistics::put(n, "mean_N", 2.5, "N", "Mean force", Trait::by_forces | Trait::detail);
  statistics::put(n, "shares", {1, 2}, "", "Of each", Trait::curve);
  n["sets"]["strong"] = {{"z", 2}};
  n["sets"]["strong"].mark(Trait::by_forces);
  const auto without = [&](Trait trait) {
    Numbers rest = n;
    erase(rest, trait);
    return rest;
  };
  EXPECT_EQ(without(Trait::curve), (Numbers{{"z", 4}, {"mean_N", 2.5}, {"sets", {{"strong", {{"z", 2}}}}}}));
  EXPECT_EQ(without(Trait::by_forces), (Numbers{{"z", 4}, {"shares", {1, 2}}, {"sets", Numbers::tree()}}));
  EXPECT_FALSE(without(Trait::detail).contains("mean_N"));
  EXPECT_TRUE(n["mean_N"].has(Trait::by_forces) && !n["z"].has(Trait::by_forces));
}

TEST(Numbers, AreEqualByValue) {
  EXPECT_EQ(Numbers(std::size_t{3}), Numbers(3));
  EXPECT_EQ(Numbers(3), Numbers(3.0));
  EXPECT_NE(Numbers(3), Numbers("3"));
  EXPECT_NE((Numbers{{"a", 1}}), (Numbers{{"b", 1}}));
}

}  // namespace
