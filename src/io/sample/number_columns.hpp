#pragma once
#include <array>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <vector>

#include "core/units.hpp"
#include "io/sample/sample.hpp"
#include "io/table/table.hpp"

namespace arenite::io {

/// A column of numbers, which need not be there: its value in a row in SI.
struct NumberColumn {
  const Table::Column* column = nullptr;
  std::size_t at = 0;
  double factor = 1;
  Problems* problems = nullptr;
  explicit operator bool() const { return column != nullptr; }
  double operator()(const Table::Row& row) const;
};
/// The first of these names that there is; `by_default` is the factor of a column without a unit.
NumberColumn find_number(const Table& table, std::initializer_list<std::string_view> names, Dimension dimension,
                         double by_default, Problems& problems);

/// A length; one in pixels, as `arenite grains` writes it where their width is not given, has their width for a factor.
NumberColumn find_length(const Table& table, std::initializer_list<std::string_view> names,
                         const SampleOptions& options, Problems& problems);
/// False, and a problem, where lengths are in pixels whose width is not known.
bool knows_pixels(const Table& table, const SampleOptions& options, Problems& problems);

/// A vector whose components are columns; without those along the axes of the sample it is not there.
struct VectorColumns {
  std::array<NumberColumn, 3> component;
  bool is_there = false;
  VectorColumns(const std::array<NumberColumn, 3>& columns, const std::vector<int>& axes);
  std::optional<Vec3> operator()(const Table::Row& row) const;
};

}  // namespace arenite::io
