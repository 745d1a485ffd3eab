#pragma once
#include <fmt/core.h>

#include <cstdio>
#include <string>
#include <utility>

#include "core/text.hpp"

namespace arenite::app {

/// All that the program says goes through here, because titles, names and cells come from other people's files and may
/// hold what a terminal obeys.
inline void put(std::FILE* to, std::string_view text) {
  const std::string shown = printable(text);
  std::fwrite(shown.data(), 1, shown.size(), to);
}

template <class... T> void print(std::FILE* to, fmt::format_string<T...> sentence, T&&... values) {
  put(to, fmt::format(sentence, std::forward<T>(values)...));
}

template <class... T> void print(fmt::format_string<T...> sentence, T&&... values) {
  put(stdout, fmt::format(sentence, std::forward<T>(values)...));
}

}  // namespace arenite::app
