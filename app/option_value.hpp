#pragma once
#include <string>

#include "core/error.hpp"

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

}  // namespace arenite::app
