#pragma once
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "io/table/laboratory_table.hpp"
#include "thermal/identify/curve.hpp"
#include "thermal/identify/findings.hpp"

namespace arenite::workflow::quantity {

inline const io::Quantity force{{"force", "f", "load"}, dimension::force, ""};
inline const io::Quantity displacement{{"displacement", "delta", "extension"}, dimension::length, ""};
inline const io::Quantity time{{"time", "t"}, dimension::time, ""};

}  // namespace arenite::workflow::quantity

namespace arenite::workflow {

/// The rows of one group, in the order of the file.
struct RowGroup {
  std::string name;
  std::vector<std::size_t> rows;
};

/// Rows by the column group, material, glue or diameter; one group without a name where there is none.
std::vector<RowGroup> groups_of(const io::LaboratoryTable& table);

/// The records of a group, one a test.
struct RecordGroup {
  std::string name;
  std::vector<identify::Curve> tests;
};
/// The tests of a group by name, each with what it measured.
struct TestGroup {
  std::string name;
  std::vector<std::pair<std::string, statistics::Measured>> tests;
};
/// What is said of a value that is not above 0.
using Refusal = std::function<std::string(const std::string& group, const std::string& test, double value)>;
/// How the tests of a file are found: in `records` of force against the first of these quantities that it has, each
/// group of them by `cut`; or as values that it holds, one a row, or a column a group. A file of neither kind is
/// refused by what it `needs`.
struct TestsWanted {
  std::vector<io::Quantity> against;
  std::function<decltype(TestGroup::tests)(const RecordGroup&)> cut;
  io::Quantity tabulated;
  const char* needs;
  Refusal refusal;
};
std::vector<TestGroup> tests_in(io::LaboratoryTable& table, const TestsWanted& wanted);

/// Adds the table's notes to what was found, and puts what the file `stated` (or none) says beside the findings of the
/// same name: its first column names a group, or "all".
identify::Identification finished(identify::Identification found, const io::LaboratoryTable& table,
                                  const std::string& stated);

}  // namespace arenite::workflow
