#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "io/table.hpp"

namespace arenite::app {

/// What `read` gives; an error of a value, which has no place, as one of its option.
template <class Read>
auto option_value(const char* option, Read read) {
  try {
    return read();
  } catch (const InputError& error) {
    throw InputError(std::string(option) + ": " + error.problems().front().message);
  }
}

inline std::string trimmed(const std::string& text) { return std::string(io::trimmed(text)); }

/// "a, b" as a and b.
inline std::vector<std::string> parts_of(const std::string& text) {
  std::vector<std::string> parts;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t comma = std::min(text.find(',', from), text.size());
    parts.push_back(trimmed(text.substr(from, comma - from)));
    from = comma + 1;
  }
  return parts;
}

}  // namespace arenite::app
