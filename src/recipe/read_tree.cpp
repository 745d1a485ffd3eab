#include "recipe/read_tree.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "core/option.hpp"
#include "core/problems.hpp"
#include "io/disk/file.hpp"

namespace arenite::recipe {

namespace fs = std::filesystem;

namespace {

void lay_under(Node& own, Node&& base) {
  for (Entry& entry : base.entries) {
    const auto at = std::ranges::find(own.entries, entry.key, &Entry::key);
    if (at == own.entries.end()) own.entries.push_back(std::move(entry));
    else if (at->value.kind == Node::Kind::table && entry.value.kind == Node::Kind::table)
      lay_under(at->value, std::move(entry.value));
  }
}

bool is_same(const fs::path& a, const fs::path& b) {
  std::error_code ignored;
  return fs::equivalent(a, b, ignored);
}

/// What is wrong with a base; empty if it can be read.
std::string refusal(const Entry& base, const fs::path& path, const Reading& reading) {
  if (base.value.kind != Node::Kind::text || base.value.text.empty())
    return "must be the name of another recipe, for example \"../paper/recipe.toml\"";
  if (!reading.look_for_files)
    return "a recipe that does not come from a file can have no base; write out the keys of the base";
  if (!fs::is_regular_file(path))
    return fmt::format("there is no file {}; a base is found relative to the recipe that names it", path.string());
  const bool again =
      is_same(path, reading.file_name) || std::any_of(reading.bases.begin(), reading.bases.end(),
                                                      [&](const std::string& file) { return is_same(path, file); });
  return again ? fmt::format("{} leads back to itself; a recipe cannot be its own base", path.string()) : "";
}

/// Lays the recipe that the key `base` names under this one, and its base under both: sections are merged key by key,
/// what else is given here counts instead. A base's [sweep] is left out. The key is taken out of the tree, and the
/// files that were read are added to `reading.bases`. Throws InputError where there is no such file, or one leads back
/// to itself.
void lay_base_under(Node& root, Reading& reading, const RecordTable& keys) {
  fs::path folder = reading.folder;
  for (auto base = root.take("base"); base;) {
    const fs::path path = (folder / base->value.text).lexically_normal();
    if (const std::string why = refusal(*base, path, reading); !why.empty())
      throw InputError({Problem{file_of(base->value.place, reading), base->value.place.line, base->value.place.column,
                                "base: " + why}});
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

/// Puts "key=value" into the tree; a value that is not TOML by itself is text (container.width=350 mm). Throws
/// InputError for a key that leads nowhere.
void apply_override(Node& root, const std::string& assignment, const RecordTable& keys) {
  const auto equals = assignment.find('=');
  try {
    if (equals == std::string::npos || equals == 0)
      throw InputError("write key=value, for example seed=7 or container.width=\"350 mm\"");
    Node value = parse_value(assignment.substr(equals + 1));
    value.place = {.override_text = option("set") + " " + assignment};
    set_value(root, assignment.substr(0, equals), std::move(value), keys);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{} {}: {}", option("set"), assignment, error.what()));
  }
}

}  // namespace

Node read_tree(std::string_view text, Reading& reading, const std::vector<std::string>& overrides,
               const RecordTable& keys, std::string_view start_from) {
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    refuse(reading.file_name, "the recipe is empty; `arenite init {}` writes one to start from", start_from);
  }
  Node root = read_document(text, reading.file_name);
  rename_former_keys(root, keys, reading.notices);
  lay_base_under(root, reading, keys);
  for (const auto& assignment : overrides) {
    try {
      apply_override(root, assignment, keys);
    } catch (const InputError& error) {
      reading.problems.insert(reading.problems.end(), error.problems().begin(), error.problems().end());
    }
  }
  return root;
}

}  // namespace arenite::recipe
