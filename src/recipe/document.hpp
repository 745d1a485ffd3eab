#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace arenite::recipe {

/// Where something stands in the recipe, or which override it came from.
struct Place {
  int line = 0, column = 0;        ///< 1-based; 0 if it came from an override
  std::string override_text = {};  ///< "--set key=value"; empty for the file itself
  bool wins = false;               ///< set over what the recipe says: of several forms of one value this one counts
  std::string file = {};           ///< the base that it stands in; empty for the recipe itself
};

struct Entry;

/// A recipe as it was written: a tree of tables, arrays and values that keep their places. Nothing is checked yet.
struct Node {
  enum class Kind { flag, integer, real, text, array, table, date };
  Kind kind = Kind::table;
  bool flag = false;
  std::int64_t integer = 0;
  double real = 0;
  std::string text = {};
  std::vector<Node> items = {};  ///< array
  std::vector<Entry>
      entries;  ///< table, in the order of the text; no initialiser, which would need the whole Entry here
  Place place = {};

  const Entry* find(std::string_view key) const;
  /// The entry of that key, out of the table.
  std::optional<Entry> take(std::string_view key);
};

struct Entry {
  std::string key;
  Place place;  ///< of the key
  Node value;
};

/// What kind of value was written, for messages: "a number".
const char* kind_name(const Node& node);

/// Every place in a tree, handed to `visit`.
void each_place(Node& node, const std::function<void(Place&)>& visit);

/// The parts of a dotted key. Throws InputError for an empty part, and for more than any recipe has.
std::vector<std::string> parts_of(std::string_view key);
/// Puts a value at the place that these parts lead to, items of arrays counted from 0, and its place with it; tables
/// are made where there are none. Returns the parts with items called by name as their numbers. Throws InputError
/// without place for a key that leads nowhere.
std::vector<std::string> put(Node& root, const std::vector<std::string>& parts, Node value);

/// Reads TOML. Throws InputError with line and column for what is not TOML.
Node read_document(std::string_view text, const std::string& file_name);

/// What stands behind an equals sign: TOML, or text without its quotes (350 mm).
Node parse_value(const std::string& text);

/// The value as TOML on one line: `parse_value` of it gives an equal one.
std::string toml_literal(const Node& value);
/// A TOML text in its quotes, and a TOML key: bare where that is allowed, else quoted.
std::string toml_text(std::string_view text);
std::string toml_key(const std::string& name);

}  // namespace arenite::recipe
