#pragma once
#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/problems.hpp"
#include "core/units.hpp"

namespace arenite::io {

/// Text cut into rows of cells. Separator: that of a first line "sep=;" as spreadsheets write it, else comma, semicolon
/// or tab if the first row has one, else blanks. A cell may stand in double quotes. Lines that start with # or % and
/// empty lines are skipped. Decimal commas are read in quotes or where another sign separates the cells. Cells point
/// into the text, which must outlive the table.
struct Table {
  struct Row {
    int line = 0;
    std::vector<std::string_view> cells;
  };
  struct Column {
    std::string name;     ///< lower case
    std::string unit;     ///< "mm" from "x [mm]", "x (mm)" or a row of units below the header; or empty
    std::string written;  ///< the name as it was written
  };
  std::vector<Column> columns;                         ///< from the header; empty if there is none
  int header_line = 0;                                 ///< 0 if columns were given
  std::vector<Row> rows;                               ///< of data
  std::shared_ptr<std::deque<std::string>> rewritten;  ///< cells that are not as the text has them

  /// Index of the first column that has one of these names.
  std::optional<std::size_t> find(std::initializer_list<std::string_view> names) const;
};

/// Reads a table whose first row is a header, or where it is of numbers the comment above it, if that has as many
/// names; `columns` replaces a missing header ("id,x,y,-,radius"). Ragged rows, an empty file and a header that is
/// missing or says a column twice go to `problems`.
Table read_table(std::string_view text, const std::string& columns, Problems& problems);

/// The cells of a row, without blanks and quotes around them.
std::vector<std::string_view> split_cells(std::string_view row, char separator);

/// A cell of text as it is written, in quotes where a reader would take it for several, and behind an apostrophe where
/// a spreadsheet would compute it as a formula; `read_table` takes that apostrophe away.
std::string quoted_cell(const std::string& text);

/// The lines of a text without their ends, one after the other.
class Lines {
 public:
  explicit Lines(std::string_view text, int first_line = 1) : rest_(text), number_(first_line - 1) {}
  bool next(std::string_view& line);
  int number() const { return number_; }  ///< of the last line given, 1-based

 private:
  std::string_view rest_;
  int number_;
};

/// A whole finite number, with an exponent behind e or Fortran's d; empty otherwise ("nan" and "inf" are not numbers
/// here).
std::optional<double> to_number(std::string_view cell);
std::optional<std::int64_t> to_integer(std::string_view cell);

/// Whether a temperature in this unit counts from 0 degrees Celsius.
bool is_celsius(std::string_view unit);

/// Factor to SI of a unit that must have this dimension. Throws InputError without place.
double unit_factor(std::string_view unit, Dimension dimension);

/// The same of a column that names its unit, a problem at the header's line; `otherwise` where it names none.
double factor_or_problem(std::string_view unit, const std::string& column, Dimension dimension, double otherwise,
                         int line, Problems& problems);

/// `value` as a number in SI, or a problem at that line that names the column.
double number_or_problem(std::string_view cell, const std::string& column, double factor, int line, Problems& problems);
std::int64_t integer_or_problem(std::string_view cell, const std::string& column, int line, Problems& problems);

}  // namespace arenite::io
