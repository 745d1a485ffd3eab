#include "io/table/laboratory_table.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>

#include "core/unit_names.hpp"
#include "io/table/comment_units.hpp"
#include "io/table/table.hpp"
#include "io/table/text_file.hpp"

namespace arenite::io {
namespace {

/// The unit behind a name, "kN/mm" of "surface_energy_kN_per_mm"; empty if there is none of this dimension.
std::string unit_behind(const Table::Column& column, std::string_view name, const Quantity& quantity) {
  if (column.name.size() <= name.size() + 1 || !column.name.starts_with(name) || column.name[name.size()] != '_')
    return {};
  std::string unit = column.written.substr(name.size() + 1);
  if (const auto per = unit.find("_per_"); per != std::string::npos) unit.replace(per, 5, "/");
  if (quantity.dimension == dimension::temperature && is_celsius(unit)) return unit;
  try {
    return parse_unit(unit).dimension == quantity.dimension ? unit : "";
  } catch (const InputError&) { return {}; }
}

std::string unit_of(const Table::Column& column, const Quantity& quantity) {
  if (!column.unit.empty()) return column.unit;
  for (const auto name : quantity.names)
    if (auto unit = unit_behind(column, name, quantity); !unit.empty()) return unit;
  return {};
}

}  // namespace

LaboratoryTable::LaboratoryTable(const std::string& file) : file_(file), text_(read_text(file)) {
  Problems problems(file);
  table_ = read_table(text_, "", problems);
  problems.raise();
  if (table_.rows.empty())
    throw InputError(file, table_.header_line, "has a header but no rows; give one row per measurement");
}

std::optional<std::size_t> LaboratoryTable::find(const Quantity& quantity) const {
  for (const auto name : quantity.names)
    for (std::size_t c = 0; c < columns(); ++c)
      if (table_.columns[c].name == name || !unit_behind(table_.columns[c], name, quantity).empty()) return c;
  return std::nullopt;
}

std::vector<double> LaboratoryTable::values(std::size_t column, const Quantity& quantity, bool may_be_empty) {
  Problems problems(file_);
  double factor = 1, offset = 0;
  std::string unit = unit_of(table_.columns[column], quantity);
  if (unit.empty() && !(quantity.dimension == dimension::none)) unit = unit_of_comments(text_, "", quantity.dimension);
  if (unit.empty() && !(quantity.dimension == dimension::none)) {
    unit = quantity.assumed.empty() ? si_unit(quantity.dimension) : std::string(quantity.assumed);
    const std::string note =
        fmt::format("the file states no unit of {}, so {} was assumed; a header such as \"{} [{}]\" changes this",
                    title(column), unit, title(column), unit);
    if (std::find(notes_.begin(), notes_.end(), note) == notes_.end()) notes_.push_back(note);
  }
  if (quantity.dimension == dimension::temperature && is_celsius(unit)) {
    offset = quantity.kind == Quantity::Kind::absolute_temperature ? 273.15 : 0;
  } else {
    factor = factor_or_problem(unit, title(column), quantity.dimension, 1, table_.header_line, problems);
  }
  std::vector<double> values;
  for (const auto& row : table_.rows) {
    const std::string_view text = row.cells[column];
    const bool empty = may_be_empty && (text.empty() || text == "-");
    values.push_back(empty ? std::numeric_limits<double>::quiet_NaN()
                           : number_or_problem(text, title(column), factor, row.line, problems) + offset);
  }
  problems.raise();
  return values;
}

CalibrationCurve read_calibration_curve(const std::string& file) {
  LaboratoryTable table(file);
  const Quantity levels{{"level", "dl", "digital_level"}, dimension::none, {}};
  const Quantity temperatures{{"temperature", "t"}, dimension::temperature, "K", Quantity::Kind::absolute_temperature};
  const auto level = table.find(levels), temperature = table.find(temperatures);
  if (!level || !temperature)
    throw InputError(file, table.header_line(), "has no columns level and temperature; name them in the first line");
  return {table.values(*level, levels), table.values(*temperature, temperatures)};
}

}  // namespace arenite::io
