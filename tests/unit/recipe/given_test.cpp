#include "recipe/given.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "recipe/map_section.hpp"

namespace arenite::recipe {
namespace {

/// What is wrong with a map of these options, each as a command tells it.
std::vector<std::string> problems_of(const std::vector<std::pair<std::string, std::string>>& options) {
  MapSection map;
  std::vector<Given> given{{"file", "file", {.kind = Node::Kind::text, .text = "s.csv", .entries = {}}}};
  const RecordTable keys = every_key<MapSection>();
  for (const auto& [key, value] : options) {
    const auto dot = key.find('.');
    const std::string section = key.substr(0, dot);
    given.push_back({"--" + section + (dot == key.npos ? "" : ": " + key.substr(dot + 1)), key,
                     value_of(record_at(keys, key), value)});
  }
  std::vector<std::string> lines;
  try {
    read_given_into(map, given);
  } catch (const InputError& error) {
    for (const Problem& problem : error.problems()) lines.push_back(to_string(problem));
  }
  return lines;
}

using Lines = std::vector<std::string>;

TEST(Given, AKeyThatIsMissingIsTheOneThatIsNamed) {
  EXPECT_EQ(problems_of({{"cement.kind", "coating"}}),
            (Lines{"--cement: thickness: is missing; write for example thickness = \"1 mm\""}));
}

TEST(Given, AWrongValueIsToldUnderItsOption) {
  EXPECT_EQ(problems_of({{"cement.kind", "coating"}, {"cement.thickness", "-1 mm"}}).size(), 1u);
  EXPECT_TRUE(problems_of({{"voxels", "3"}}).at(0).starts_with("--voxels: 3 is out of range"));
}

}  // namespace
}  // namespace arenite::recipe
