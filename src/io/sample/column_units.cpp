#include "io/sample/column_units.hpp"

#include <fmt/core.h>

#include "core/option.hpp"
#include "core/text.hpp"

namespace arenite::io {

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
