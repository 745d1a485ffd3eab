#include "grains/fields/loading_axis.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include "statistics/estimate.hpp"

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

/// How the second side across an axis slides before the first, or its programme or cycles do.
double sliding(const dem::Stage& stage, int axis) {
  const auto slide = [&](int side) {
    return at_first(stage, {What::slide, side}, stage.slide[static_cast<std::size_t>(side)]);
  };
  return slide(2 * axis + 1) - slide(2 * axis);
}

/// Of the cell, above 0 where du_x/dy is.
double cell_shear(const dem::Stage& stage) {
  const double rate = at_first(stage, {What::shear_rate}, stage.shear_rate);
  return rate != 0 ? rate : cycled(stage, dem::StrainCycles::shear);
}

/// Above 0 where du_x/dy + du_y/dx is.
double sheared(const dem::Stage& stage) {
  const double cell = cell_shear(stage);
  return cell != 0 ? cell : sliding(stage, 0) + sliding(stage, 1);
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

Vec3 along_axis(int axis) {
  Vec3 direction{};
  direction[axis] = 1;
  return direction;
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

std::optional<Vec3> loading_direction(const dem::Stage& stage) {
  const std::array<double, 3> speed{closing(stage, 0), closing(stage, 1), closing(stage, 2)};
  const std::array<double, 3> slides{sliding(stage, 0), sliding(stage, 1) + cell_shear(stage), sliding(stage, 2)};
  const auto some = [](double v) { return v != 0; };
  if (const auto sheared = std::ranges::count_if(slides, some); sheared > 0) {
    if (sheared > 1 || std::ranges::any_of(speed, some)) return std::nullopt;
    const int across = static_cast<int>(std::ranges::find_if(slides, some) - slides.begin());
    const double way = slides[static_cast<std::size_t>(across)] > 0 ? -1 : 1;
    return (way * along_axis(across == 0 ? 1 : 0) + along_axis(across)) / std::numbers::sqrt2;
  }
  const auto closing = std::ranges::count_if(speed, [](double v) { return v > 0; }),
             opening = std::ranges::count_if(speed, [](double v) { return v < 0; });
  if (closing > 1 || (closing == 0 && opening != 0 && opening != 2)) return std::nullopt;
  if (closing + opening > 0) return along_axis(static_cast<int>(std::ranges::max_element(speed) - speed.begin()));
  std::vector<std::pair<double, int>> press;  // and axis, the largest first
  for (int axis = 0; axis < 3; ++axis)
    if (presses(stage, axis)) press.emplace_back(pressure(stage, axis).value_or(statistics::unknown), axis);
  std::ranges::sort(press, std::greater{});
  if (press.size() > 1 && !(press[0].first > press[1].first)) return std::nullopt;
  const bool all_known = std::ranges::none_of(press, [](const auto& each) { return std::isnan(each.first); });
  return press.size() == 1 || (press.size() > 1 && all_known) ? std::optional(along_axis(press.front().second))
                                                              : std::nullopt;
}

}  // namespace arenite::fields
