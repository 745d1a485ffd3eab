#pragma once
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "core/problems.hpp"
#include "core/units.hpp"
#include "io/sample/sample.hpp"
#include "io/table/table.hpp"

namespace arenite::io {

/// Gives lengths and forces without a unit of their own that which a comment above the table states, "# units: mm, N"
/// or "# length unit = mm", unless the options give another.
void take_units_of_comments(std::string_view text, const SampleOptions& options, Table& table);

/// Which of the columns of a table that have a dimension state their unit. In one file some may and others not: SI is
/// then easily taken for what is in mm like the rest.
class StatedColumns {
 public:
  explicit StatedColumns(const Table& table) : table_(table) {}

  /// Columns that are each for themselves; `chosen`: an option gives the unit of those that state none.
  void see(std::initializer_list<std::string_view> names, bool chosen);
  /// Components of a vector: a problem unless all or none state their unit.
  void see_vector(std::initializer_list<std::string_view> names, bool chosen, Problems& problems);

  bool are_mixed() const { return !bare_.empty() && !stated_.empty(); }
  /// Says, where they are, that SI was taken for those without.
  void tell(std::vector<std::string>& notes) const;

 private:
  const Table& table_;
  std::vector<std::string> bare_, stated_;
};

}  // namespace arenite::io
