#include "core/text.hpp"

#include <gtest/gtest.h>

#include <array>
#include <nlohmann/json.hpp>

#include "core/random.hpp"

namespace arenite {
namespace {

/// A quoted text is JSON if it is UTF-8, says another reader; what else a text may hold is a blank for it.
bool is_utf8_in_json(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == '"' || c == '\\') c = ' ';
  return nlohmann::json::accept("\"" + text + "\"");
}

TEST(Utf8, IsToldFromOtherBytes) {
  for (const char* text :
       {"", "plain", "Gr\xc3\xbc\xc3\x9f", "\xe2\x82\xac", "\xf0\x9f\x98\x80", "\xef\xbf\xbf", "\xf4\x8f\xbf\xbf"})
    EXPECT_TRUE(is_utf8(text)) << text;
  for (const char* text : {"\x80", "\xff", "\xc3", "a\xe2\x82", "\xc0\xaf", "\xe0\x80\xaf", "\xf0\x80\x80\xaf",
                           "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xc3z"})
    EXPECT_FALSE(is_utf8(text)) << text;
}

TEST(Utf8, IsTheSameToAReaderOfJson) {
  for (int first = 0; first < 256; ++first)
    for (int second = 0; second < 256; ++second) {
      const std::string text{static_cast<char>(first), static_cast<char>(second)};
      ASSERT_EQ(is_utf8(text), is_utf8_in_json(text)) << first << " " << second;
    }
  RandomStream random(1, Purpose::test);
  for (int k = 0; k < 20000; ++k) {
    std::string text(1, static_cast<char>(0xe0 + static_cast<int>(random.below(0x18))));
    for (int n = 0; n < 3; ++n) text += static_cast<char>(0x7c + static_cast<int>(random.below(0x48)));
    ASSERT_EQ(is_utf8(text), is_utf8_in_json(text)) << k;
  }
}

TEST(Printable, ShowsWhatATerminalWouldObey) {
  EXPECT_EQ(printable("µm: 3 ± 1\tand\n"), "µm: 3 ± 1\tand\n");
  EXPECT_EQ(printable("\x1b]0;title\x07 \x1b[2J"), "␛]0;title␇ ␛[2J");
  EXPECT_EQ(printable("a\rb\x7f"), "a␍b␡");
  EXPECT_EQ(printable("g\u202excod.csv \u2067"), "g\ufffdxcod.csv \ufffd");
  EXPECT_EQ(printable("\xc2\x9b"
                      "31m"),
            "\xef\xbf\xbd"
            "31m");  // one character that begins what escape and [ begin
  EXPECT_EQ(printable("\x9b"
                      "31m \xff"),
            "\xef\xbf\xbd"
            "31m \xef\xbf\xbd");
}

TEST(ListOf, PutsWordsOneAfterTheOther) {
  EXPECT_EQ(list_of(std::vector<std::string>{}), "");
  EXPECT_EQ(list_of(std::vector<std::string>{"one"}), "one");
  EXPECT_EQ(list_of(std::vector<std::string>{"", "two", ""}), ", two, ");
  EXPECT_EQ(list_of(std::array{"one", "two", "three"}, " "), "one two three");
}

}  // namespace
}  // namespace arenite
