#include "io/sample/column_units.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <utility>

#include "core/error.hpp"
#include "core/option.hpp"
#include "core/text.hpp"

namespace arenite::io {
namespace {

/// "# Units: mm" as "units" and "mm"; two empty texts for what is no comment of a name and what it is.
std::pair<std::string, std::string_view> statement_in(std::string_view comment) {
  comment = trimmed(comment);
  comment.remove_prefix(std::min(comment.find_first_not_of("#% \t"), comment.size()));
  const std::size_t at = comment.find_first_of(":=");
  if (at == comment.npos) return {};
  return {lower_case(trimmed(comment.substr(0, at))), comment.substr(at + 1)};
}

void give_unit(Table& table, std::initializer_list<std::string_view> names, const std::string& unit) {
  for (Table::Column& column : table.columns)
    if (column.unit.empty() && std::ranges::count(names, column.name) > 0) column.unit = unit;
}

}  // namespace

std::string unit_among(std::string_view words, Dimension dimension) {
  std::string blanks(words);
  std::ranges::replace_if(
      blanks, [](char c) { return c == ',' || c == ';' || c == '"'; }, ' ');
  for (const std::string_view word : split_blanks(blanks)) try {
      unit_factor(word, dimension);
      return std::string(word);
    } catch (const InputError&) {  // of something else
    }
  return {};
}

void take_units_of_comments(std::string_view text, const SampleOptions& options, Table& table) {
  Lines lines(text);
  for (std::string_view line; lines.next(line);) {
    if (trimmed(line).empty()) continue;
    if (trimmed(line).front() != '#' && trimmed(line).front() != '%') return;
    const auto [name, words] = statement_in(line);
    const bool of_all = name == "unit" || name == "units";
    if (!options.length_unit && (of_all || name == "length unit" || name == "length_unit"))
      give_unit(table, {"x", "y", "z", "radius", "r", "diameter", "d", "overlap"},
                unit_among(words, dimension::length));
    if (!options.force_unit && (of_all || name == "force unit" || name == "force_unit"))
      give_unit(table, {"fn", "ft", "fx", "fy", "fz"}, unit_among(words, dimension::force));
  }
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
