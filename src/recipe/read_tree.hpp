#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "recipe/document.hpp"
#include "recipe/reader.hpp"
#include "recipe/record.hpp"

namespace arenite::recipe {

/// The tree that a text, its base and its overrides make, under the names that `keys` have now; problems of base and
/// overrides are collected. For an empty text the InputError names the template that `arenite init` writes.
Node read_tree(std::string_view text, Reading& reading, const std::vector<std::string>& overrides,
               const RecordTable& keys, std::string_view start_from);

}  // namespace arenite::recipe
