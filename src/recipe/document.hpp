#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/parameters.hpp"

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
  std::vector<Node> items = {};     ///< array
  std::vector<Entry> entries = {};  ///< table, in the order of the text
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

/// Parts that a dotted key may have; the deepest of a recipe has five.
inline constexpr std::size_t deepest = 16;

/// Reads TOML. Throws InputError with line and column for what is not TOML.
Node read_document(std::string_view text, const std::string& file_name);

/// What stands behind an equals sign: TOML, or text without its quotes (350 mm).
Node parse_value(const std::string& text);

/// The value as TOML on one line: `parse_value` of it gives an equal one.
std::string toml_literal(const Node& value);
/// A TOML text in its quotes, and a TOML key: bare where that is allowed, else quoted.
std::string toml_text(std::string_view text);
std::string toml_key(const std::string& name);

struct Record;
using RecordTable = std::vector<Record>;

/// One declared key with what it holds, ready to be written as TOML or documented.
struct Record {
  enum class Kind { value, section, sections };
  struct Choice {
    std::string literal, sentence;
    Word word = {};  ///< that it is; none of a form with a quantity
  };
  Kind kind = Kind::value;
  Key key;
  std::string condition;                    ///< `law = "normal"`, if the key exists only then
  std::optional<std::string> literal = {};  ///< value in TOML; nothing if it is not set
  std::string form;                         ///< a literal with dots for what is to be filled in
  std::string allowed;                      ///< "above 0 mm"
  std::vector<Choice> choices = {};
  bool present = true;                        ///< of a section
  std::vector<RecordTable> tables = {};       ///< section: one; sections: one each
  std::vector<std::string> table_names = {};  ///< of sections with names
  bool named = false;
  std::string name() const { return std::string(key.name); }
};

/// The keys that a declaration visits, as they are set; or every key there is in it, one table for each list.
RecordTable record_of(const Visit& declare, bool every_key = false);

/// Puts a value at a dotted key into the tree, and its place with it; items of arrays are counted from 0. Names of before become those of now, as
/// `keys` knows them. Throws InputError without place for a key that leads nowhere.
void set_value(Node& root, const std::string& key, Node value, const RecordTable& keys);

/// Puts "key=value" into the tree; the key is dotted, items of arrays are counted from 0, and a value that is not TOML
/// by itself is text (container.width=350 mm). Throws InputError for a key that leads nowhere.
void apply_override(Node& root, const std::string& assignment, const RecordTable& keys);

/// Adds the sentence that `former` is now called `now`, once.
void note_former_name(std::vector<std::string>& notices, std::string_view former, std::string_view now);

/// Gives keys and words that stand under a name of before the one of now; a notice says so of each. Where both stand, the former is left as it is.
void rename_former_keys(Node& root, const RecordTable& keys, std::vector<std::string>& notices);

/// The records under the names that keys and words had first, from which names of results and seeds of samples follow.
RecordTable under_former_names(RecordTable table);

/// The keys that are set, as TOML.
std::string write_toml(const RecordTable& root);

/// The keys that are not as in `all`, one a line with its whole path: what results are named by, so that neither a key at its
/// default nor one that a later version adds changes a name.
std::string write_changes(const RecordTable& root, const RecordTable& all);

/// As write_toml for people: explained, and keys that are as in `all` as comments.
std::string write_commented_toml(const RecordTable& root, const RecordTable& all);

/// Tables of all keys (Markdown).
std::string write_key_tables(const RecordTable& all);

}  // namespace arenite::recipe
