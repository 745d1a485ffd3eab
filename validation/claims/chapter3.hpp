#pragma once
#include <string>

#include "validation/results.hpp"

namespace arenite::validation {

/// A laboratory sample of tables 3.1 and 3.2, identified by its number of POM grains.
struct LaboratorySample {
  const char* name;
  const char* pom_grains;
};
inline constexpr LaboratorySample sample_2{"#2", "638"}, sample_8{"#8", "334"}, sample_11{"#11", "106"},
    sample_12{"#12", "86"};

inline std::vector<Run> runs_of(const Results& results, const LaboratorySample& sample) {
  return results.runs("thesis-ch3", {{"populations.0.count", sample.pom_grains}});
}
inline Where where(const LaboratorySample& sample) { return {{"populations.0.count", sample.pom_grains}}; }

}  // namespace arenite::validation
