#pragma once
#include <array>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/parameters.hpp"
#include "recipe/document.hpp"

namespace arenite::recipe {

/// What all readers of one recipe share.
struct Reading {
  std::string file_name;
  std::string folder;  ///< where files that the recipe names are looked for
  bool look_for_files = false;
  std::vector<Problem> problems;
  std::vector<std::string> bases = {};    ///< files that the recipe is laid over
  std::vector<std::string> notices = {};  ///< what the user should see, though nothing is wrong
};

/// What a place is reported under: an override, a base or the recipe.
const std::string& file_of(const Place& place, const Reading& reading);
/// Adds a problem, once.
void add_problem(Reading& reading, const Place& place, const std::string& path, const std::string& message);

/// Reads one table of a recipe into what the declarations name; sub-tables get readers of their own. Problems are
/// collected; whatever is wrong keeps its default.
class RecipeReader : public ParameterVisitor {
 public:
  RecipeReader(const Node& table, std::string path, Reading& reading);

  void number(const Key& key, std::optional<double>& value, std::string_view unit, const Range& range) override;
  void integer(const Key& key, std::optional<std::int64_t>& value, const IntegerRange& range) override;
  void flag(const Key& key, bool& value) override;
  void text(const Key& key, std::string& value) override;
  void file(const Key& key, std::string& value) override;
  void numbers(const Key& key, std::vector<double>& values, std::string_view unit, const Range& range) override;
  void pairs(const Key& key, std::vector<std::pair<std::int32_t, std::int32_t>>& values) override;
  void points(const Key& key, std::vector<Vec2>& values, std::string_view unit) override;
  void series(const Key& key, std::vector<Vec2>& values, std::string_view unit) override;
  void choice(const Key& key, int& index, const std::vector<Word>& words) override;
  void tagged(const Key& key, int& form, double& value, const std::vector<Form>& forms) override;
  void section(const Key& key, bool& present, const Visit& inside) override;
  void sections(const Key& key, const Elements& elements) override;
  void when(bool active, std::string_view condition, const Visit& inside) override;
  void require(bool holds, std::initializer_list<std::string_view> keys, std::string_view message) override;

  /// Call when all keys were visited: what is left over is unknown.
  void refuse_unknown_keys();

 private:
  const Node* take(const Key& key, const std::string& example);
  const Node* take(const Key& key, const std::string& example, Node::Kind kind, const std::string& wanted);
  std::string path_of(std::string_view name) const;
  void problem(const Place& place, const std::string& path, const std::string& message);
  void refuse(const Key& key, const Place& place, const std::string& message);
  void read_table(const Node& table, const std::string& path, const Visit& inside);
  std::optional<double> read_number(const Node& node, const std::string& path, std::string_view unit, const Range& range);
  template <class T, class Read> void read_items(const Key& key, const Node& list, std::vector<T>& values, Read read);
  void read_rows(const Key& key, const Node& list, std::vector<Vec2>& values, std::array<std::string_view, 2> unit, const std::string& wanted);
  void read_series(const Key& key, const Node& file, std::vector<Vec2>& values, std::string_view unit);

  const Node& table_;
  std::string path_;
  Reading& reading_;
  std::set<std::string, std::less<>> known_, failed_;
  std::map<std::string, std::string, std::less<>> conditional_;  ///< keys that do not exist now, and when they do
};

/// The tree that a text, its base and its overrides make, under the names that `keys` have now; problems of base and overrides are collected. For an
/// empty text the InputError names the template that `arenite init` writes.
Node read_tree(std::string_view text, Reading& reading, const std::vector<std::string>& overrides, const RecordTable& keys, std::string_view start_from);

/// Every key of a recipe of a simulation.
const RecordTable& recipe_keys();

/// Reads all keys that a declaration visits. Throws InputError with every problem found, in the order of the text.
void read_declared(const Node& root, Reading& reading, const Visit& declare);

}  // namespace arenite::recipe
