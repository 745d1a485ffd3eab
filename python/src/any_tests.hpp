#pragma once
#include <pybind11/stl.h>

#include <variant>
#include <vector>

#include "core/problems.hpp"
#include "grains/fields/over_runs.hpp"

namespace arenite::python {

/// A stage of several that are shown together, of disks or of spheres.
using AnyStage = std::variant<const StageResult*, const SphereResult*>;

/// Stages with the packings before them, null where there is none. Throws InputError where one is None, or where there
/// are not as many packings.
inline std::vector<fields::AnyTest> any_tests(const std::vector<AnyStage>& stages,
                                              const std::vector<const Packing*>& before) {
  if (stages.size() != before.size())
    throw refusal("there are {} stages and {} packings before them; give as many, None where there is none",
                  stages.size(), before.size());
  std::vector<fields::AnyTest> tests;
  for (std::size_t k = 0; k < stages.size(); ++k) {
    if (const auto* spheres = std::get_if<const SphereResult*>(&stages[k])) {
      tests.emplace_back(*spheres);
      continue;
    }
    const StageResult* disks = std::get<const StageResult*>(stages[k]);
    if (!disks) throw InputError("a stage is None; give stages of results");
    tests.emplace_back(fields::Test{*disks, before[k]});
  }
  return tests;
}

}  // namespace arenite::python
