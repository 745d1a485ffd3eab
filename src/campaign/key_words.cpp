#include "campaign/key_words.hpp"

#include <algorithm>
#include <vector>

#include "core/text.hpp"

namespace arenite::campaign {
namespace {

using recipe::Node;

/// What an item of a list is called: by its name, or the material that it is of.
std::string name_in(const Node& item) {
  for (const char* key : {"name", "material"})
    if (const recipe::Entry* entry = item.find(key); entry && entry->value.kind == Node::Kind::text)
      return entry->value.text;
  return {};
}

/// "shear" of "stages" and "1"; a step that is a name already stays.
std::string item_of(const Node& recipe, const std::string& list, const std::string& step) {
  const auto place = parse_number<std::size_t>(step);
  if (!place) return step;
  const recipe::Entry* entry = recipe.find(list);
  const std::string name = entry && *place < entry->value.items.size() ? name_in(entry->value.items[*place]) : "";
  return name.empty() ? list + " " + std::to_string(*place + 1) : name;
}

std::string spoken(const std::vector<std::string>& steps) {
  std::string text = list_of(steps, " ");
  std::ranges::replace(text, '_', ' ');
  return text;
}

}  // namespace

std::string words_of_key(const Node& recipe, const std::string& key) {
  std::vector<std::string> steps = recipe::parts_of(key);
  if (steps.size() == 2 && steps[0] == "variables") return steps[1];
  const recipe::Entry* first = recipe.find(steps[0]);
  const bool is_item = first && (first->value.kind == Node::Kind::array || steps[0] == "materials");
  if (!is_item || steps.size() < 3) return spoken(steps);
  return spoken({steps.begin() + 2, steps.end()}) + " of " + item_of(recipe, steps[0], steps[1]);
}

}  // namespace arenite::campaign
