#include "grains/fields/loading_axis.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace arenite::fields {
namespace {

using Kind = dem::SideDrive::Kind;
using What = dem::Programme::What;

/// What a programme first does of this; `value` where none drives it.
double at_first(const dem::Stage& stage, dem::Driven of, double value) {
  for (const dem::Programme& programme : stage.programmes)
    if (programme.of == of)
      for (const Vec2& row : programme.table)
        if (row.y != 0) return row.y;
  return value;
}

/// The way that cycles of strain first take, if it is this that cycles.
double cycled(const dem::Stage& stage, int of) {
  return stage.strain_cycles && stage.strain_cycles->of == of ? stage.strain_cycles->max : 0;
}

/// Above 0 where du_x/dy + du_y/dx is.
double sheared(const dem::Stage& stage) {
  const auto slide = [&](int side) { return at_first(stage, {What::slide, side}, stage.slide[side]); };
  const double cell = at_first(stage, {What::shear_rate}, stage.shear_rate);
  const double slid = slide(top) - slide(bottom) + slide(right) - slide(left);
  for (const double way : {cell, cycled(stage, dem::StrainCycles::shear), slid})
    if (way != 0) return way;
  return 0;
}

/// Above 0 where the two sides across an axis, as a whole, move in.
double closing(const dem::Stage& stage, int axis) {
  double speed = 0;
  for (int side = 2 * axis; side < 2 * axis + 2; ++side) {
    speed += cycled(stage, side);
    if (stage.side[side].kind == Kind::velocity)
      speed += at_first(stage, {What::velocity, side}, stage.side[side].value);
  }
  return speed;
}

bool presses(const dem::Stage& stage, int axis) {
  return stage.side[2 * axis].presses() || stage.side[2 * axis + 1].presses();
}

/// The largest pressure on the two sides across an axis; nothing where a force or a programme says how they press.
std::optional<double> pressure(const dem::Stage& stage, int axis) {
  std::optional<double> most;
  for (int side = 2 * axis; side < 2 * axis + 2; ++side) {
    const dem::SideDrive& drive = stage.side[side];
    const bool follows = std::ranges::any_of(stage.programmes, [&](const dem::Programme& programme) {
      return programme.of == dem::Driven{What::pressure, side};
    });
    if (drive.presses() && (follows || drive.kind == Kind::force)) return std::nullopt;
    if (drive.presses()) most = std::max(most.value_or(drive.value), drive.value);
  }
  return most;
}

double angle_of(int axis) { return axis == 0 ? 0 : std::numbers::pi / 2; }

}  // namespace

std::optional<double> loading_axis(const dem::Stage& stage) {
  const double shear = sheared(stage), x = closing(stage, 0), y = closing(stage, 1);
  if (shear != 0) return x == 0 && y == 0 ? std::optional((shear > 0 ? 3 : 1) * std::numbers::pi / 4) : std::nullopt;
  if (x != 0 || y != 0) {
    if ((x > 0 && y > 0) || (x < 0 && y < 0)) return std::nullopt;
    return angle_of(x > 0 || y < 0 ? 0 : 1);
  }
  if (presses(stage, 0) != presses(stage, 1)) return angle_of(presses(stage, 0) ? 0 : 1);
  const auto across_x = pressure(stage, 0), across_y = pressure(stage, 1);
  if (!across_x || !across_y || *across_x == *across_y) return std::nullopt;
  return angle_of(*across_x > *across_y ? 0 : 1);
}

}  // namespace arenite::fields
