#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/error.hpp"
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
/// are made where there are none. Throws InputError without place for a key that leads nowhere.
void put(Node& root, const std::vector<std::string>& parts, Node value);

/// Reads TOML. Throws InputError with line and column for what is not TOML.
Node read_document(std::string_view text, const std::string& file_name);

/// What stands behind an equals sign: TOML, or text without its quotes (350 mm).
Node parse_value(const std::string& text);

/// The value as TOML on one line: `parse_value` of it gives an equal one.
std::string toml_literal(const Node& value);
/// A TOML text in its quotes, and a TOML key: bare where that is allowed, else quoted.
std::string toml_text(std::string_view text);
std::string toml_key(const std::string& name);

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
  void add(const Place& place, const std::string& path, const std::string& message);
};

/// What a place is reported under: an override, a base or the recipe.
const std::string& file_of(const Place& place, const Reading& reading);
/// Adds a problem, once.
void add_problem(Reading& reading, const Place& place, const std::string& path, const std::string& message);

struct Record;
using RecordTable = std::vector<Record>;

/// One declared key with what it holds, ready to be written as TOML or documented.
struct Record {
  enum class Kind { value, section, sections };
  enum class Type { number, integer, flag, text, numbers, choice, other };  ///< of a value
  struct Choice {
    std::string literal, sentence;
    Word word = {};  ///< that it is; none of a form with a quantity
  };
  Key key;
  std::string form = {};     ///< a literal with dots for what is to be filled in
  std::string allowed = {};  ///< "above 0 mm"
  Type type = Type::other;
  std::string_view unit = {};  ///< that a number is written in; empty: it has no dimension
  std::string example = {};    ///< a literal of some value, where the form with 1 for its dots is none
  Kind kind = Kind::value;
  std::string condition = {};               ///< `law = "normal"`, if the key exists only then
  std::optional<std::string> literal = {};  ///< value in TOML; nothing if it is not set
  std::vector<Choice> choices = {};
  bool present = true;                        ///< of a section
  std::vector<RecordTable> tables = {};       ///< section: one; sections: one each
  std::vector<std::string> table_names = {};  ///< of sections with names
  bool named = false;
  std::string name() const { return std::string(key.name); }
};

/// The keys that a declaration visits, as they are set; or every key there is in it, one table for each list.
RecordTable record_of(const Visit& declare, bool every_key = false);

/// A value of a key as it is written, on its way into what the declaration names.
struct Written {
  const Node& node;
  std::string path;
  Reading& reading;
  /// Adds a problem; nothing is what has been read.
  std::nullopt_t refuse(const std::string& message) const { return refuse(node.place, message); }
  std::nullopt_t refuse(const Place& place, const std::string& message) const {
    return reading.add(place, path, message), std::nullopt;
  }
  /// Whether it is what is wanted; a problem says so where it is not.
  bool is(bool what, const std::string& wanted) const {
    if (!what) refuse(std::string("is ") + kind_name(node) + ", but must be " + wanted);
    return what;
  }
  bool is_a(Node::Kind kind, const std::string& wanted) const { return is(node.kind == kind, wanted); }
  Written item(std::size_t i) const { return {node.items[i], path + "." + std::to_string(i), reading}; }
};

/// Knows of every kind of value how it is written and how it is read, both in one place; what is done with the two is
/// up to those that inherit it.
class KeyVisitor : public ParameterVisitor {
 public:
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

 protected:
  void visit_text(const Key& key, std::string& value, bool names_file);
  /// One key that holds a value: `record` says what is there now, and `read` takes over what is written, or adds what
  /// is wrong with it.
  virtual void visit(Record record, const std::function<void(const Written&)>& read) = 0;
};

/// The tree that a text, its base and its overrides make, under the names that `keys` have now; problems of base and
/// overrides are collected. For an empty text the InputError names the template that `arenite init` writes.
Node read_tree(std::string_view text, Reading& reading, const std::vector<std::string>& overrides,
               const RecordTable& keys, std::string_view start_from);

/// Puts a value at a dotted key into the tree (`put`); names of before become those of now, as `keys` knows them.
void set_value(Node& root, const std::string& key, Node value, const RecordTable& keys);

/// Reads all keys that a declaration visits. Throws InputError with every problem found, in the order of the text.
void read_declared(const Node& root, Reading& reading, const Visit& declare);

/// Every key of a recipe of a simulation.
const RecordTable& recipe_keys();

// Former names: keys and words say theirs where they are declared.
/// Adds the sentence that `former` is now called `now`, once.
void note_former_name(std::vector<std::string>& notices, std::string_view former, std::string_view now);
/// Gives keys and words that stand under a name of before the one of now; a notice says so of each. Where both stand,
/// the former is left as it is.
void rename_former_keys(Node& root, const RecordTable& keys, std::vector<std::string>& notices);
/// The records under the names that keys and words had first, from which names of results and seeds of samples follow.
RecordTable under_former_names(RecordTable table);

/// The keys that are set, as TOML.
std::string write_toml(const RecordTable& root);

/// The keys that are not as in `all`, one a line with its whole path: what results are named by, so that neither a key
/// at its default nor one that a later version adds changes a name.
std::string write_changes(const RecordTable& root, const RecordTable& all);

/// As write_toml for people: explained, and keys that are as in `all` as comments.
std::string write_commented_toml(const RecordTable& root, const RecordTable& all);

/// Tables of all keys (Markdown).
std::string write_key_tables(const RecordTable& all);

}  // namespace arenite::recipe
