#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "core/error.hpp"
#include "study/recipe_document.hpp"

namespace arenite::study {
namespace {

constexpr std::size_t deepest = 16;  // parts of a dotted key; the deepest of a recipe has five

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

/// The value that stands behind the equals sign; text without quotes where it is not TOML by itself.
Node value_of(const std::string& text) {
  try {
    Node document = read_document("value = " + text, {});
    if (document.entries.size() == 1) return std::move(document.entries.front().value);
  } catch (const InputError&) {
    // Then it is text.
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
