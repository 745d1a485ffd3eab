#include "io/sample/number_columns.hpp"

#include <algorithm>

#include "core/option.hpp"

namespace arenite::io {
namespace {

bool is_in_pixels(const Table::Column& column) { return column.unit == "px"; }

}  // namespace

double NumberColumn::operator()(const Table::Row& row) const {
  return number_or_problem(row.cells[at], column->name, factor, row.line, *problems);
}

NumberColumn find_number(const Table& table, std::initializer_list<std::string_view> names, Dimension dimension,
                         double by_default, Problems& problems) {
  const auto at = table.find(names);
  if (!at) return {};
  const auto& column = table.columns[*at];
  return {&column, *at, factor_or_problem(column.unit, column.name, dimension, by_default, table.header_line, problems),
          &problems};
}

NumberColumn find_length(const Table& table, std::initializer_list<std::string_view> names,
                         const SampleOptions& options, Problems& problems) {
  if (const auto at = table.find(names); at && is_in_pixels(table.columns[*at]))
    return {&table.columns[*at], *at, options.pixel, &problems};
  return find_number(table, names, dimension::length, options.length(), problems);
}

bool knows_pixels(const Table& table, const SampleOptions& options, Problems& problems) {
  if (options.pixel > 0 || std::ranges::none_of(table.columns, is_in_pixels)) return true;
  problems.add(table.header_line,
               "lengths are in pixels (px), whose width on the sample is not known; give it to `arenite measure` by "
               "{0}, for example {0} \"1.6 mm\", or to `arenite grains`, which then writes the table in mm",
               option("pixel"));
  return false;
}

VectorColumns::VectorColumns(const std::array<NumberColumn, 3>& columns, const std::vector<int>& axes)
    : component(columns),
      is_there(std::ranges::all_of(axes, [&](int axis) { return bool(columns[axis]); })) {}

std::optional<Vec3> VectorColumns::operator()(const Table::Row& row) const {
  if (!is_there) return std::nullopt;
  return by_axis<3>([&](int axis) { return component[axis] ? component[axis](row) : 0.0; });
}

}  // namespace arenite::io
