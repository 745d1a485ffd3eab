#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/parameters.hpp"

namespace arenite::recipe {

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
  IntegerRange integers = {};  ///< of a whole number
  std::string name() const { return std::string(key.name); }
};

}  // namespace arenite::recipe
