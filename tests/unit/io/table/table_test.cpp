#include "io/table/table.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "io/table/text_file.hpp"
#include "support/pictures.hpp"
#include "support/temporary_folder.hpp"

namespace arenite::io {
namespace {

/// The numbers of all rows, and what is wrong.
std::pair<std::vector<double>, std::string> numbers_of(const std::string& text) {
  Problems problems("t.csv");
  const Table table = read_table(text, "", problems);
  std::vector<double> numbers;
  for (const auto& row : table.rows)
    for (const auto cell : row.cells) numbers.push_back(to_number(cell).value_or(-1));
  std::string complaint;
  try {
    problems.raise();
  } catch (const InputError& error) { complaint = to_string(error.problems().front()); }
  return {numbers, complaint};
}

const std::vector<double> values = {1, 12.5, -0.25};

TEST(Table, ASpreadsheetsSeparatorIsTaken) {
  EXPECT_EQ(numbers_of("sep=;\nid;x [mm];y\n1;12.5;-0.25\n").first, values);
  EXPECT_EQ(numbers_of("\"sep=\t\"\nid\tx\ty\n1\t12.5\t-0.25\n").first, values);
  EXPECT_EQ(numbers_of("sep=|\nid|x|y\n1|12.5|-0.25\n").first, values);
}

TEST(Table, DecimalCommasAreReadWhereTheyAreNothingElse) {
  EXPECT_EQ(numbers_of("id;x;y\n1;12,5;-0,25\n").first, values);
  EXPECT_EQ(numbers_of("id\tx\ty\n1\t1,25e1\t-0,25\n").first, values);
  EXPECT_EQ(numbers_of("id,x,y\n1,\"12,5\",\"-0,25\"\n").first, values);
  EXPECT_EQ(numbers_of("id;x\n1;0,125\n").first,
            (std::vector<double>{1, 0.125}));  // a semicolon says that commas are decimal
}

TEST(Table, CommasThatMaySetThousandsApartAreRefused) {
  EXPECT_NE(numbers_of("id x\n1 1,234\n")
                .second.find("t.csv:2: \"1,234\" may be a number with a decimal comma or with thousands"),
            std::string::npos);
  EXPECT_NE(numbers_of("id;x;y\n1;12,5;0.25\n").second.find("others have points"), std::string::npos);
  EXPECT_NE(numbers_of("id,x,y\n1,12,5,0,25\n").second.find("separate cells by semicolons"), std::string::npos);
}

TEST(Table, ACommentAboveNumbersIsTheirHeaderWhereItHasAsManyNames) {
  EXPECT_EQ(numbers_of("# id,x [mm],y\n1,12.5,-0.25\n"), std::pair(values, std::string()));
  EXPECT_EQ(numbers_of("% id x y\n1 12.5 -0.25\n"), std::pair(values, std::string()));
  EXPECT_EQ(numbers_of("# made today\n# id x y\n1,12.5,-0.25\n"), std::pair(values, std::string()));
  for (const char* comment : {"", "# made today\n", "# 1,2,3\n", "# id,x\n"})
    EXPECT_NE(numbers_of(comment + std::string("1,12.5,-0.25\n")).second.find("the first row must name the columns"),
              std::string::npos)
        << comment;
  EXPECT_NE(numbers_of("# x,x,y\n1,2,3\n").second.find("t.csv:1: column \"x\" appears twice"), std::string::npos);
  Problems problems("t.csv");
  const Table table = read_table("% first\n# id,x [mm]\n1,2\n", "", problems);
  EXPECT_EQ(table.header_line, 2);
  EXPECT_EQ(table.columns.at(1).name, "x");
  EXPECT_EQ(table.columns.at(1).unit, "mm");
}

TEST(Table, LinesThatBeginWithAPercentSignAreComments) {
  EXPECT_EQ(numbers_of("% made by MATLAB\nid,x,y\n% between\n1,12.5,-0.25\n"), std::pair(values, std::string()));
}

TEST(Table, OneThatIsPackedIsSaidToBeSo) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "t.csv.gz", std::ios::binary) << "\x1f\x8b\x08";
  EXPECT_NE(test::complaint([&] { read_text(folder / "t.csv.gz"); }).find("t.csv.gz: is compressed (gzip); unpack it"),
            std::string::npos);
}

TEST(Table, FortransExponentsAreNumbers) {
  EXPECT_EQ(numbers_of("id x y\n1 1.25D+01 -2.5d-1\n").first, values);
  EXPECT_FALSE(to_number("D5"));
  EXPECT_FALSE(to_number("1d"));
}

TEST(Table, TextOfOtherEncodingsBecomesUtf8) {
  const std::string header = "id,x [\xC2\xB5m]\n";
  EXPECT_EQ(as_utf8("id,x [\xB5m]\n"), header);                                // Latin-1
  EXPECT_EQ(as_utf8("\xEF\xBB\xBF" + header), header);                         // UTF-8 with its mark
  EXPECT_EQ(as_utf8(std::string("\xFF\xFEx\0\xB5\0\n\0", 8)), "x\xC2\xB5\n");  // UTF-16
  EXPECT_EQ(as_utf8(std::string("\xFE\xFF\0x\0\xB5\0\n", 8)), "x\xC2\xB5\n");
  EXPECT_EQ(as_utf8(std::string("\xFF\xFE\x3D\xD8\x00\xDE", 6)), "\xF0\x9F\x98\x80");  // two halves of one character
  EXPECT_EQ(as_utf8("id\r1\r"), "id\n1\n");
  EXPECT_DOUBLE_EQ(unit_factor("\xC2\xB5m", dimension::length), 1e-6);
}

TEST(Table, AFormulaIsKeptFromSpreadsheetsAndReadBackAsItWas) {
  EXPECT_EQ(quoted_cell("=1+1"), "'=1+1");
  EXPECT_EQ(quoted_cell("@SUM(A1,2)"), "\"'@SUM(A1,2)\"");
  EXPECT_EQ(quoted_cell("-2+cmd|' /C calc'!A0"), "'-2+cmd|' /C calc'!A0");
  for (const char* plain : {"-0.5", "+-3", "-", "POM", "'tis", ""}) EXPECT_EQ(quoted_cell(plain), plain);
  for (const std::string text : {"=1+1", "@SUM(A1,2)", "+f(1)"})
    EXPECT_EQ(split_cells("a," + quoted_cell(text) + ",b", ',').at(1), text);
}

}  // namespace
}  // namespace arenite::io
