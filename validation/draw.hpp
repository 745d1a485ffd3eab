#pragma once
#include <string>
#include <utility>
#include <vector>

namespace arenite::validation {

/// Runs whose swept values are these; numbers are compared as numbers. Empty: all runs.
using Where = std::vector<std::pair<std::string, std::string>>;

/// Runs of a study of which further seeds would make a check surer.
struct Draw {
  std::string study;
  Where where;
  bool operator==(const Draw&) const = default;
};

}  // namespace arenite::validation
