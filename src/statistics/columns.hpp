#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "statistics/numbers.hpp"

namespace arenite::statistics {

/// Values in one order, along a loading or over states, cycles or results, with what they are and, where they have any,
/// the standard error of each.
struct Column {
  std::string name;
  Meaning meaning;
  std::vector<double> values, error;
  bool tells_errors = !error.empty();  ///< also where it has no rows
};

/// Columns of one length, by name.
struct Columns {
  std::vector<Column> list;

  /// Null where there is none.
  const Column* find(std::string_view name) const;
  bool has(std::string_view name) const { return find(name) != nullptr; }
  /// Values of a column that is there; throws NumbersError where it is not.
  const std::vector<double>& operator[](std::string_view name) const;
  void put(std::string name, const char* unit, const char* sentence, std::vector<double> values,
           std::vector<double> error = {});
};

}  // namespace arenite::statistics
