#include <fmt/core.h>
#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "io/disk/file.hpp"
#include "recipe/recipe.hpp"

namespace arenite::recipe {
namespace {

/// A line `key = value` of a resolved recipe, and the text around it.
struct Line {
  int number;
  std::string key, value, before, after;
};

/// The lines of one resolved recipe.
void add_lines(const std::string& resolved, std::vector<Line>& lines) {
  std::istringstream in(resolved);
  std::size_t at = 0;
  int number = 0;
  for (std::string line; std::getline(in, line); at += line.size() + 1) {
    ++number;
    const auto equals = line.find(" = ");
    if (equals == std::string::npos || line.starts_with("[")) continue;
    lines.push_back({number, line.substr(0, equals), line.substr(equals + 3), resolved.substr(0, at),
                     resolved.substr(at + line.size())});
  }
}

/// All such lines of two recipes that use most keys.
std::vector<Line> lines_of_a_full_recipe() {
  std::vector<Line> lines;
  for (const char* name : {"all-kinds", "cemented"}) {
    const auto text = io::read_file(fmt::format("{}/tests/fuzz/corpus/recipe/{}.toml", ARENITE_SOURCE_DIR, name));
    add_lines(to_toml(parse_recipe(text, "all.toml")), lines);
  }
  return lines;
}

/// Problems of the recipe with this line instead, as far as they are about it.
std::vector<Problem> problems_at(const Line& line, const std::string& assignment) {
  std::vector<Problem> found;
  try {
    parse_recipe(line.before + assignment + line.after, "r.toml");
  } catch (const InputError& error) {
    for (const auto& problem : error.problems()) {
      if (problem.line == line.number) found.push_back(problem);
    }
  }
  return found;
}

bool is_quantity(const std::string& value) {
  return value.size() > 2 && value[0] == '"' && (value[1] == '-' || (value[1] >= '0' && value[1] <= '9')) &&
         value.find(' ') != std::string::npos;
}

TEST(EveryKey, RefusesADateAtItsPlace) {
  const auto lines = lines_of_a_full_recipe();
  ASSERT_GT(lines.size(), 120u);
  for (const auto& line : lines) {
    const auto found = problems_at(line, line.key + " = 1979-05-27");
    ASSERT_EQ(found.size(), 1u) << line.key;
    EXPECT_EQ(found[0].column, static_cast<int>(line.key.size()) + 4) << line.key;
    EXPECT_NE(found[0].message.find(line.key + ": "), std::string::npos) << found[0].message;
    EXPECT_NE(found[0].message.find("must be"), std::string::npos) << found[0].message;
  }
}

TEST(EveryKey, MisspeltIsOfferedBack) {
  for (const auto& line : lines_of_a_full_recipe()) {
    if (line.key.size() < 3) continue;
    const std::string slip = line.key + line.key.back();
    const auto found = problems_at(line, slip + " = " + line.value);
    ASSERT_EQ(found.size(), 1u) << line.key;
    EXPECT_EQ(found[0].column, 1);
    EXPECT_NE(found[0].message.find(slip + ": unknown key; did you mean " + line.key + "?"), std::string::npos)
        << found[0].message;
  }
}

TEST(EveryKey, QuantityWithoutUnitOrOfAnotherDimensionIsRefused) {
  int quantities = 0;
  for (const auto& line : lines_of_a_full_recipe()) {
    if (!is_quantity(line.value)) continue;
    ++quantities;
    const std::string number = line.value.substr(1, line.value.find(' ') - 1);
    const auto bare = problems_at(line, line.key + " = " + number);
    ASSERT_EQ(bare.size(), 1u) << line.key;
    EXPECT_NE(bare[0].message.find("has no unit; write it with its unit, for example"), std::string::npos)
        << bare[0].message;
    const auto other = problems_at(line, line.key + " = \"" + number + " K^3\"");
    ASSERT_EQ(other.size(), 1u) << line.key;
    EXPECT_NE(other[0].message.find("is a quantity in K^3, but"), std::string::npos) << other[0].message;
    EXPECT_EQ(problems_at(line, line.key + " = \"nan" + line.value.substr(line.value.find(' '))).size(), 1u)
        << line.key;
  }
  EXPECT_GE(quantities, 18);
}

}  // namespace
}  // namespace arenite::recipe
