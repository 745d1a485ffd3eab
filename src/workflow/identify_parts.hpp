#pragma once
#include <string>
#include <vector>

#include "thermal/identify/curve.hpp"
#include "thermal/identify/findings.hpp"
#include "io/laboratory_table.hpp"

/// What the three identifications share: columns that are labels, rows put together by them, and stated values.
namespace arenite::study {

namespace quantity {
inline const io::Quantity force{{"force", "f", "load"}, dimension::force, ""};
inline const io::Quantity displacement{{"displacement", "delta", "extension"}, dimension::length, ""};
inline const io::Quantity time{{"time", "t"}, dimension::time, ""};
}  // namespace quantity

/// The rows of one group, in the order of the file.
struct RowGroup {
  std::string name;
  std::vector<std::size_t> rows;
};

/// Rows by the column group, material, glue or diameter; one group without a name where there is none.
std::vector<RowGroup> groups_of(const io::LaboratoryTable& table);

/// What tells tests of a group apart: columns curve, specimen, test, load, repeat or cycle other than `taken`; "load_kN -3, repeat 1".
std::vector<RowGroup> tests_of(const io::LaboratoryTable& table, const RowGroup& group, std::optional<std::size_t> taken = {});

/// The columns of numbers of a table that has labels in its first column and a group in every other; empty if it is no such table.
std::vector<std::size_t> group_columns(const io::LaboratoryTable& table);

/// A test's record.
identify::Curve curve_of(const io::LaboratoryTable& table, const RowGroup& test, const std::vector<double>& x, const std::vector<double>& y);

/// Values by group, from a table of one value a row (`column`) or of a column a group.
struct ValueGroup {
  std::string name;
  std::vector<double> values;
  std::vector<std::string> tests;
  std::vector<int> lines;
};
std::vector<ValueGroup> value_groups(io::LaboratoryTable& table, const io::Quantity& quantity, const std::string& needs);

/// Puts what `file` states beside the findings of the same name: its first column names a group, or "all".
void compare_with_stated(const std::string& file, identify::Identification& found);

}  // namespace arenite::study
