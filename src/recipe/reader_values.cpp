#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "core/error.hpp"
#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
#include "io/table/table.hpp"
#include "recipe/reader.hpp"

namespace arenite::recipe {
namespace {

bool is_number(const Node& node) { return node.kind == Node::Kind::integer || node.kind == Node::Kind::real; }
double number_in(const Node& node) { return node.kind == Node::Kind::integer ? static_cast<double>(node.integer) : node.real; }

std::string as_written(const Node& node) {
  if (node.kind == Node::Kind::text) return "\"" + node.text + "\"";
  return node.kind == Node::Kind::integer ? std::to_string(node.integer) : format_quantity(node.real, "");
}

/// The entry of a table that must hold just one; of several, an override wins over the file.
const Entry* only_entry(const Node& table) {
  if (table.entries.size() == 1) return &table.entries.front();
  const auto last = std::find_if(table.entries.rbegin(), table.entries.rend(), [](const Entry& entry) { return entry.place.wins; });
  return last == table.entries.rend() ? nullptr : &*last;
}

/// The form that a quantity without its tag could be meant for, by its dimension.
std::string tag_of_quantity(const std::string& text, const std::vector<Form>& forms) {
  for (const auto& form : forms) {
    if (form.unit.empty()) continue;
    try {
      parse_si(text, parse_unit(form.unit).dimension);
      return std::string(form.word);
    } catch (const InputError&) {
      // Of another dimension, or no quantity.
    }
  }
  return {};
}

}  // namespace

std::optional<double> RecipeReader::read_number(const Node& node, const std::string& path, std::string_view unit, const Range& range) {
  const Dimension wanted = unit.empty() ? dimension::none : parse_unit(unit).dimension;
  const auto wrong = [&](const std::string& message) -> std::optional<double> {
    problem(node.place, path, message);
    return std::nullopt;
  };
  double value = 0;
  if (node.kind == Node::Kind::text) {
    try {
      value = parse_si(node.text, wanted, unit);
    } catch (const InputError& error) { return wrong(error.what()); }
  } else {
    const std::string example = unit.empty() ? "0.5" : fmt::format("\"1 {}\"", unit);
    if (!is_number(node)) return wrong(fmt::format("is {}, but must be a number, such as {}", kind_name(node), example));
    value = number_in(node);
    if (!std::isfinite(value)) return wrong("must be a finite number");
    if (!is_in_reach(value)) return wrong(fmt::format("{} is beyond the range of numbers; write 0 or a magnitude from 1e-60 to 1e60", as_written(node)));
    if (unit == "deg")
      return wrong(fmt::format("{} has no unit; write an angle with its unit, for example \"90 deg\" (of a part of a cycle 360 times as much: \"{:.6g} deg\")",
                               as_written(node), 360 * value));
    if (wanted != dimension::none) return wrong(fmt::format("{0} has no unit; write it with its unit, for example \"{0} {1}\"", as_written(node), unit));
  }
  return range.contains(value) ? value : wrong(fmt::format("{} is out of range; it must be {}", as_written(node), to_string(range, unit)));
}

void RecipeReader::number(const Key& key, std::optional<double>& value, std::string_view unit, const Range& range) {
  const Node* node = take(key, unit.empty() ? "1" : fmt::format("\"1 {}\"", unit));
  if (!node) return;
  const auto read = read_number(*node, path_of(key.name), unit, range);
  if (read) value = read;
  else failed_.emplace(key.name);
}

void RecipeReader::integer(const Key& key, std::optional<std::int64_t>& value, const IntegerRange& range) {
  const Node* node = take(key, "1");
  if (!node) return;
  const bool is_whole = node->kind == Node::Kind::real && std::floor(node->real) == node->real && std::abs(node->real) < 1e15;
  if (node->kind != Node::Kind::integer && !is_whole) {
    return refuse(
        key, node->place,
        is_number(*node) ? fmt::format("{} is not a whole number", as_written(*node)) : fmt::format("is {}, but must be a whole number", kind_name(*node)));
  }
  const std::int64_t read = is_whole ? static_cast<std::int64_t>(node->real) : node->integer;
  if (read < range.min || read > range.max) return refuse(key, node->place, fmt::format("{} is out of range; it must be {}", read, to_string(range)));
  value = read;
}

void RecipeReader::flag(const Key& key, bool& value) {
  if (const Node* node = take(key, "true", Node::Kind::flag, "true or false (without quotes)")) value = node->flag;
}

void RecipeReader::text(const Key& key, std::string& value) {
  if (const Node* node = take(key, "\"...\"", Node::Kind::text, "a text in quotes")) value = node->text;
}

void RecipeReader::file(const Key& key, std::string& value) {
  text(key, value);
  const Entry* entry = table_.find(key.name);
  if (!entry || !reading_.look_for_files || failed_.count(key.name) > 0) return;
  std::error_code error;
  const auto place = std::filesystem::path(reading_.folder) / value;
  if (!std::filesystem::is_regular_file(place, error)) {
    refuse(key, entry->value.place, fmt::format("there is no file \"{}\"; paths are relative to the folder of the recipe", value));
  }
}

template <class T, class Read> void RecipeReader::read_items(const Key& key, const Node& list, std::vector<T>& values, Read read) {
  values.clear();
  for (std::size_t i = 0; i < list.items.size(); ++i) {
    const std::optional<T> item = read(list.items[i], fmt::format("{}.{}", path_of(key.name), i));
    if (item) values.push_back(*item);
    else failed_.emplace(key.name);
  }
}

void RecipeReader::numbers(const Key& key, std::vector<double>& values, std::string_view unit, const Range& range) {
  const Node* node = take(key, unit.empty() ? "[1, 2]" : fmt::format("[\"1 {0}\", \"2 {0}\"]", unit), Node::Kind::array, "a list");
  if (node) read_items(key, *node, values, [&](const Node& item, const std::string& path) { return read_number(item, path, unit, range); });
}

void RecipeReader::pairs(const Key& key, std::vector<std::pair<std::int32_t, std::int32_t>>& values) {
  const auto is_index = [](const Node& n) { return n.kind == Node::Kind::integer && n.integer >= 0 && n.integer <= INT32_MAX; };
  const auto pair = [&](const Node& item, const std::string&) -> std::optional<std::pair<std::int32_t, std::int32_t>> {
    if (item.kind == Node::Kind::array && item.items.size() == 2 && std::ranges::all_of(item.items, is_index) && item.items[0].integer != item.items[1].integer)
      return std::pair(static_cast<std::int32_t>(item.items[0].integer), static_cast<std::int32_t>(item.items[1].integer));
    refuse(key, item.place, "each pair must be two different grain indices from 0, such as [0, 1]");
    return std::nullopt;
  };
  if (const Node* node = take(key, "[[0, 1], [1, 2]]", Node::Kind::array, "a list of pairs")) read_items(key, *node, values, pair);
}

void RecipeReader::read_rows(const Key& key, const Node& list, std::vector<Vec2>& values, std::array<std::string_view, 2> unit, const std::string& wanted) {
  read_items(key, list, values, [&](const Node& item, const std::string& path) -> std::optional<Vec2> {
    if (item.kind != Node::Kind::array || item.items.size() != 2) {
      refuse(key, item.place, wanted);
      return std::nullopt;
    }
    const auto x = read_number(item.items[0], path + ".0", unit[0], range::any), y = read_number(item.items[1], path + ".1", unit[1], range::any);
    return x && y ? std::optional(Vec2{*x, *y}) : std::nullopt;
  });
}

void RecipeReader::points(const Key& key, std::vector<Vec2>& values, std::string_view unit) {
  const std::string example = fmt::format("[[\"0 {0}\", \"0 {0}\"], [\"1 {0}\", \"2 {0}\"]]", unit);
  if (const Node* node = take(key, example, Node::Kind::array, "a list of points"))
    read_rows(key, *node, values, {unit, unit}, fmt::format("each point must be two numbers, x and y, such as {}", example));
}

void RecipeReader::series(const Key& key, std::vector<Vec2>& values, std::string_view unit) {
  const std::string value = unit.empty() ? "1" : fmt::format("\"1 {}\"", unit), example = fmt::format("[[\"0 s\", {0}], [\"1 s\", {0}]]", value);
  const Node* node = take(key, example);
  if (!node) return;
  values.clear();
  if (node->kind == Node::Kind::text) return read_series(key, *node, values, unit);
  if (node->kind != Node::Kind::array)
    return refuse(key, node->place, fmt::format("is {}, but must be a list such as {} or the name of a CSV file", kind_name(*node), example));
  read_rows(key, *node, values, {"s", unit}, fmt::format("each row must be a time and a value, such as {}", example));
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
  } catch (const InputError& error) { refuse(key, file.place, error.what()); }
}

void RecipeReader::choice(const Key& key, int& index, const std::vector<Word>& words) {
  const auto names = mapped<std::string>(words, &Word::word);
  const Node* node = take(key, "\"" + names.front() + "\"", Node::Kind::text, "one of: " + list_of(names));
  if (!node) return;
  const auto found = std::find(names.begin(), names.end(), node->text);
  if (found == names.end()) {
    const std::string near = nearest(node->text, names);
    return refuse(key, node->place,
                  fmt::format("unknown word \"{}\"; {}it must be one of: {}", node->text, near.empty() ? "" : fmt::format("did you mean \"{}\"? ", near),
                              list_of(names)));
  }
  index = static_cast<int>(found - names.begin());
}

void RecipeReader::tagged(const Key& key, int& form, double& value, const std::vector<Form>& forms) {
  const auto ways = mapped(
      forms, [](const Form& each) { return each.unit.empty() ? fmt::format("\"{}\"", each.word) : fmt::format("{{ {} = \"1 {}\" }}", each.word, each.unit); });
  const Node* node = take(key, ways.front());
  if (!node) return;
  const bool is_bare = node->kind == Node::Kind::text;
  const Entry* const only = node->kind == Node::Kind::table ? only_entry(*node) : nullptr;
  if (!is_bare && !only) return refuse(key, node->place, "must be one of: " + list_of(ways));
  const std::string& word = is_bare ? node->text : only->key;
  const std::string path = path_of(key.name) + "." + word;
  for (std::size_t i = 0; i < forms.size(); ++i) {
    if (forms[i].unit.empty() != is_bare || forms[i].word != word) continue;
    const std::optional<double> read = is_bare ? 0 : read_number(only->value, path, forms[i].unit, forms[i].range);
    if (!read) return void(failed_.emplace(key.name));
    form = static_cast<int>(i);
    value = *read;
    return;
  }
  std::vector<std::string> alike;
  for (const auto& each : forms)
    if (each.unit.empty() == is_bare) alike.emplace_back(each.word);
  const std::string near = nearest(word, alike);
  if (is_bare) {
    const std::string tag = tag_of_quantity(word, forms);
    return refuse(key, node->place,
                  !tag.empty()   ? fmt::format("write {{ {} = \"{}\" }}", tag, word)
                  : near.empty() ? fmt::format("unknown word \"{}\"; write one of: {}", word, list_of(ways))
                                 : fmt::format("unknown word \"{}\"; did you mean \"{}\"?", word, near));
  }
  failed_.emplace(key.name);
  problem(only->place, path, near.empty() ? "unknown key; write one of: " + list_of(ways) : fmt::format("unknown key; did you mean {}?", near));
}

}  // namespace arenite::recipe
