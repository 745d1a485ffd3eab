#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace arenite {

/// By what kind of colours pictures show a number: even ones, those of stresses (pale where there is little),
/// diverging ones about 0, ones that come back to where they began, and those of a photograph. Page and print have a
/// map of colours for each.
enum class ColourScale : std::uint8_t { even, stress, diverging, cyclic, grey };

inline constexpr std::string_view word_of(ColourScale scale) {
  constexpr std::array<std::string_view, 5> words{"even", "stress", "diverging", "cyclic", "grey"};
  return words[static_cast<std::size_t>(scale)];
}

}  // namespace arenite
