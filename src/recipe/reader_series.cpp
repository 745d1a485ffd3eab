#include <fmt/format.h>

#include <filesystem>

#include "core/error.hpp"
#include "core/units.hpp"
#include "io/table/table.hpp"
#include "recipe/reader.hpp"

namespace arenite::recipe {

void RecipeReader::series(const Key& key, std::vector<Vec2>& values, std::string_view unit) {
  const std::string value = unit.empty() ? "1" : fmt::format("\"1 {}\"", unit), example = fmt::format("[[\"0 s\", {0}], [\"1 s\", {0}]]", value);
  const Node* node = take(key, fmt::format("{} = {}", key.name, example));
  if (!node) return;
  values.clear();
  if (node->kind == Node::Kind::text) return read_series(key, *node, values, unit);
  if (node->kind != Node::Kind::array)
    return refuse(key, *node, fmt::format("is {}, but must be a list such as {} or the name of a CSV file", kind_name(*node), example));
  for (std::size_t i = 0; i < node->items.size(); ++i) {
    const Node& item = node->items[i];
    const std::string path = fmt::format("{}.{}", path_of(key.name), i);
    if (item.kind != Node::Kind::array || item.items.size() != 2) {
      refuse(key, item, fmt::format("each row must be a time and a value, such as {}", example));
      continue;
    }
    const auto x = read_number(item.items[0], path + ".0", "s", range::any), y = read_number(item.items[1], path + ".1", unit, range::any);
    if (x && y) values.push_back({*x, *y});
    else failed_.emplace(key.name);
  }
}

void RecipeReader::read_series(const Key& key, const Node& file, std::vector<Vec2>& values, std::string_view unit) {
  const auto place = (std::filesystem::path(reading_.folder) / file.text).string();
  try {
    io::LaboratoryTable table(place);
    if (table.columns() != 2) throw InputError(place, table.header_line(), fmt::format("has {} columns; a programme has two, time and value", table.columns()));
    const Dimension dimension = unit.empty() ? dimension::none : parse_unit(unit).dimension;
    const auto x = table.values(0, {{"time"}, dimension::time, "s"}), y = table.values(1, {{table.title(1)}, dimension, unit});
    for (std::size_t row = 0; row < x.size(); ++row) values.push_back({x[row], y[row]});
    for (const std::string& note : table.notes()) reading_.notices.push_back(fmt::format("{}: {}", place, note));
  } catch (const InputError& error) { refuse(key, file, error.what()); }
}

}  // namespace arenite::recipe
