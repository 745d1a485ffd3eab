#pragma once
#include <string>

#include "core/parameters.hpp"
#include "recipe/record.hpp"

namespace arenite::recipe {

/// The keys that a declaration visits, as they are set; or every key there is in it, one table for each list.
RecordTable record_of(const Visit& declare, bool every_key = false);

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
