#pragma once
#include <fmt/core.h>

#include <string>
#include <utility>

#include "core/error.hpp"

namespace arenite::io {

/// What is wrong with a file, and how to fix it: InputError, as a sentence after the file's name.
template <class... A> [[noreturn]] void refuse(const std::string& file, fmt::format_string<A...> sentence, A&&... arguments) {
  throw InputError(file, 0, fmt::format(sentence, std::forward<A>(arguments)...));
}

}  // namespace arenite::io
