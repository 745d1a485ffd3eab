#pragma once
#include <numeric>
#include <string>
#include <vector>

namespace arenite::test {

/// All sentences, one after the other, to look for words in.
inline std::string all_of(const std::vector<std::string>& sentences) {
  return std::accumulate(sentences.begin(), sentences.end(), std::string());
}

}  // namespace arenite::test
