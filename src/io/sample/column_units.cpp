#include "io/sample/column_units.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>

#include "core/option.hpp"
#include "core/text.hpp"
#include "io/table/comment_units.hpp"

namespace arenite::io {
namespace {

void give_unit(Table& table, std::initializer_list<std::string_view> names, const std::string& unit) {
  for (Table::Column& column : table.columns)
    if (column.unit.empty() && std::ranges::count(names, column.name) > 0) column.unit = unit;
}

}  // namespace

void take_units_of_comments(std::string_view text, const SampleOptions& options, Table& table) {
  if (!options.length_unit)
    give_unit(table, {"x", "y", "z", "radius", "r", "diameter", "d", "overlap"},
              unit_of_comments(text, "length", dimension::length));
  if (!options.force_unit)
    give_unit(table, {"fn", "ft", "fx", "fy", "fz"}, unit_of_comments(text, "force", dimension::force));
}

void StatedColumns::see(std::initializer_list<std::string_view> names, bool chosen) {
  for (const std::string_view name : names)
    if (const auto at = table_.find({name})) {
      const Table::Column& column = table_.columns[*at];
      if (!column.unit.empty()) stated_.push_back(column.name);
      else if (!chosen) bare_.push_back(column.name);
    }
}

void StatedColumns::see_vector(std::initializer_list<std::string_view> names, bool chosen, Problems& problems) {
  StatedColumns own(table_);
  own.see(names, chosen);
  if (own.are_mixed())
    problems.add(table_.header_line,
                 "a unit is stated for {} and none for {}, which is the same vector; give it for all",
                 list_of(own.stated_), list_of(own.bare_));
  see(names, chosen);
}

void StatedColumns::tell(std::vector<std::string>& notes) const {
  if (!are_mixed()) return;
  notes.push_back(
      fmt::format("No unit is stated for {}, while one is for {}: SI (m, N) was assumed; {}, {} or a header such as "
                  "\"{} [...]\" changes this.",
                  list_of(bare_), list_of(stated_), option("length-unit"), option("force-unit"), bare_.front()));
}

}  // namespace arenite::io
