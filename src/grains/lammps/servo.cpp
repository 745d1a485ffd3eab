#include "grains/lammps/servo.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "grains/dem/walls.hpp"
#include "grains/lammps/laws.hpp"

namespace arenite::lammps {
namespace {

constexpr char letters[] = "xyz";

template <int D> bool is_wall(const dem::SampleIn<D>& s, int side) {
  return !s.domain.is_periodic(side) && s.domain.wall[side].present;
}

/// The product of the sample's lengths across an axis, m or m^2, and what makes it an area.
template <int D> std::string across(int axis, const char* before) {
  std::string text;
  for (int other = 0; other < D; ++other)
    if (other != axis) text += fmt::format("{}{}{}", text.empty() ? "" : "*", before, letters[other]);
  return text;
}
double thickness_of(const dem::SampleIn<2>& s) { return s.domain.thickness; }
double thickness_of(const dem::SampleIn<3>& /*sample*/) { return 1; }

/// What a side aims at, N: a pressure on the area of now, or a force.
template <int D> std::string aim_of(const dem::SampleIn<D>& s, const dem::Leg& leg, int side) {
  if (leg.side[side].kind != dem::SideDrive::Kind::pressure) return fmt::format("{:.17g}", s.wall[side].drive.value);
  return fmt::format("{:.17g}*{}", leg.side[side].value * thickness_of(s), across<D>(axis_of(side), "v_size_"));
}

/// A way that hangs on nothing but time; of a side under a load it is defined anew below.
template <int D> std::string ways(const dem::SampleIn<D>& s) {
  std::string text;
  for (int side = 0; side < sides_in<D>; ++side) {
    if (!is_wall(s, side)) continue;
    const auto& drive = s.wall[side].drive;
    const char* name = any_side_names[side];
    if (drive.kind == dem::DriveKind::velocity)
      text += fmt::format("variable way_{} equal \"{:.17g}*step*dt\"\n", name, drive.value);
    else text += fmt::format("variable way_{} equal 0\n", name);
    if (is_pressed(s, side)) text += fmt::format("variable base_{} equal 0\n", name);
  }
  return text;
}

/// Lengths of the sample along its axes, m.
template <int D> std::string sizes(const dem::SampleIn<D>& s) {
  std::string text;
  for (int axis = 0; axis < D; ++axis)
    text += s.domain.periodic[axis]
                ? fmt::format("variable size_{0} equal l{0}\n", letters[axis])
                : fmt::format("variable size_{} equal \"{:.17g} + v_way_{} - v_way_{}\"\n", letters[axis],
                              s.domain.extent(axis), any_side_names[2 * axis + 1], any_side_names[2 * axis]);
  return text;
}

/// A plane a wall, and the law of the grains of each material with it.
template <int D> std::string walls(const dem::SampleIn<D>& s) {
  std::string text;
  for (int side = 0; side < sides_in<D>; ++side) {
    if (!is_wall(s, side)) continue;
    const int axis = axis_of(side);
    std::string place, normal, move;
    for (int k = 0; k < 3; ++k) {
      place += fmt::format(" {:.17g}", k == axis ? s.domain.wall[side].position : 0.0);
      normal += fmt::format(" {:g}", k == axis ? inward_sign(side) : 0.0);
      move += k == axis ? fmt::format(" v_way_{}", any_side_names[side]) : " NULL";
    }
    const bool moves = s.wall[side].drive.kind != dem::DriveKind::fixed;
    text += fmt::format("region {} plane{}{}{}\n", any_side_names[side], place, normal, moves ? " move" + move : "");
    for (std::size_t m = 0; m < s.start.materials.size(); ++m)
      text += fmt::format("fix {} material_{} wall/gran/region granular {} region {} contacts\n",
                          wall_fix(side, static_cast<int>(m)), m + 1, wall_words(s, static_cast<int>(m)),
                          any_side_names[side]);
  }
  return text;
}

/// c of a side under a load, N s/m, where the sample bears it and where it is loose.
struct Braking {
  double bearing = 0, loose = 0;
};
template <int D> Braking braking_of(const dem::SampleIn<D>& s, int side) {
  const auto& body = s.wall[side];
  const double yielding = dem::yielding_damping(s, static_cast<std::size_t>(side));
  const double bearing = std::clamp(yielding, 0.3 * body.impedance, body.impedance);
  const double layers = std::max(1.0, s.domain.extent(axis_of(side)) / (2 * s.largest_radius));
  return {bearing, yielding > 0 ? std::min(bearing, yielding / layers) : bearing};
}

/// Load, aim and rate (inward, m/s) of something called `name`.
std::string rate_lines(const std::string& name, const std::string& load, const std::string& aim, const Braking& c,
                       bool aims) {
  std::string text = fmt::format("variable load_{0} equal \"{1}\"\nvariable aim_{0} equal \"{2}\"\n", name, load, aim);
  // LAMMPS has no least of two numbers: (1 + y - |1 - y|)/2 is that of 1 and y.
  const std::string share = fmt::format("10*abs(v_load_{0})/v_aim_{0}", name);
  const std::string braking =
      aims ? fmt::format("({:.9g} + {:.9g}*(1 + {} - abs(1 - {})))", c.loose, 0.5 * (c.bearing - c.loose), share, share)
           : fmt::format("{:.9g}", c.bearing);
  return text + fmt::format("variable rate_{0} equal \"(v_aim_{0} - v_load_{0})/{1}\"\n", name, braking);
}

template <int D> std::string pressed_wall_lines(const dem::SampleIn<D>& s, const dem::Leg& leg, int side) {
  const char* name = any_side_names[side];
  std::string text, load;
  for (std::size_t m = 0; m < s.start.materials.size(); ++m) {
    text += fmt::format("compute push_{0}_{1} all reduce sum f_{2}[{3}]\n", name, m + 1,
                        wall_fix(side, static_cast<int>(m)), 2 + axis_of(side));
    load += fmt::format("{}c_push_{}_{}", load.empty() ? "" : " + ", name, m + 1);
  }
  text += rate_lines(name, fmt::format("{:g}*({})", inward_sign(side), load), aim_of(s, leg, side), braking_of(s, side),
                     s.wall[side].drive.value > 0);
  return text + fmt::format(
                    "fix sum_{0} all ave/time 1 1 1 v_rate_{0} ave running\n"
                    "variable way_{0} equal \"v_base_{0} + {1:g}*f_sum_{0}*(step - v_first)*dt\"\n",
                    name, inward_sign(side));
}

/// How fix deform moves an axis of the cell; empty where nothing does.
template <int D> std::string axis_lines(const dem::SampleIn<D>& s, const dem::Leg& leg, int axis, std::string& deform) {
  const int low = 2 * axis, high = low + 1, pressed = is_pressed(s, high) ? high : low;
  const char letter = letters[axis];
  if (!is_pressed(s, pressed)) {
    const double rate = s.domain.wall[high].velocity - s.domain.wall[low].velocity;
    if (rate != 0) deform += fmt::format(" {} vel {:.17g}", letter, rate);
    return "";
  }
  const double edges = is_pressed(s, low) && is_pressed(s, high) ? 2 : 1;
  deform += fmt::format(" {0} variable v_way_{0} v_grows_{0}", letter);
  const std::string name(1, letter);
  return rate_lines(name, fmt::format("f_pressure[{}]*{}", axis + 1, across<D>(axis, "l")), aim_of(s, leg, pressed),
                    braking_of(s, pressed), s.wall[pressed].drive.value > 0) +
         fmt::format(
             "variable grows_{0} equal \"{1:g}*v_rate_{0}\"\n"
             "variable from_{0} equal $(l{0}:%.17g)\n"
             "variable way_{0} equal \"l{0} + dt*v_grows_{0} - v_from_{0}\"\n",
             letter, -edges);
}

template <int D> std::string cell_lines(const dem::SampleIn<D>& s, const dem::Leg& leg) {
  std::string text, deform;
  for (int axis = 0; axis < D; ++axis)
    if (s.domain.periodic[axis]) text += axis_lines(s, leg, axis, deform);
  if (!text.empty())
    text =
        "compute pressure all pressure NULL virial\n"
        "fix pressure all ave/time 1 1 1 c_pressure[1] c_pressure[2] c_pressure[3]\n" +
        text;
  return deform.empty() ? text : text + "fix cell all deform 1" + deform + " remap x units box\n";
}

}  // namespace

template <int D> std::string side_lines(const dem::SampleIn<D>& s, const Task& task) {
  std::string text = ways(s) + sizes(s) + walls(s) + "variable first equal $(step)\n";
  if (const std::string pressed = pressed_walls(s, "", ""); !pressed.empty())
    text += fmt::format("if \"${{from}} != data\" then \"shell sh {} $(step)\" \"include walls.now\"\n", names::walls);
  for (int side = 0; side < sides_in<D>; ++side)
    if (is_wall(s, side) && is_pressed(s, side)) text += pressed_wall_lines(s, task.leg, side);
  return text + cell_lines(s, task.leg);
}

template <int D> std::string pressed_walls(const dem::SampleIn<D>& s, const char* before, const char* after) {
  std::string text;
  for (int side = 0; side < sides_in<D>; ++side)
    if (is_wall(s, side) && is_pressed(s, side)) text += fmt::format(" {}{}{}", before, any_side_names[side], after);
  return text;
}

template <int D> std::string loads_are_off(const dem::SampleIn<D>& s, double share) {
  std::string text;
  for (int side = 0; side < sides_in<D>; ++side) {
    if (!is_pressed(s, side) || s.wall[side].drive.value <= 0) continue;
    const std::string name = is_wall(s, side) ? any_side_names[side] : std::string(1, letters[axis_of(side)]);
    text += fmt::format(" || (abs(v_load_{0}/v_aim_{0} - 1) > {1:g})", name, share);
  }
  return text;
}

#define ARENITE_OF(D)                                                                    \
  template std::string side_lines(const dem::SampleIn<D>&, const Task&);                 \
  template std::string pressed_walls(const dem::SampleIn<D>&, const char*, const char*); \
  template std::string loads_are_off(const dem::SampleIn<D>&, double);
ARENITE_OF(2)
ARENITE_OF(3)
#undef ARENITE_OF

}  // namespace arenite::lammps
