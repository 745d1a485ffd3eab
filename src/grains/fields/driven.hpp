#pragma once
#include <vector>

#include "grains/dem/stage.hpp"
#include "model/result.hpp"

namespace arenite::fields {

/// Adds to a stage's history, and to its rows by cycles, what the stage drove without that the sample would tell of it:
/// `top_slid`, m, the way that a wall has slid along itself since the stage began, of walls that slide; `gravity_x` and
/// `gravity_y`, m/s^2, where programmes change or turn gravity. Programmes count as they ran, by their integral.
template <int D> void add_driven(StageResultIn<D>& result, const dem::Stage& stage);

/// When a stage began, s: as it knows, or by the rows of its history.
template <int D> double begin_of(const StageResultIn<D>& result, const dem::Stage& stage);
/// How long it lasted, s, of one with a duration, which something else may have ended; 0 of others.
template <int D> double length_of(const StageResultIn<D>& result, const dem::Stage& stage);

/// Gravity that acted at these rows of a history, m/s^2: as they say, or that of the whole stage.
std::vector<Vec2> gravity_in(const History& rows, const Asked& asked);
/// Size of the gravity that a stage was asked for, at its end, m/s^2; NaN where it is not known.
double gravity_size(const Asked& asked);

}  // namespace arenite::fields
