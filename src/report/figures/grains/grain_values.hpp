#pragma once
#include <string_view>
#include <vector>

#include "model/result.hpp"

namespace arenite::report::figures {

/// A number of every grain of a stored state by its name (texture/grain_quantities.hpp), also one that takes the states
/// before it, or how its stage is measured. Empty where the state does not tell it.
template <int D>
std::vector<double> grain_values(const StageResultIn<D>& stage, const SnapshotIn<D>& state, std::string_view name);

/// In size, below which all but a hundredth of these numbers lie: what their unit is chosen by, and where scales end.
/// 0 where there is none.
double most_of(const std::vector<double>& values);

}  // namespace arenite::report::figures
