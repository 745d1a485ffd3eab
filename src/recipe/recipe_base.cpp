#include "recipe/recipe_base.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "core/error.hpp"
#include "io/read_file.hpp"

namespace arenite::study {
namespace {

namespace fs = std::filesystem;

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
  const bool again = is_same(path, reading.file_name) || std::any_of(reading.bases.begin(), reading.bases.end(), [&](const std::string& file) { return is_same(path, file); });
  return again ? fmt::format("{} leads back to itself; a recipe cannot be its own base", path.string()) : "";
}

}  // namespace

void lay_base_under(Node& root, Reading& reading) {
  fs::path folder = reading.folder;
  for (auto base = take(root, "base"); base;) {
    const fs::path path = (folder / base->value.text).lexically_normal();
    if (const std::string why = refusal(*base, path, reading); !why.empty())
      throw InputError({Problem{file_of(base->value.place, reading), base->value.place.line, base->value.place.column, "base: " + why}});
    reading.bases.push_back(path.string());
    Node under = read_document(io::read_file(path.string()), path.string());
    set_file(under, path.string());
    take(under, "sweep");
    base = take(under, "base");
    lay_under(root, std::move(under));
    folder = path.parent_path();
  }
}

}  // namespace arenite::study
