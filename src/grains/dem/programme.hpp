#pragma once
#include <array>
#include <string>
#include <vector>

#include "core/vec.hpp"
#include "grains/dem/parameters.hpp"

namespace arenite::dem {

struct Sample;

/// A quantity of a stage's loading that a table gives over time: linear between two rows, as the first and last say before and after them; two rows of
/// one time are a jump.
struct Programme {
  static constexpr int drives = 3, slide = sides * drives, shear_rate = slide + sides, gravity_size = shear_rate + 1, gravity_angle = gravity_size + 1,
                       boundary = gravity_angle + 1, count = boundary + 8;
  /// What drives a boundary: where it is from where it was as the programme began, how fast it is, or the force on it.
  enum class OfBoundary { x, y, angle, velocity_x, velocity_y, spin, force_x, force_y };
  int of = 0;               ///< drives * side + (0: velocity inward, 1: force, 2: pressure), slide + side, boundary + OfBoundary, or one of the others
  std::vector<Vec2> table;  ///< time since the stage began, s, and value in SI
  bool repeat = false;      ///< from the last row on it begins anew
  std::string name = {};    ///< of the boundary that it drives
  bool operator==(const Programme&) const = default;

  /// At a time since the stage began, s.
  double at(double time) const;
  bool drives_side() const { return of < slide; }
  bool slides_side() const { return of >= slide && of < shear_rate; }
  int side() const { return of / drives; }  ///< that is driven
  int drive() const { return of % drives; }
  bool drives_boundary() const { return of >= boundary; }
  OfBoundary of_boundary() const { return static_cast<OfBoundary>(of - boundary); }
  /// Tables of places must neither jump nor, where they begin anew, end elsewhere than they began.
  bool is_of_place() const { return drives_boundary() && of_boundary() <= OfBoundary::angle; }
  bool is_of_force() const { return drives_boundary() && of_boundary() >= OfBoundary::force_x; }
  /// Along x (0), along y (1), or around (2).
  int boundary_axis() const { return (of - boundary) % 3; }
};

/// A target of a programme as recipes call it, and the unit that its values are shown in.
struct ProgrammeTarget {
  const char *word, *unit;
};
inline constexpr std::array<ProgrammeTarget, Programme::count> programme_targets{
    {{"left.velocity", "mm/s"}, {"left.force", "kN"},        {"left.pressure", "kPa"},        {"right.velocity", "mm/s"},      {"right.force", "kN"},
     {"right.pressure", "kPa"}, {"bottom.velocity", "mm/s"}, {"bottom.force", "kN"},          {"bottom.pressure", "kPa"},      {"top.velocity", "mm/s"},
     {"top.force", "kN"},       {"top.pressure", "kPa"},     {"slide.left", "mm/s"},          {"slide.right", "mm/s"},         {"slide.bottom", "mm/s"},
     {"slide.top", "mm/s"},     {"shear_rate", "1/s"},       {"gravity_size", "m/s^2"},       {"gravity_angle", "deg"},        {"boundary.x", "mm"},
     {"boundary.y", "mm"},      {"boundary.angle", "deg"},   {"boundary.velocity_x", "mm/s"}, {"boundary.velocity_y", "mm/s"}, {"boundary.spin", "deg/s"},
     {"boundary.force_x", "N"}, {"boundary.force_y", "N"}}};

/// What a sample follows, from a time on.
struct Programmes {
  std::vector<Programme> list;
  double begin = 0;                            ///< s, of the sample's time
  double gravity_size = 0, gravity_angle = 0;  ///< m/s^2 and rad, where no programme says otherwise
  const Programme* find(int of) const;
  const Programme* of_side(int side) const;  ///< the one that drives it
};

/// What drives the walls where programmes do, and elsewhere as given: a force as it is now; a velocity stays, since it is set step by step.
WallDrives under_programmes(const Sample& sample, WallDrives drives);

/// Shears a periodic cell at another rate from now on; grains are given the velocities of the change.
void change_shear_rate(Sample& sample, double rate);

/// Before a step: velocities of sides and boundaries and the rate of shear are those of its middle, so that the ways made are the areas below the
/// tables; boundaries whose place is given go there.
void follow_velocities(Sample& sample);

/// After the motion of a step: forces, pressures and gravity are those of its end.
void follow_loads(Sample& sample);

}  // namespace arenite::dem
