#include "core/option.hpp"

#include <gtest/gtest.h>

namespace arenite {
namespace {

std::string in_brackets(std::string_view name) { return "<" + std::string(name) + ">"; }

TEST(Option, IsWordedByTheFaceOfTheProcess) {
  const std::string usual = option("frame-rate");
  EXPECT_EQ(usual, "--frame-rate");
  word_options(in_brackets);
  EXPECT_EQ(option("frame-rate"), "<frame-rate>");
  word_options([](std::string_view name) { return "--" + std::string(name); });
  EXPECT_EQ(option("frame-rate"), usual);
}

}  // namespace
}  // namespace arenite
