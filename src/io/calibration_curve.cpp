#include "io/calibration_curve.hpp"

#include <fmt/format.h>

#include "core/problems.hpp"
#include "io/read_file.hpp"
#include "io/table.hpp"

namespace arenite::io {

CalibrationCurve read_calibration_curve(const std::string& file) {
  const std::string text = read_file(file);
  Problems problems(file);
  const Table table = read_table(text, "", problems);
  const auto level = table.find({"level", "dl", "digital_level"}), temperature = table.find({"temperature", "t"});
  if (!level || !temperature) problems.add(table.header_line, "has no columns level and temperature; name them in the first line");
  problems.raise();
  const std::string& unit = table.columns[*temperature].unit;
  const bool celsius = is_celsius(unit);
  if (!celsius && !unit.empty() && unit != "K") problems.add(table.header_line, fmt::format("gives temperatures in \"{}\"; write K or C", unit));
  CalibrationCurve curve;
  for (const auto& row : table.rows) {
    curve.level.push_back(number_or_problem(row.cells[*level], "level", 1, row.line, problems));
    curve.temperature.push_back(number_or_problem(row.cells[*temperature], "temperature", 1, row.line, problems) + (celsius ? 273.15 : 0));
  }
  problems.raise();
  return curve;
}

}  // namespace arenite::io
