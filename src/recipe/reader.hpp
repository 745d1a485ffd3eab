#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "core/expression.hpp"
#include "core/parameters.hpp"
#include "recipe/document.hpp"
#include "recipe/record.hpp"

namespace arenite::recipe {

/// What all readers of one recipe share.
struct Reading {
  std::string file_name;
  std::string folder;  ///< where files that the recipe names are looked for
  bool look_for_files = false;
  std::vector<Problem> problems;
  std::vector<std::string> bases = {};    ///< files that the recipe is laid over
  std::vector<std::string> notices = {};  ///< what the user should see, though nothing is wrong
  bool bare_numbers_are_si = false;       ///< of keys with a dimension; otherwise these need their unit
  bool leaves_idle_keys = false;          ///< keys that other values leave without effect are told, not refused
  Variables variables = {};               ///< that numbers of the recipe may be written with
  void add(const Place& place, const std::string& path, const std::string& message);
};

/// What a place is reported under: an override, a base or the recipe.
const std::string& file_of(const Place& place, const Reading& reading);
/// Adds a problem, once.
void add_problem(Reading& reading, const Place& place, const std::string& path, const std::string& message);

/// Puts a value at a dotted key into the tree (`put`), whose parts it returns; names of before become those of now, as
/// `keys` knows them.
std::vector<std::string> set_value(Node& root, const std::string& key, Node value, const RecordTable& keys);

/// Reads [variables] and all keys that a declaration visits. Throws InputError with every problem found, in the order
/// of the text.
void read_declared(const Node& root, Reading& reading, const Visit& declare);

// Former names: keys and words say theirs where they are declared.
/// Adds the sentence that `former` is now called `now`, once.
void note_former_name(std::vector<std::string>& notices, std::string_view former, std::string_view now);
/// Gives keys and words that stand under a name of before the one of now; a notice says so of each. Where both stand,
/// the former is left as it is.
void rename_former_keys(Node& root, const RecordTable& keys, std::vector<std::string>& notices);
/// The records under the names that keys and words had first, from which names of results and seeds of samples follow.
RecordTable under_former_names(RecordTable table);

}  // namespace arenite::recipe
