#pragma once
#include "grains/dem/stage.hpp"

namespace arenite::dem {

/// A programme's value, integrated from the beginning of the stage to such a time: the way of a velocity.
double integral(const Programme& programme, double time);

/// Acceleration of gravity at a time since the stage began, m/s^2, as its programmes change or turn it; zero where it
/// has none.
Vec2 gravity_at(const Stage& stage, double time);

}  // namespace arenite::dem
