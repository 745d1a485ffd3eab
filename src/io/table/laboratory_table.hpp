#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/units.hpp"
#include "io/table/table.hpp"

namespace arenite::io {

/// What a column of a laboratory's table can hold.
struct Quantity {
  enum class Kind {
    plain,
    difference,           ///< of temperature: "C" counts as K
    absolute_temperature  ///< "C" is counted from absolute zero
  };
  std::vector<std::string_view> names;  ///< of the column, lower case, the first for messages
  Dimension dimension;
  std::string_view assumed;  ///< unit where the file names none; empty: SI
  Kind kind = Kind::plain;
};

/// A table of measurements: columns of quantities with their units, columns of labels. A column's unit stands in
/// brackets ("force [kN]"), in a row below the header, or behind its name ("force_kN", "surface_energy_kN_per_mm").
class LaboratoryTable {
 public:
  /// Throws InputError for a file that is no table.
  explicit LaboratoryTable(const std::string& file);
  LaboratoryTable(const LaboratoryTable&) = delete;
  LaboratoryTable& operator=(const LaboratoryTable&) = delete;

  const std::string& file() const { return file_; }
  std::size_t rows() const { return table_.rows.size(); }
  std::size_t columns() const { return table_.columns.size(); }
  int line(std::size_t row) const { return table_.rows[row].line; }
  int header_line() const { return table_.header_line; }
  const std::string& title(std::size_t column) const { return table_.columns[column].written; }
  std::string_view cell(std::size_t row, std::size_t column) const { return table_.rows[row].cells[column]; }

  std::optional<std::size_t> find(const Quantity& quantity) const;
  std::optional<std::size_t> find(std::initializer_list<std::string_view> names) const { return table_.find(names); }

  /// The column in SI, a row each; where an empty cell is no measurement, NaN. Throws InputError with all cells that
  /// are not numbers, and for a unit of another dimension.
  std::vector<double> values(std::size_t column, const Quantity& quantity, bool may_be_empty = false);

  /// Units that were assumed.
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  std::string file_, text_;
  Table table_;
  std::vector<std::string> notes_;
};

/// Levels and temperatures (K) of a calibration curve.
struct CalibrationCurve {
  std::vector<double> level, temperature;
};

/// From a CSV file with columns level and temperature, in K or, where the header says so, in degrees Celsius
/// ("temperature [C]"). Throws InputError with every bad row.
CalibrationCurve read_calibration_curve(const std::string& file);

}  // namespace arenite::io
