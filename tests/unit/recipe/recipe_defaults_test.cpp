#include <gtest/gtest.h>

#include <set>
#include <sstream>
#include <string>

#include "io/disk/file.hpp"
#include "recipe/film_recipe.hpp"
#include "recipe/recipe.hpp"

namespace arenite::recipe {
namespace {

std::string between(const std::string& line, const std::string& begin, const std::string& end, std::size_t& at) {
  const std::size_t from = line.find(begin, at);
  if (from == std::string::npos) return {};
  const std::size_t to = line.find(end, from + begin.size());
  at = to;
  return line.substr(from + begin.size(), to - from - begin.size());
}

/// "run [contact] friction = 0.3" of every key with a default in a reference's tables.
void add_defaults(const std::string& kind, const std::string& reference, std::set<std::string>& found) {
  std::istringstream lines(reference);
  std::string section = "-";
  for (std::string line; std::getline(lines, line);) {
    std::size_t at = 0;
    if (line.starts_with("## `")) section = between(line, "`", "`", at);
    if (!line.starts_with("| `")) continue;
    const std::string key = between(line, "`", "` | ", at);
    at = line.find(" | ", at + 3);
    std::string value = between(line, " | ", " | ", at);
    if (value.starts_with("`"))
      found.insert(kind + " " + section + " " + key + " = " + value.substr(1, value.size() - 2));
  }
}

/// Names of results follow from what differs from the defaults, so a default must not change silently.
TEST(RecipeDefaults, AreThoseThatNamesOfResultsAreMadeWith) {
  std::set<std::string> now;
  add_defaults("run", key_reference(), now);
  add_defaults("film", film_key_reference(), now);
  std::istringstream then(io::read_file(ARENITE_SOURCE_DIR "/tests/unit/recipe/defaults_of_names.txt"));
  std::size_t count = 0;
  for (std::string line; std::getline(then, line); ++count)
    EXPECT_TRUE(now.contains(line))
        << "was the default: " << line
        << "\nraise the versions in src/workflow/stage_keys.cpp, then change defaults_of_names.txt";
  EXPECT_GT(count, 100u);
}

}  // namespace
}  // namespace arenite::recipe
