#include "recipe/settings.hpp"

#include "recipe/document.hpp"
#include "recipe/film_recipe.hpp"
#include "recipe/recipe.hpp"

namespace arenite::recipe {
namespace {

using Settings = std::vector<std::pair<std::string, std::string>>;

void add(const Node& node, const std::string& path, Settings& to) {
  const auto below = [&](const std::string& name) { return path.empty() ? name : path + "." + name; };
  if (node.kind == Node::Kind::table) {
    for (const Entry& entry : node.entries) add(entry.value, below(entry.key), to);
  } else if (node.kind == Node::Kind::array) {
    for (std::size_t k = 0; k < node.items.size(); ++k) add(node.items[k], below(std::to_string(k)), to);
  } else {
    to.emplace_back(path, node.kind == Node::Kind::text ? node.text : toml_literal(node));
  }
}

/// With all defaults, of either kind of recipe; as it is where neither reads it.
std::string resolved(const std::string& recipe) {
  try {
    return to_toml(parse_recipe(recipe, "recipe"));
  } catch (const InputError&) {}
  try {
    return to_toml(parse_film_recipe(recipe, "recipe"));
  } catch (const InputError&) { return recipe; }
}

}  // namespace

Settings settings_of(const std::string& recipe) {
  Settings settings;
  if (recipe.empty()) return settings;
  try {
    add(read_document(resolved(recipe), "recipe"), "", settings);
  } catch (const InputError&) {}
  return settings;
}

}  // namespace arenite::recipe
