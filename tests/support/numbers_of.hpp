#pragma once
#include <initializer_list>
#include <string>
#include <vector>

#include "statistics/numbers.hpp"

namespace arenite::test {

/// As they are written in JSON; not known where that is none.
inline Numbers numbers_of(const std::string& json) { return from_json(json).value_or(Numbers{}); }

inline std::vector<Numbers> numbers_of(std::initializer_list<const char*> json) {
  std::vector<Numbers> all;
  for (const char* text : json) all.push_back(numbers_of(std::string(text)));
  return all;
}

}  // namespace arenite::test
