#pragma once
#include "report/figures/stage_figures.hpp"

namespace arenite::report::figures {

/// Mass that has passed against time, with the rate of the steady part as its slope.
Drawings discharge(const StageData& data);
/// Of a sample that spreads: its farther front against time, and its profile at some of the states.
Drawings collapse(const StageData& data);
Drawings collapse(const SphereResult& stage);
/// Of a drum that turns: the angle of the surface against time, with its mean.
Drawings surface_angle(const StageData& data);
Drawings surface_angle(const SphereResult& stage);

}  // namespace arenite::report::figures
