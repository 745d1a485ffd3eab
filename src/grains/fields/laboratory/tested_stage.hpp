#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "model/result.hpp"

namespace arenite::fields {

/// Whether a stage has curves: a history of at least two rows, and states.
template <int D> bool has_history(const StageResultIn<D>& stage);

/// The place of the stage of this name, or of the last one, that has a history. Throws InputError where there is none.
std::size_t stage_with_history(const std::vector<const StageResult*>& stages, const std::optional<std::string>& name);
std::size_t stage_with_history(const std::vector<const SphereResult*>& stages, const std::optional<std::string>& name);

}  // namespace arenite::fields
