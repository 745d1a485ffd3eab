#include "study/recipe_document.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <charconv>

#include "core/error.hpp"

namespace arenite::study {
namespace {

Place place_of(const toml::source_region& region) {
  return {static_cast<int>(region.begin.line), static_cast<int>(region.begin.column), {}};
}

bool stands_before(const Place& a, const Place& b) {
  return a.line != b.line ? a.line < b.line : a.column < b.column;
}

Node converted(const toml::node& node);

Node converted_table(const toml::table& table) {
  Node result;
  result.kind = Node::Kind::table;
  for (const auto& [key, value] : table) {
    result.entries.push_back({std::string(key.str()), place_of(key.source()), converted(value)});
  }
  std::stable_sort(result.entries.begin(), result.entries.end(),
                   [](const Entry& a, const Entry& b) { return stands_before(a.place, b.place); });
  return result;
}

Node converted(const toml::node& node) {
  Node result;
  if (const auto* table = node.as_table()) {
    result = converted_table(*table);
  } else if (const auto* array = node.as_array()) {
    result.kind = Node::Kind::array;
    for (const auto& item : *array) result.items.push_back(converted(item));
  } else if (const auto* text = node.as_string()) {
    result.kind = Node::Kind::text;
    result.text = text->get();
  } else if (const auto* integer = node.as_integer()) {
    result.kind = Node::Kind::integer;
    result.integer = integer->get();
  } else if (const auto* real = node.as_floating_point()) {
    result.kind = Node::Kind::real;
    result.real = real->get();
  } else if (const auto* flag = node.as_boolean()) {
    result.kind = Node::Kind::flag;
    result.flag = flag->get();
  } else {
    result.kind = Node::Kind::date;
  }
  result.place = place_of(node.source());
  return result;
}

/// toml++ says "Error while parsing key-value pair: expected ..."; only what comes after the colon helps.
std::string reason_in(std::string_view description) {
  constexpr std::string_view opening = "Error while parsing ";
  if (description.starts_with(opening)) {
    const auto colon = description.find(": ");
    if (colon != std::string_view::npos) {
      const auto what = description.substr(opening.size(), colon - opening.size());
      return fmt::format("the {} cannot be read: {}", what, description.substr(colon + 2));
    }
  }
  return std::string(description);
}

void set_place(Node& node, const Place& place) {
  node.place = place;
  for (auto& item : node.items) set_place(item, place);
  for (auto& entry : node.entries) {
    entry.place = place;
    set_place(entry.value, place);
  }
}

constexpr int deepest = 16;  // parts of a dotted key; the deepest of a recipe has five

std::string trimmed(std::string text) {
  text.erase(0, text.find_first_not_of(" \t"));
  text.erase(text.find_last_not_of(" \t") + 1);
  return text;
}

Node value_of(const std::string& text) {
  try {
    const toml::table table = toml::parse("value = " + text);
    if (table.size() == 1) return converted(*table.get("value"));
  } catch (const toml::parse_error&) {
    // Not TOML by itself: then it is text without its quotes.
  }
  Node node;
  node.kind = Node::Kind::text;
  node.text = trimmed(text);
  return node;
}

[[noreturn]] void leads_nowhere(const std::string& assignment, const std::string& why) {
  throw InputError(fmt::format("--set {}: {}", assignment, why));
}

std::size_t item_index(const std::string& word, const Node& array, const std::string& assignment) {
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), index);
  if (error != std::errc{} || end != word.data() + word.size() || index >= array.items.size()) {
    leads_nowhere(assignment, fmt::format("\"{}\" is not one of the {} items, counted from 0", word, array.items.size()));
  }
  return index;
}

/// The value under `word`; made where there is none, and turned into a table where `word` needs one.
Node& step_into(Node& node, const std::string& word, const Place& place, const std::string& assignment) {
  if (node.kind == Node::Kind::array) return node.items[item_index(word, node, assignment)];
  if (node.kind != Node::Kind::table) {
    node = Node{};
    node.place = place;
  }
  for (auto& entry : node.entries) {
    if (entry.key == word) return entry.value;
  }
  Node value;
  value.place = place;
  node.entries.push_back({word, place, std::move(value)});
  return node.entries.back().value;
}

}  // namespace

const Entry* Node::find(std::string_view key) const {
  for (const auto& entry : entries) {
    if (entry.key == key) return &entry;
  }
  return nullptr;
}

Node read_document(std::string_view text, const std::string& file_name) {
  try {
    return converted(toml::parse(text));
  } catch (const toml::parse_error& error) {
    const Place place = place_of(error.source());
    throw InputError({Problem{file_name, place.line, place.column,
                              fmt::format("this is not TOML; {}", reason_in(error.description()))}});
  }
}

void apply_override(Node& root, const std::string& assignment) {
  const auto equals = assignment.find('=');
  if (equals == std::string::npos || equals == 0) {
    leads_nowhere(assignment, "write key=value, for example seed=7 or frame.width=\"350 mm\"");
  }
  const Place place{0, 0, "--set " + assignment};
  Node* node = &root;
  int depth = 0;
  const std::string key = assignment.substr(0, equals);
  for (std::size_t begin = 0; begin <= key.size();) {
    const std::size_t end = std::min(key.find('.', begin), key.size());
    const std::string word = trimmed(key.substr(begin, end - begin));
    if (++depth > deepest) leads_nowhere(assignment, "no key of a recipe is so deep");
    if (word.empty()) leads_nowhere(assignment, "a part of the key is empty");
    node = &step_into(*node, word, place, assignment);
    begin = end + 1;
  }
  Node value = value_of(assignment.substr(equals + 1));
  set_place(value, place);
  *node = std::move(value);
}

}  // namespace arenite::study
