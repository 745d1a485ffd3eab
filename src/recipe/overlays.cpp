#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "core/error.hpp"
#include "core/text.hpp"
#include "io/disk/file.hpp"
#include "recipe/document.hpp"
#include "recipe/reader.hpp"

namespace arenite::recipe {

namespace fs = std::filesystem;

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

[[noreturn]] void leads_nowhere(const std::string& why) { throw InputError(why); }

std::size_t item_index(const std::string& word, const Node& array) {
  const auto index = parse_number<std::size_t>(word);
  if (!index || *index >= array.items.size()) leads_nowhere(fmt::format("\"{}\" is not one of the {} items, counted from 0", word, array.items.size()));
  return *index;
}

/// The parts of a dotted key.
std::vector<std::string> words_of(const std::string& key) {
  std::vector<std::string> words;
  for (std::size_t begin = 0; begin <= key.size();) {
    const std::size_t end = std::min(key.find('.', begin), key.size());
    words.emplace_back(trimmed(std::string_view(key).substr(begin, end - begin)));
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

void set_file(Node& node, const std::string& file) {
  node.place.file = file;
  for (Node& item : node.items) set_file(item, file);
  for (Entry& entry : node.entries) {
    entry.place.file = file;
    set_file(entry.value, file);
  }
}

std::optional<Entry> take(Node& table, std::string_view key) {
  const auto at = std::find_if(table.entries.begin(), table.entries.end(), [&](const Entry& entry) { return entry.key == key; });
  if (at == table.entries.end()) return std::nullopt;
  Entry entry = std::move(*at);
  table.entries.erase(at);
  return entry;
}

void lay_under(Node& own, Node&& base) {
  for (Entry& entry : base.entries) {
    const auto at = std::find_if(own.entries.begin(), own.entries.end(), [&](const Entry& e) { return e.key == entry.key; });
    if (at == own.entries.end()) own.entries.push_back(std::move(entry));
    else if (at->value.kind == Node::Kind::table && entry.value.kind == Node::Kind::table) lay_under(at->value, std::move(entry.value));
  }
}

bool is_same(const fs::path& a, const fs::path& b) {
  std::error_code ignored;
  return fs::equivalent(a, b, ignored);
}

/// What is wrong with a base; empty if it can be read.
std::string refusal(const Entry& base, const fs::path& path, const Reading& reading) {
  if (base.value.kind != Node::Kind::text || base.value.text.empty()) return "must be the name of another recipe, for example \"../paper/recipe.toml\"";
  if (!reading.look_for_files) return "a recipe that does not come from a file can have no base; write out what it takes from there";
  if (!fs::is_regular_file(path)) return fmt::format("there is no file {}; a base is looked for beside the recipe that names it", path.string());
  const bool again =
      is_same(path, reading.file_name) || std::any_of(reading.bases.begin(), reading.bases.end(), [&](const std::string& file) { return is_same(path, file); });
  return again ? fmt::format("{} leads back to itself; a recipe cannot be its own base", path.string()) : "";
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
  for (const auto& word : words_of(current_key(key, value))) node = &step_into(*node, word, place);
  set_place(value, place);
  *node = std::move(value);
}

void apply_override(Node& root, const std::string& assignment) {
  const auto equals = assignment.find('=');
  try {
    if (equals == std::string::npos || equals == 0) leads_nowhere("write key=value, for example seed=7 or container.width=\"350 mm\"");
    Node value = parse_value(assignment.substr(equals + 1));
    value.place = {0, 0, "--set " + assignment};
    set_value(root, assignment.substr(0, equals), std::move(value));
  } catch (const InputError& error) { throw InputError(fmt::format("--set {}: {}", assignment, error.what())); }
}

void lay_base_under(Node& root, Reading& reading) {
  fs::path folder = reading.folder;
  for (auto base = take(root, "base"); base;) {
    const fs::path path = (folder / base->value.text).lexically_normal();
    if (const std::string why = refusal(*base, path, reading); !why.empty())
      throw InputError({Problem{file_of(base->value.place, reading), base->value.place.line, base->value.place.column, "base: " + why}});
    reading.bases.push_back(path.string());
    Node under = read_document(io::read_file(path.string()), path.string());
    set_file(under, path.string());
    rename_former_keys(under, reading.notices);
    take(under, "sweep");
    base = take(under, "base");
    lay_under(root, std::move(under));
    folder = path.parent_path();
  }
}

}  // namespace arenite::recipe
