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

constexpr std::size_t deepest = 16;  // parts of a dotted key; the deepest of a recipe has five

/// The position behind the string that opens at `at`; the end of the text if it is not closed.
std::size_t behind_string(std::string_view text, std::size_t at) {
  const std::string_view quote = text.substr(at, 1);
  const std::string triple(3, quote.front());
  const bool many_lines = text.substr(at).starts_with(triple);
  const std::string_view closing = many_lines ? std::string_view(triple) : quote;
  for (at += closing.size(); at < text.size(); ++at) {
    if (text[at] == '\\' && quote == "\"") ++at;
    else if (text.substr(at).starts_with(closing)) return at + closing.size();
    else if (text[at] == '\n' && !many_lines) return at;
  }
  return text.size();
}

/// toml++ builds a.b.c by recursion without a bound, so a key of very many parts would exhaust the stack.
void refuse_deep_keys(std::string_view text, const std::string& file_name) {
  int line = 1;
  std::size_t dots = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    if (c == '"' || c == '\'') {
      const std::size_t end = behind_string(text, at);
      line += static_cast<int>(std::count(text.begin() + static_cast<std::ptrdiff_t>(at),
                                          text.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
      at = end - 1;
      continue;
    }
    if (c == '#') at = std::min(text.find('\n', at), text.size()) - 1;
    if (c == '\n') ++line;
    if (c == '.') ++dots;
    else if (std::string_view("\n=,[]{}#").find(c) != std::string_view::npos) dots = 0;
    if (dots >= deepest) throw InputError(file_name, line, "no key of a recipe has so many parts; check the dots in this line");
  }
}

std::string lower_first(std::string text) {
  if (!text.empty() && text[0] >= 'A' && text[0] <= 'Z') text[0] = static_cast<char>(text[0] - 'A' + 'a');
  return text;
}

/// toml++ says "Error while parsing key-value pair: expected ..."; only what comes after the colon helps.
std::string reason_in(std::string_view description) {
  constexpr std::string_view opening = "Error while parsing ";
  if (description.starts_with(opening)) {
    const auto colon = description.find(": ");
    if (colon != std::string_view::npos) {
      const auto what = description.substr(opening.size(), colon - opening.size());
      const auto reason = description.substr(colon + 2);
      return fmt::format("the {} cannot be read: {}", what, reason.substr(0, reason.find(" (TOML_")));
    }
  }
  return lower_first(std::string(description));
}

void set_place(Node& node, const Place& place) {
  node.place = place;
  for (auto& item : node.items) set_place(item, place);
  for (auto& entry : node.entries) {
    entry.place = place;
    set_place(entry.value, place);
  }
}

std::string trimmed(std::string text) {
  text.erase(0, text.find_first_not_of(" \t"));
  text.erase(text.find_last_not_of(" \t") + 1);
  return text;
}

Node value_of(const std::string& text) {
  try {
    refuse_deep_keys(text, {});
    const toml::table table = toml::parse("value = " + text);
    if (table.size() == 1) return converted(*table.get("value"));
  } catch (const std::exception&) {
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

/// The parts of a dotted key.
std::vector<std::string> words_of(const std::string& key, const std::string& assignment) {
  std::vector<std::string> words;
  for (std::size_t begin = 0; begin <= key.size();) {
    const std::size_t end = std::min(key.find('.', begin), key.size());
    words.push_back(trimmed(key.substr(begin, end - begin)));
    if (words.back().empty()) leads_nowhere(assignment, "a part of the key is empty");
    if (words.size() > deepest) leads_nowhere(assignment, "no key of a recipe is so deep");
    begin = end + 1;
  }
  return words;
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
  refuse_deep_keys(text, file_name);
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
  for (const auto& word : words_of(assignment.substr(0, equals), assignment)) node = &step_into(*node, word, place, assignment);
  Node value = value_of(assignment.substr(equals + 1));
  set_place(value, place);
  *node = std::move(value);
}

}  // namespace arenite::study
