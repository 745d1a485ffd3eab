#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/problems.hpp"
#include "core/units.hpp"
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
  const Entry* last = nullptr;
  for (const auto& entry : table.entries) {
    if (entry.place.wins) last = &entry;
  }
  return last;
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
  double value = 0;
  if (node.kind == Node::Kind::text) {
    try {
      value = parse_si(node.text, wanted, unit);
    } catch (const InputError& error) {
      problem(node.place, path, error.what());
      return std::nullopt;
    }
  } else if (!is_number(node)) {
    const std::string example = unit.empty() ? "0.5" : fmt::format("\"1 {}\"", unit);
    problem(node.place, path, fmt::format("is {}, but must be a number, such as {}", kind_name(node), example));
    return std::nullopt;
  } else if (value = number_in(node); !std::isfinite(value)) {
    problem(node.place, path, "must be a finite number");
    return std::nullopt;
  } else if (!is_in_reach(value)) {
    problem(node.place, path, fmt::format("{} is beyond the range of numbers; write 0 or a magnitude from 1e-60 to 1e60", as_written(node)));
    return std::nullopt;
  } else if (unit == "deg") {
    problem(node.place, path,
            fmt::format("{} has no unit; write an angle with its unit, for example \"90 deg\" (of a part of a cycle 360 times as much: \"{:.6g} deg\")",
                        as_written(node), 360 * value));
    return std::nullopt;
  } else if (wanted != dimension::none) {
    problem(node.place, path, fmt::format("{0} has no unit; write it with its unit, for example \"{0} {1}\"", as_written(node), unit));
    return std::nullopt;
  }
  if (range.contains(value)) return value;
  problem(node.place, path, fmt::format("{} is out of range; it must be {}", as_written(node), to_string(range, unit)));
  return std::nullopt;
}

void RecipeReader::number(const Key& key, std::optional<double>& value, std::string_view unit, const Range& range) {
  const Node* node = take(key, unit.empty() ? fmt::format("{} = 1", key.name) : fmt::format("{} = \"1 {}\"", key.name, unit));
  if (!node) return;
  const auto read = read_number(*node, path_of(key.name), unit, range);
  if (read) value = read;
  else failed_.emplace(key.name);
}

void RecipeReader::integer(const Key& key, std::optional<std::int64_t>& value, const IntegerRange& range) {
  const Node* node = take(key, fmt::format("{} = 1", key.name));
  if (!node) return;
  const bool is_whole = node->kind == Node::Kind::real && std::floor(node->real) == node->real && std::abs(node->real) < 1e15;
  if (node->kind != Node::Kind::integer && !is_whole) {
    return refuse(
        key, *node,
        is_number(*node) ? fmt::format("{} is not a whole number", as_written(*node)) : fmt::format("is {}, but must be a whole number", kind_name(*node)));
  }
  const std::int64_t read = is_whole ? static_cast<std::int64_t>(node->real) : node->integer;
  if (read < range.min || read > range.max) { return refuse(key, *node, fmt::format("{} is out of range; it must be {}", read, to_string(range))); }
  value = read;
}

void RecipeReader::flag(const Key& key, bool& value) {
  const Node* node = take(key, fmt::format("{} = true", key.name));
  if (!node) return;
  if (node->kind != Node::Kind::flag) { return refuse(key, *node, fmt::format("is {}, but must be true or false (without quotes)", kind_name(*node))); }
  value = node->flag;
}

void RecipeReader::text(const Key& key, std::string& value) {
  const Node* node = take(key, fmt::format("{} = \"...\"", key.name));
  if (!node) return;
  if (node->kind != Node::Kind::text) return refuse(key, *node, fmt::format("is {}, but must be a text in quotes", kind_name(*node)));
  value = node->text;
}

void RecipeReader::file(const Key& key, std::string& value) {
  text(key, value);
  const Entry* entry = table_.find(key.name);
  if (!entry || !reading_.look_for_files || failed_.count(key.name) > 0) return;
  std::error_code error;
  const auto place = std::filesystem::path(reading_.folder) / value;
  if (!std::filesystem::is_regular_file(place, error)) {
    refuse(key, entry->value, fmt::format("there is no file \"{}\"; its place counts from the recipe's folder", value));
  }
}

void RecipeReader::numbers(const Key& key, std::vector<double>& values, std::string_view unit, const Range& range) {
  const Node* node = take(key, unit.empty() ? fmt::format("{} = [1, 2]", key.name) : fmt::format("{0} = [\"1 {1}\", \"2 {1}\"]", key.name, unit));
  if (!node) return;
  if (node->kind != Node::Kind::array) return refuse(key, *node, fmt::format("is {}, but must be a list", kind_name(*node)));
  values.clear();
  for (std::size_t i = 0; i < node->items.size(); ++i) {
    const auto read = read_number(node->items[i], fmt::format("{}.{}", path_of(key.name), i), unit, range);
    if (read) values.push_back(*read);
    else failed_.emplace(key.name);
  }
}

void RecipeReader::pairs(const Key& key, std::vector<std::pair<std::int32_t, std::int32_t>>& values) {
  const Node* node = take(key, fmt::format("{} = [[0, 1], [1, 2]]", key.name));
  if (!node) return;
  if (node->kind != Node::Kind::array) return refuse(key, *node, fmt::format("is {}, but must be a list of pairs", kind_name(*node)));
  values.clear();
  for (const auto& item : node->items) {
    const auto is_index = [](const Node& n) { return n.kind == Node::Kind::integer && n.integer >= 0 && n.integer <= INT32_MAX; };
    if (item.kind != Node::Kind::array || item.items.size() != 2 || !is_index(item.items[0]) || !is_index(item.items[1]) ||
        item.items[0].integer == item.items[1].integer) {
      refuse(key, item, "each pair must be two different grain indices from 0, such as [0, 1]");
      continue;
    }
    values.emplace_back(static_cast<std::int32_t>(item.items[0].integer), static_cast<std::int32_t>(item.items[1].integer));
  }
}

void RecipeReader::points(const Key& key, std::vector<Vec2>& values, std::string_view unit) {
  const std::string example = fmt::format("[[\"0 {0}\", \"0 {0}\"], [\"1 {0}\", \"2 {0}\"]]", unit);
  const Node* node = take(key, fmt::format("{} = {}", key.name, example));
  if (!node) return;
  if (node->kind != Node::Kind::array) return refuse(key, *node, fmt::format("is {}, but must be a list of points", kind_name(*node)));
  values.clear();
  for (std::size_t i = 0; i < node->items.size(); ++i) {
    const Node& item = node->items[i];
    const std::string path = fmt::format("{}.{}", path_of(key.name), i);
    if (item.kind != Node::Kind::array || item.items.size() != 2) {
      refuse(key, item, fmt::format("each point must be two numbers, x and y, such as {}", example));
      continue;
    }
    const auto x = read_number(item.items[0], path + ".0", unit, range::any), y = read_number(item.items[1], path + ".1", unit, range::any);
    if (x && y) values.push_back({*x, *y});
    else failed_.emplace(key.name);
  }
}

void RecipeReader::choice(const Key& key, int& index, const std::vector<Word>& words) {
  std::vector<std::string> names;
  for (const auto& word : words) names.emplace_back(word.word);
  const Node* node = take(key, fmt::format("{} = \"{}\"", key.name, names.front()));
  if (!node) return;
  if (node->kind != Node::Kind::text) { return refuse(key, *node, fmt::format("is {}, but must be one of: {}", kind_name(*node), list_of(names))); }
  const auto found = std::find(names.begin(), names.end(), node->text);
  if (found == names.end()) {
    const std::string near = nearest(node->text, names);
    return refuse(key, *node,
                  fmt::format("unknown word \"{}\"; {}it must be one of: {}", node->text, near.empty() ? "" : fmt::format("did you mean \"{}\"? ", near),
                              list_of(names)));
  }
  index = static_cast<int>(found - names.begin());
}

void RecipeReader::tagged(const Key& key, int& form, double& value, const std::vector<Form>& forms) {
  std::vector<std::string> bare, with_quantity, ways;
  for (const auto& each : forms) {
    (each.unit.empty() ? bare : with_quantity).emplace_back(each.word);
    ways.push_back(each.unit.empty() ? fmt::format("\"{}\"", each.word) : fmt::format("{{ {} = \"1 {}\" }}", each.word, each.unit));
  }
  const Node* node = take(key, fmt::format("{} = {}", key.name, ways.front()));
  if (!node) return;
  if (node->kind == Node::Kind::text) {
    for (std::size_t i = 0; i < forms.size(); ++i) {
      if (!forms[i].unit.empty() || node->text != forms[i].word) continue;
      form = static_cast<int>(i);
      value = 0;
      return;
    }
    const std::string near = nearest(node->text, bare), tag = tag_of_quantity(node->text, forms);
    return refuse(key, *node,
                  !tag.empty()   ? fmt::format("write {{ {} = \"{}\" }}", tag, node->text)
                  : near.empty() ? fmt::format("unknown word \"{}\"; write one of: {}", node->text, list_of(ways))
                                 : fmt::format("unknown word \"{}\"; did you mean \"{}\"?", node->text, near));
  }
  const Entry* only = node->kind == Node::Kind::table ? only_entry(*node) : nullptr;
  if (!only) return refuse(key, *node, "must be one of: " + list_of(ways));
  const Entry& entry = *only;
  for (std::size_t i = 0; i < forms.size(); ++i) {
    if (forms[i].unit.empty() || entry.key != forms[i].word) continue;
    const auto read = read_number(entry.value, path_of(key.name) + "." + entry.key, forms[i].unit, forms[i].range);
    if (!read) return void(failed_.emplace(key.name));
    form = static_cast<int>(i);
    value = *read;
    return;
  }
  failed_.emplace(key.name);
  const std::string near = nearest(entry.key, with_quantity);
  problem(entry.place, path_of(key.name) + "." + entry.key,
          near.empty() ? "unknown key; write one of: " + list_of(ways) : fmt::format("unknown key; did you mean {}?", near));
}

}  // namespace arenite::recipe
