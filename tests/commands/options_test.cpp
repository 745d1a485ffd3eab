#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <sstream>

#include "support/program.hpp"

namespace {
using namespace arenite;
using test::arenite;

/// Options of a command whose value is a number, as its help lists them: "  --fps NUMBER".
std::set<std::string> options_with_a_number(const std::string& command) {
  std::istringstream help(arenite(command + " --help").out);
  static const std::regex numbered("^ +(?:-[a-z],)?(--[a-z-]+) (NUMBER|S|N|J|HZ|K|PX|DEG|FLOAT|UINT|INT)\\b.*");
  std::set<std::string> found;
  for (std::string line; std::getline(help, line);)
    if (std::smatch match; std::regex_match(line, match, numbered)) found.insert(match[1]);
  return found;
}

TEST(Options, NoNumberIsNan) {
  std::size_t options = 0;
  for (const char* command :
       {"run", "study", "verify", "load", "measure", "grains", "lockin", "step", "film", "camera", "animate", "watch"})
    for (const std::string& option : options_with_a_number(command))
      for (const char* value : {"nan", "-nan", "NAN"}) {
        const auto refused = arenite(std::string(command) + " " + option + "=" + value);
        EXPECT_EQ(refused.status, 2) << command << " " << option;
        EXPECT_TRUE(test::contains(refused.err, option)) << command << " " << option << ": " << refused.err;
        ++options;
      }
  EXPECT_GT(options, 60u);
  for (const char* known : {"run --checkpoint-every", "measure --border", "measure --load-axis", "animate --fps"})
    EXPECT_TRUE(test::contains(arenite(std::string(known) + "=nan").err, "no finite number")) << known;
}

}  // namespace
