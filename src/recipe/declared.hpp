#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "recipe/read_tree.hpp"
#include "recipe/reader.hpp"
#include "recipe/writer.hpp"

/// What recipes of simulations and of films have in common; `declare` says their keys.
namespace arenite::recipe {

/// The keys of a recipe as they are set, or every key there is.
template <class R> RecordTable keys_of(R recipe, bool every_key = false) {
  return record_of([&](ParameterVisitor& visitor) { declare(visitor, recipe); }, every_key);
}

template <class R> const RecordTable& all_keys() {
  static const RecordTable all = keys_of(R(), true);
  return all;
}

template <class R> std::string changed_keys_of(const R& recipe) {
  static const RecordTable all = under_former_names(all_keys<R>());
  return write_changes(under_former_names(keys_of(recipe)), all);
}

template <class R> R read_from(const Node& root, Reading& reading) {
  R recipe;
  recipe.source_file = reading.file_name;
  read_declared(root, reading, [&](ParameterVisitor& visitor) { declare(visitor, recipe); });
  return recipe;
}

/// `start_from`: the template of this kind; `refuse_other_kinds(root, reading)` refuses recipes of others.
template <class R, class Refuse>
R read_text(std::string_view text, Reading reading, const std::vector<std::string>& overrides,
            std::string_view start_from, const Refuse& refuse_other_kinds) {
  Node root = read_tree(text, reading, overrides, all_keys<R>(), start_from);
  refuse_other_kinds(root, reading);
  R recipe = read_from<R>(root, reading);
  recipe.notices = reading.notices;
  return recipe;
}

/// The section [sweep] of a recipe that is read as that of one run, or one film.
inline void refuse_sweep(const Entry& sweep, Reading& reading) {
  add_problem(reading, sweep.place, "sweep",
              "this recipe is a study of many runs; `arenite study plan " + reading.file_name +
                  "` shows them, `arenite study run " + reading.file_name + "` runs them");
}

inline Reading of_file(const std::string& file) {
  return {file, std::filesystem::path(file).parent_path().string(), true, {}};
}
inline Reading of_text(const std::string& name) { return {name, {}, false, {}}; }

}  // namespace arenite::recipe
