#include "io/results/groups.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/error.hpp"

namespace {
using namespace arenite;

Numbers any_value() {
  switch (*rc::gen::inRange(0, 6)) {
    case 0: return nullptr;
    case 1: return *rc::gen::arbitrary<bool>();
    case 2: return *rc::gen::arbitrary<std::int64_t>();
    case 3: return *rc::gen::arbitrary<std::uint64_t>();
    case 4: return *rc::gen::arbitrary<double>();
    default: return *rc::gen::container<std::string>(rc::gen::inRange(' ', '~'));
  }
}

Numbers any_numbers(int depth) {
  const int kind = depth == 0 ? 0 : *rc::gen::inRange(0, 3);
  if (kind == 0) return any_value();
  Numbers n = kind == 1 ? Numbers::list() : Numbers::tree();
  const int count = *rc::gen::inRange(0, 4);
  for (int k = 0; k < count; ++k) {
    if (kind == 1) n.push_back(any_numbers(depth - 1));
    else n[*rc::gen::container<std::string>(rc::gen::element('a', 'b', '.', '0', '/'))] = any_numbers(depth - 1);
  }
  return n;
}

Numbers numbers_in(const io::Hdf5Group& at, const char* name) {
  Numbers numbers;
  io::transfer_numbers(at, name, numbers);
  return numbers;
}

Numbers through_a_file(Numbers numbers) {
  const io::Hdf5Group file;
  io::transfer_numbers(file, "numbers", numbers);
  return numbers_in({file.bytes(), "some.h5"}, "numbers");
}

RC_GTEST_PROP(NumbersTable, GivesBackEveryNumberInItsOrder, ()) {
  Numbers n{{"all", any_numbers(3)}};
  RC_ASSERT(through_a_file(n) == n);
}

TEST(NumbersTable, KeepsPeriodsOfAngles) {
  Numbers n = Numbers::tree();
  statistics::put_angle(n, "way_of_long_axes", {{"value", 170}, {"error", 5}}, statistics::half_turn, "Long axes");
  statistics::put(n, "theta_of_flank_deg", 30, "deg", "Angle of a flank");
  const Numbers again = through_a_file(n);
  EXPECT_EQ(again["way_of_long_axes"].meaning()->period, 180);
  EXPECT_EQ(again["theta_of_flank_deg"].meaning()->period, 0);
}

TEST(NumbersTable, HasThePeriodsOfAnglesInFilesWithoutThem) {
  const Numbers n{{"fabric", {{"theta_c_deg", statistics::described(170, "deg", "Principal direction")}}}};
  EXPECT_EQ(through_a_file(n)["fabric"]["theta_c_deg"].meaning()->period, 180);
}

TEST(NumbersTable, KeepsWhatEachNumberIs) {
  const Numbers n{{"z", statistics::described({{"value", 3.9}, {"error", 0.1}}, "", "Contacts of a grain")},
                  {"list", {1, statistics::described(2, "m", "Second")}},
                  {"plain", 5}};
  const Numbers again = through_a_file(n);
  ASSERT_TRUE(again["z"].meaning());
  EXPECT_EQ(again["z"].meaning()->sentence, "Contacts of a grain");
  EXPECT_EQ(again["z"]["value"].meaning(), nullptr);
  ASSERT_TRUE(again["list"][1].meaning());
  EXPECT_EQ(again["list"][1].meaning()->unit, "m");
  EXPECT_EQ(again["list"][1].meaning()->period, 0);
  EXPECT_EQ(again["plain"].meaning(), nullptr);
}

TEST(NumbersTable, KeepsIntegersThatNoRealHolds) {
  const Numbers n{{"seed", 18446744073709551615u}, {"low", std::int64_t{-9007199254740993}}, {"text", " padded "}};
  EXPECT_EQ(through_a_file(n), n);
  EXPECT_FALSE(through_a_file({}).is_known());
}

/// A table as it lies in a file, but for its texts; every value is 2.
io::Hdf5Group table_in(const io::Hdf5Group& file, std::vector<std::string> name, std::vector<std::uint8_t> depth,
                       std::vector<std::uint8_t> kind) {
  std::vector<double> value(name.size(), 2.0);
  const auto group = file.group("n");
  group.texts("name", name);
  group.array("depth", depth);
  group.array("kind", kind);
  group.array("value", value);
  return group;
}

TEST(NumbersTable, WhatIsDamagedIsTold) {
  const auto refused = [](const std::vector<std::string>& name, const std::vector<std::uint8_t>& depth,
                          const std::vector<std::uint8_t>& kind) {
    const io::Hdf5Group file;
    table_in(file, name, depth, kind);
    EXPECT_THROW(numbers_in({file.bytes(), "some.h5"}, "n"), InputError);
  };
  refused({"", "a"}, {0, 1}, {7});     // columns of unlike length
  refused({"", "a"}, {0, 2}, {7, 4});  // a child without its parent
  refused({"", "a", "b"}, {0, 0, 0}, {7, 4, 4});
  refused({"", "a"}, {1, 2}, {7, 4});
  refused({"", "list", ""}, {0, 1, 2}, {7, 4, 4});  // a real holds nothing
  const auto refused_rows = [](std::vector<std::int64_t> row, std::vector<std::string> text) {
    const io::Hdf5Group file;
    const auto some = table_in(file, {"", "a", "b"}, {0, 1, 1}, {7, 5, 5}).group("text");
    some.array("row", row);
    some.texts("text", text);
    EXPECT_THROW(numbers_in({file.bytes(), "some.h5"}, "n"), InputError);
  };
  refused_rows({1, 2}, {"one"});         // a row without its text
  refused_rows({2, 1}, {"one", "two"});  // rows out of order
  refused_rows({1, 3}, {"one", "two"});  // a row that is not there
  refused_rows({-1, 1}, {"one", "two"});
}

/// A recipe among thousands of numbers: no number is as wide as it.
TEST(NumbersTable, ALongTextDoesNotWidenNumbers) {
  Numbers n{{"recipe", std::string(3000, 'x')}};
  for (int k = 0; k < 5000; ++k) n["values"].push_back(k / 7.0);
  const io::Hdf5Group file(false);
  transfer_numbers(file, "n", n);
  const std::string bytes = file.bytes();
  EXPECT_LT(bytes.size(), 300'000U);
  EXPECT_EQ(numbers_in({bytes, "some.h5"}, "n"), n);
}

}  // namespace
