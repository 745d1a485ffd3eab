#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "core/error.hpp"
#include "recipe/recipe_document.hpp"

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

[[noreturn]] void leads_nowhere(const std::string& why) { throw InputError(why); }

std::size_t item_index(const std::string& word, const Node& array) {
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), index);
  if (error != std::errc{} || end != word.data() + word.size() || index >= array.items.size()) {
    leads_nowhere(fmt::format("\"{}\" is not one of the {} items, counted from 0", word, array.items.size()));
  }
  return index;
}

/// The parts of a dotted key.
std::vector<std::string> words_of(const std::string& key) {
  std::vector<std::string> words;
  for (std::size_t begin = 0; begin <= key.size();) {
    const std::size_t end = std::min(key.find('.', begin), key.size());
    words.push_back(trimmed(key.substr(begin, end - begin)));
    if (words.back().empty()) leads_nowhere("a part of the key is empty");
    if (words.size() > deepest) leads_nowhere("no key of a recipe is so deep");
    begin = end + 1;
  }
  return words;
}

/// The value under `word`; made where there is none, and turned into a table where `word` needs one.
Node& step_into(Node& node, const std::string& word, const Place& place) {
  if (node.kind == Node::Kind::array) return node.items[item_index(word, node)];
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

Node parse_value(const std::string& text) {
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

void set_value(Node& root, const std::string& key, Node value) {
  Place place = value.place;
  place.wins = true;
  Node* node = &root;
  for (const auto& word : words_of(key)) node = &step_into(*node, word, place);
  set_place(value, place);
  *node = std::move(value);
}

void apply_override(Node& root, const std::string& assignment) {
  const auto equals = assignment.find('=');
  try {
    if (equals == std::string::npos || equals == 0) leads_nowhere("write key=value, for example seed=7 or frame.width=\"350 mm\"");
    Node value = parse_value(assignment.substr(equals + 1));
    value.place = {0, 0, "--set " + assignment};
    set_value(root, assignment.substr(0, equals), std::move(value));
  } catch (const InputError& error) {
    throw InputError(fmt::format("--set {}: {}", assignment, error.what()));
  }
}

}  // namespace arenite::study
