#include "recipe/reader.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>

#include "core/problems.hpp"
#include "core/text.hpp"
#include "io/disk/file.hpp"

namespace arenite::recipe {

namespace fs = std::filesystem;

namespace {

/// A sentence as a part of another.
std::string as_phrase(std::string_view sentence) {
  std::string phrase(sentence);
  if (phrase.size() > 1) phrase[0] = lower_case(phrase[0]);
  if (phrase.ends_with('.')) phrase.pop_back();
  return phrase;
}

void lay_under(Node& own, Node&& base) {
  for (Entry& entry : base.entries) {
    const auto at = std::ranges::find(own.entries, entry.key, &Entry::key);
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
  if (!reading.look_for_files) return "a recipe that does not come from a file can have no base; write out the keys of the base";
  if (!fs::is_regular_file(path)) return fmt::format("there is no file {}; a base is found relative to the recipe that names it", path.string());
  const bool again =
      is_same(path, reading.file_name) || std::any_of(reading.bases.begin(), reading.bases.end(), [&](const std::string& file) { return is_same(path, file); });
  return again ? fmt::format("{} leads back to itself; a recipe cannot be its own base", path.string()) : "";
}

}  // namespace

RecipeReader::RecipeReader(const Node& table, std::string path, Reading& reading) : table_(table), path_(std::move(path)), reading_(reading) {}

std::string RecipeReader::path_of(std::string_view name) const { return path_.empty() ? std::string(name) : fmt::format("{}.{}", path_, name); }

void RecipeReader::problem(const Place& place, const std::string& path, const std::string& message) {
  reading_.problems.push_back({file_of(place, reading_), place.line, place.column, path.empty() ? message : fmt::format("{}: {}", path, message)});
}

void RecipeReader::refuse(const Key& key, const Place& place, const std::string& message) {
  failed_.emplace(key.name);
  problem(place, path_of(key.name), message);
}

/// The value of a key, or nothing; a required one that is not there is a problem.
const Node* RecipeReader::take(const Key& key, const std::string& example) {
  known_.emplace(key.name);
  if (const Entry* entry = table_.find(key.name)) return &entry->value;
  if (key.required) refuse(key, table_.place, fmt::format("is missing; write for example {} = {}", key.name, example));
  return nullptr;
}

/// The same of one kind; another one is a problem, too.
const Node* RecipeReader::take(const Key& key, const std::string& example, Node::Kind kind, const std::string& wanted) {
  const Node* node = take(key, example);
  if (!node || node->kind == kind) return node;
  refuse(key, node->place, fmt::format("is {}, but must be {}", kind_name(*node), wanted));
  return nullptr;
}

/// All keys of a sub-table.
void RecipeReader::read_table(const Node& table, const std::string& path, const Visit& inside) {
  RecipeReader reader(table, path, reading_);
  inside(reader);
  reader.refuse_unknown_keys();
}

void RecipeReader::section(const Key& key, bool& present, const Visit& inside) {
  known_.emplace(key.name);
  const std::string path = path_of(key.name);
  const Entry* entry = table_.find(key.name);
  present = entry != nullptr;
  if (!entry) {
    if (key.required) refuse(key, table_.place, fmt::format("is missing; add the section [{}] ({})", path, as_phrase(key.sentence)));
    return;
  }
  if (entry->value.kind != Node::Kind::table)
    return refuse(key, entry->value.place, fmt::format("is {}, but must be a section [{}]", kind_name(entry->value), path));
  const std::size_t problems_before = reading_.problems.size();
  read_table(entry->value, path, inside);
  if (reading_.problems.size() > problems_before) failed_.emplace(key.name);
}

void RecipeReader::sections(const Key& key, const Elements& elements) {
  known_.emplace(key.name);
  const bool named = static_cast<bool>(elements.name);
  const std::string path = path_of(key.name);
  const std::string heading = named ? fmt::format("[{}.NAME]", path) : fmt::format("[[{}]]", path);
  const Entry* entry = table_.find(key.name);
  const std::size_t count = !entry ? 0 : named ? entry->value.entries.size() : entry->value.items.size();
  if (entry && entry->value.kind != (named ? Node::Kind::table : Node::Kind::array))
    return refuse(key, entry->value.place, fmt::format("is {}, but must be sections {}", kind_name(entry->value), heading));
  if (count == 0 && key.required)
    refuse(key, entry ? entry->value.place : table_.place, fmt::format("is missing; add a section {} ({})", heading, as_phrase(key.sentence)));
  std::vector<std::pair<std::string, const Node*>> nodes;
  for (std::size_t i = 0; i < count; ++i) {
    if (named) nodes.emplace_back(entry->value.entries[i].key, &entry->value.entries[i].value);
    else nodes.emplace_back(std::to_string(i), &entry->value.items[i]);
  }
  // Named sections have no order of their own: sorted, the same recipe gives the same indices however it is written.
  if (named) std::sort(nodes.begin(), nodes.end());
  elements.resize(nodes.size());
  const std::size_t problems_before = reading_.problems.size();
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (named) elements.name(i) = nodes[i].first;
    const std::string place = path + "." + nodes[i].first;
    if (nodes[i].second->kind != Node::Kind::table) {
      problem(nodes[i].second->place, place, fmt::format("is {}, but must be a section {}", kind_name(*nodes[i].second), heading));
      continue;
    }
    read_table(*nodes[i].second, place, [&](ParameterVisitor& reader) { elements.visit(reader, i); });
  }
  if (reading_.problems.size() > problems_before) failed_.emplace(key.name);
}

void RecipeReader::when(bool active, std::string_view condition, const Visit& inside) {
  if (active) return inside(*this);
  // A reader of an empty table knows which keys there would be.
  const Node nothing;
  Reading unheard{};
  RecipeReader reader(nothing, path_, unheard);
  inside(reader);
  for (const auto& [name, also] : reader.conditional_) reader.known_.insert(name);
  for (const auto& name : reader.known_) {
    const auto [place, is_new] = conditional_.emplace(name, condition);
    if (!is_new) place->second += fmt::format(" or {}", condition);
  }
}

void RecipeReader::require(bool holds, std::initializer_list<std::string_view> keys, std::string_view message) {
  if (holds) return;
  for (const auto key : keys) {
    if (failed_.count(key) > 0) return;
  }
  const std::string path = keys.size() == 0 ? path_ : path_of(*keys.begin());
  for (const auto key : keys) {
    if (const Entry* entry = table_.find(key)) return problem(entry->value.place, path, std::string(message));
  }
  problem(table_.place, path, std::string(message));
}

void RecipeReader::refuse_unknown_keys() {
  std::vector<std::string> names(known_.begin(), known_.end());
  for (const auto& entry : table_.entries) {
    if (known_.count(entry.key) > 0) continue;
    if (const auto found = conditional_.find(entry.key); found != conditional_.end()) {
      problem(entry.place, path_of(entry.key), fmt::format("this key is only valid with {}; leave it out or change that", found->second));
      continue;
    }
    const std::string near = nearest(entry.key, names);
    problem(entry.place, path_of(entry.key),
            near.empty() ? fmt::format("unknown key; the keys here are: {}", list_of(names)) : fmt::format("unknown key; did you mean {}?", near));
  }
}

const std::string& file_of(const Place& place, const Reading& reading) {
  return !place.override_text.empty() ? place.override_text : !place.file.empty() ? place.file : reading.file_name;
}

void add_problem(Reading& reading, const Place& place, const std::string& path, const std::string& message) {
  Problem problem{file_of(place, reading), place.line, place.column, fmt::format("{}: {}", path, message)};
  const auto same = [&](const Problem& p) { return p.message == problem.message && p.line == problem.line && p.file == problem.file; };
  if (std::ranges::none_of(reading.problems, same)) reading.problems.push_back(std::move(problem));
}

namespace {

/// Lays the recipe that the key `base` names under this one, and its base under both: sections are merged key by key, what else
/// is given here counts instead. A base's [sweep] is left out. The key is taken out of the tree, and the files that were
/// read are added to `reading.bases`. Throws InputError where there is no such file, or one leads back to itself.
void lay_base_under(Node& root, Reading& reading, const RecordTable& keys) {
  fs::path folder = reading.folder;
  for (auto base = root.take("base"); base;) {
    const fs::path path = (folder / base->value.text).lexically_normal();
    if (const std::string why = refusal(*base, path, reading); !why.empty())
      throw InputError({Problem{file_of(base->value.place, reading), base->value.place.line, base->value.place.column, "base: " + why}});
    reading.bases.push_back(path.string());
    Node under = read_document(io::read_file(path.string()), path.string());
    each_place(under, [&](Place& place) { place.file = path.string(); });
    rename_former_keys(under, keys, reading.notices);
    under.take("sweep");
    base = under.take("base");
    lay_under(root, std::move(under));
    folder = path.parent_path();
  }
}

}  // namespace

Node read_tree(std::string_view text, Reading& reading, const std::vector<std::string>& overrides, const RecordTable& keys, std::string_view start_from) {
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    refuse(reading.file_name, "the recipe is empty; `arenite init {}` writes one to start from", start_from);
  }
  Node root = read_document(text, reading.file_name);
  rename_former_keys(root, keys, reading.notices);
  lay_base_under(root, reading, keys);
  for (const auto& assignment : overrides) {
    try {
      apply_override(root, assignment, keys);
    } catch (const InputError& error) { reading.problems.insert(reading.problems.end(), error.problems().begin(), error.problems().end()); }
  }
  return root;
}

void read_declared(const Node& root, Reading& reading, const Visit& declare) {
  RecipeReader reader(root, "", reading);
  declare(reader);
  reader.refuse_unknown_keys();
  if (reading.problems.empty()) return;
  std::stable_sort(reading.problems.begin(), reading.problems.end(),
                   [](const Problem& a, const Problem& b) { return a.line != b.line ? a.line < b.line : a.column < b.column; });
  throw InputError(std::move(reading.problems));
}

}  // namespace arenite::recipe
