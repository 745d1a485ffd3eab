#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace arenite {

/// Number of single-letter insertions, deletions, replacements and swaps of neighbours that turn `a` into `b`.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The candidate closest to `word` that a typing slip could have meant; empty if none is near. The first of equals.
std::string nearest(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace arenite
