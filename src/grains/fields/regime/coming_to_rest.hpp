#pragma once
#include <cstdint>
#include <span>

#include "grains/dem/stage.hpp"
#include "grains/fields/regime/prediction.hpp"

// How long a sample takes to come to rest under the drives of a stage: it closes, and then settles; and how many steps
// of disks and spheres that is, or the time that a stage is asked to last. SI units.
namespace arenite::dem {
template <int D> class EngineIn;
}  // namespace arenite::dem

namespace arenite::fields {

/// An estimate of the time after which a sample rests, s: without drag the unbalanced force falls by a factor e in some
/// 4.5 periods of its slowest wave, in one where every side presses and takes up the waves that reach it (measured on
/// examples/01, 06 and 07); drag, 1/s, adds half its rate.
double settling_time(double period, double drag, double unbalanced, bool pressed_all_round = false);

/// That of a sample with these sides whose critical drag is known, s.
double settling_time(const dem::Stage& stage, std::span<const dem::SideDrive> sides, double critical,
                     double steady_drag);

/// How fast the sides of a loose sample come in under a pressure, m/s: some 2 I sqrt(F H/M), of its bulk density M/(H
/// A) (dem/walls.hpp; measured on examples/01 and 05).
double closing_speed(double inertial_number, double pressure, double bulk_density);

/// What presses a sample of disks together.
struct Closing {
  bool along_x = false, along_y = false;  ///< whether a side presses there
  double pressure = 0;                    ///< Pa, the largest
  bool without_friction = false;
};
/// Time in which a loose sample is pressed together, by its sides or its weight, s. `bulk` is then as dense as that
/// leaves it.
double closing_time(const dem::Stage& stage, const Closing& closing, Bulk& bulk);

/// Time in which spheres come to rest, s.
struct TimeToRest {
  double closing = 0;   ///< until they are as dense as the drives make them
  double settling = 0;  ///< then, and after each increment
};
/// From where they are; the sample is `larger` times as wide as the one in hand.
TimeToRest time_to_rest(const dem::EngineIn<3>& engine, double steady_drag, const dem::Stage& stage, double larger);

/// Steps of a time that is an estimate, however long.
std::int64_t about_steps(double time, double time_step);

/// Time, steps and states of a stage that lasts as long as it is asked to. Throws InputError for too many steps.
void count_steps(StagePrediction& prediction, const dem::Stage& stage);

/// The same of a stage that ends at rest: it closes, s, and settles after each increment, s.
void count_steps(StagePrediction& prediction, const dem::Stage& stage, double closing, double settling);

/// Steps, roughly, in which spheres come to rest under the drives of a stage, from where they are: as dense as they
/// then get, and settled.
std::int64_t steps_to_rest(const dem::EngineIn<3>& engine, double steady_drag, const dem::Stage& stage);

/// Time and steps of a stage of spheres that the engine has begun; the sample is `larger` times as wide as the one in
/// hand. `at_rest`: whether a stage before has brought it to rest, and so dense; then whether this one has.
StagePrediction predict_stage(const dem::EngineIn<3>& engine, double steady_drag, const dem::Stage& stage,
                              double larger, bool& at_rest);

}  // namespace arenite::fields
