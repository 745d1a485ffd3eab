#pragma once
#include <string>
#include <utility>
#include <vector>

namespace arenite::recipe {

/// Keys and values of a recipe as texts, in its order: keys with dots, items of lists counted from 0. A recipe of a
/// simulation or a film that this version reads has all its defaults, too; of another it is what is written there, and
/// nothing of what is no TOML.
std::vector<std::pair<std::string, std::string>> settings_of(const std::string& recipe);

}  // namespace arenite::recipe
