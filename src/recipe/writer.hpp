#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/parameters.hpp"

namespace arenite::recipe {

struct Record;
using RecordTable = std::vector<Record>;

/// One declared key with what it holds, ready to be written as TOML or documented.
struct Record {
  enum class Kind { value, section, sections };
  Kind kind = Kind::value;
  std::string name, sentence;
  bool required = false;
  std::string condition;                                   ///< `law = "normal"`, if the key exists only then
  std::optional<std::string> literal;                      ///< value in TOML; nothing if it is not set
  std::string form;                                        ///< a literal with dots for what is to be filled in
  std::string allowed;                                     ///< "above 0 mm"
  std::vector<std::pair<std::string, std::string>> words;  ///< of a choice, with their meaning
  bool present = true;                                     ///< of a section
  std::vector<RecordTable> tables;                         ///< section: one; sections: one each
  std::vector<std::string> table_names;                    ///< of sections with names
  bool named = false;
};

/// The keys that a declaration visits, as they are set; or every key there is in it, one table for each list.
RecordTable record_of(const Visit& declare, bool every_key = false);

/// The keys that are set, as TOML.
std::string write_toml(const RecordTable& root);

/// The keys that are not as in `all`, one a line with its whole path: what results are named by, so that neither a key at its
/// default nor one that a later version adds changes a name.
std::string write_changes(const RecordTable& root, const RecordTable& all);

/// As write_toml for people: explained, and keys that are as in `all` as comments.
std::string write_commented_toml(const RecordTable& root, const RecordTable& all);

/// Tables of all keys (Markdown).
std::string write_key_tables(const RecordTable& all);

/// A TOML text in its quotes.
std::string toml_text(std::string_view text);

/// A TOML key: bare where that is allowed, else quoted.
std::string toml_key(const std::string& name);

}  // namespace arenite::recipe
