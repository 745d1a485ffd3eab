#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "grains/dem/exchange/exchange.hpp"
#include "grains/dem/membranes/skin.hpp"
#include "grains/dem/parameters.hpp"
#include "model/packing.hpp"

namespace arenite::dem {

/// What one side does in a stage. A force is reached from its present value in `increments` equal steps; a pressure
/// acts in full at once, on a wall or on a membrane in its place.
struct SideDrive {
  enum class Kind { fixed, velocity, force, pressure, membrane };
  Kind kind = Kind::fixed;
  double value = 0;  ///< m/s inward, N, or Pa
  /// Whether it is a load that is prescribed, and the side moves as that has it.
  bool presses() const { return kind == Kind::force || kind == Kind::pressure || kind == Kind::membrane; }
  bool is_skin() const { return kind == Kind::membrane; }
  bool operator==(const SideDrive&) const = default;
};

/// What a table over time drives: of a side, of the sample, or of a boundary where it is from where it was as the
/// programme began, how fast it is, or the force on it.
struct Driven {
  enum class What {
    velocity,  ///< of a side, inward
    force,
    pressure,
    slide,
    shear_rate,
    gravity_size,
    gravity_angle,
    boundary_x,
    boundary_y,
    boundary_z,
    boundary_angle,
    boundary_angle_x,
    boundary_angle_y,
    boundary_velocity_x,
    boundary_velocity_y,
    boundary_velocity_z,
    boundary_spin,
    boundary_spin_x,
    boundary_spin_y,
    boundary_force_x,
    boundary_force_y,
    boundary_force_z
  };
  What what = What::velocity;
  int side = left;  ///< of velocity, force, pressure and slide
  bool operator==(const Driven&) const = default;

  bool is(What other) const { return what == other; }
  bool is_of_side() const { return what <= What::pressure; }
  bool is_of_boundary() const { return what >= What::boundary_x; }
  /// Tables of places must neither jump nor, where they begin anew, end elsewhere than they began.
  bool is_of_place() const { return is_of_boundary() && what <= What::boundary_angle_y; }
  bool is_of_force() const { return what >= What::boundary_force_x; }
  /// How a side is driven so.
  SideDrive::Kind kind() const {
    return is(What::velocity) ? SideDrive::Kind::velocity
           : is(What::force)  ? SideDrive::Kind::force
                              : SideDrive::Kind::pressure;
  }
  /// Of what drives a boundary: along x, y or z (0 to 2), or about z, x or y (3 to 5).
  int way() const { return (static_cast<int>(what) - static_cast<int>(What::boundary_x)) % 6; }
  bool turns() const { return way() > 2; }
  /// Whether a sample of the plane has no such thing.
  bool is_of_space() const { return is_of_boundary() ? way() == 2 || way() > 3 : what <= What::slide && side > top; }
};

/// A quantity of a stage's loading that a table gives over time: linear between two rows, as the first and last say
/// before and after them; two rows of one time are a jump.
struct Programme {
  using What = Driven::What;
  Driven of;
  std::vector<Vec2> table;  ///< time since the stage began, s, and value in SI
  bool repeat = false;      ///< from the last row on it begins anew
  std::string name = {};    ///< of the boundary that it drives
  bool operator==(const Programme&) const = default;
  void declare(ParameterVisitor& visitor);

  /// At a time since the stage began, s.
  double at(double time) const;
};

/// A target of a programme as recipes call it, and the unit that its values are shown in.
struct ProgrammeTarget {
  const char *word, *unit;
  Driven of;
};
inline constexpr auto programme_targets = [] {
  using What = Driven::What;
  return std::to_array<ProgrammeTarget>({{"left.velocity", "mm/s", {What::velocity, left}},
                                         {"left.force", "kN", {What::force, left}},
                                         {"left.pressure", "kPa", {What::pressure, left}},
                                         {"right.velocity", "mm/s", {What::velocity, right}},
                                         {"right.force", "kN", {What::force, right}},
                                         {"right.pressure", "kPa", {What::pressure, right}},
                                         {"bottom.velocity", "mm/s", {What::velocity, bottom}},
                                         {"bottom.force", "kN", {What::force, bottom}},
                                         {"bottom.pressure", "kPa", {What::pressure, bottom}},
                                         {"top.velocity", "mm/s", {What::velocity, top}},
                                         {"top.force", "kN", {What::force, top}},
                                         {"top.pressure", "kPa", {What::pressure, top}},
                                         {"back.velocity", "mm/s", {What::velocity, back}},
                                         {"back.force", "kN", {What::force, back}},
                                         {"back.pressure", "kPa", {What::pressure, back}},
                                         {"front.velocity", "mm/s", {What::velocity, front}},
                                         {"front.force", "kN", {What::force, front}},
                                         {"front.pressure", "kPa", {What::pressure, front}},
                                         {"slide.left", "mm/s", {What::slide, left}},
                                         {"slide.right", "mm/s", {What::slide, right}},
                                         {"slide.bottom", "mm/s", {What::slide, bottom}},
                                         {"slide.top", "mm/s", {What::slide, top}},
                                         {"slide.back", "mm/s", {What::slide, back}},
                                         {"slide.front", "mm/s", {What::slide, front}},
                                         {"shear_rate", "1/s", {What::shear_rate}},
                                         {"gravity_size", "m/s^2", {What::gravity_size}},
                                         {"gravity_angle", "deg", {What::gravity_angle}},
                                         {"boundary.x", "mm", {What::boundary_x}},
                                         {"boundary.y", "mm", {What::boundary_y}},
                                         {"boundary.z", "mm", {What::boundary_z}},
                                         {"boundary.angle", "deg", {What::boundary_angle}},
                                         {"boundary.angle_x", "deg", {What::boundary_angle_x}},
                                         {"boundary.angle_y", "deg", {What::boundary_angle_y}},
                                         {"boundary.velocity_x", "mm/s", {What::boundary_velocity_x}},
                                         {"boundary.velocity_y", "mm/s", {What::boundary_velocity_y}},
                                         {"boundary.velocity_z", "mm/s", {What::boundary_velocity_z}},
                                         {"boundary.spin", "deg/s", {What::boundary_spin}},
                                         {"boundary.spin_x", "deg/s", {What::boundary_spin_x}},
                                         {"boundary.spin_y", "deg/s", {What::boundary_spin_y}},
                                         {"boundary.force_x", "N", {What::boundary_force_x}},
                                         {"boundary.force_y", "N", {What::boundary_force_y}},
                                         {"boundary.force_z", "N", {What::boundary_force_z}}});
}();
/// Its place among these.
std::size_t target_of(const Driven& driven);

/// What a sample follows, from a time on.
struct Programmes {
  std::vector<Programme> list;
  double begin = 0;                            ///< s, of the sample's time
  double gravity_size = 0, gravity_angle = 0;  ///< m/s^2 and rad, where no programme says otherwise
};

inline constexpr double standard_gravity = 9.81;  ///< m/s^2

/// When an increment counts as done.
struct EquilibriumCriterion {
  double unbalanced = 1e-4;                          ///< unbalanced force ratio
  double kinetic = 1e-6;                             ///< kinetic over elastic energy
  double falling = 1e-3;                             ///< share of grains that may still fall
  static constexpr double loose_over_kinetic = 1e5;  ///< of `loose_kinetic` unless it is set
  std::optional<double> loose_kinetic;  ///< kinetic energy of grains that carry nothing over elastic energy
  std::optional<double> mobilisation;   ///< mean |F_t|/F_n below this as well; unset: not asked
  std::int64_t max_steps = 20'000'000;  ///< of one increment; then the stage ends with exit status 3
  bool operator==(const EquilibriumCriterion&) const = default;
  void declare(ParameterVisitor& visitor);
};

/// Force cycles on one side after the ramp, e.g. 6-60 kN (T 3.2.1); each half cycle is a ramp to rest.
struct Cycles {
  int side = bottom;        ///< model/packing.hpp
  double min = 0, max = 0;  ///< Pa or N
  std::int64_t count = 0;
  std::int64_t increments = 5;              ///< a half cycle
  std::optional<std::int64_t> store_every;  ///< states are stored in the first cycle and every so many; unset: in
                                            ///< a few
  bool of_pressure = false;                 ///< min and max are in Pa, else in N
  bool operator==(const Cycles&) const = default;
  void declare(ParameterVisitor& visitor);

  SideDrive::Kind kind() const { return of_pressure ? SideDrive::Kind::pressure : SideDrive::Kind::force; }
};

/// Cycles of strain at a given rate: one side goes in and out, or a periodic cell is sheared to and fro, between two
/// strains of the sample as the stage begins. The first half cycle goes from there to `max`.
struct StrainCycles {
  static constexpr int shear = sides_in<3>;  ///< beyond the sides
  int of = top;                              ///< a side (model/packing.hpp): shortening, positive inward; or `shear`
  double min = 0, max = 0;
  double rate = 0;  ///< 1/s, of the strain
  std::int64_t count = 0;
  std::optional<std::int64_t> store_every;  ///< as of Cycles
  bool operator==(const StrainCycles&) const = default;
  void declare(ParameterVisitor& visitor);
};

/// One stage of loading.
struct Stage {
  std::string name;
  bool gravity = false;
  double gravity_size = standard_gravity;  ///< m/s^2
  double gravity_angle = 0;                ///< rad, by which it is turned from straight down, counter-clockwise
  ByAnySide<double> slide{};               ///< m/s of each wall along itself, along +y or +x
  ByAnySide<bool> rough{};                 ///< walls that hold the grains nearest to them as the stage begins
  ByAnySide<bool> open{};                  ///< walls that are taken away
  SkinParameters skin;                     ///< of the sides that are membranes
  std::vector<BoundaryMotion> boundaries;
  std::vector<BoundaryMotionIn<3>> boundaries_in_space;
  Exchange exchange;                  ///< grains that come in and leave; needs a duration
  std::optional<double> count_below;  ///< m; the history counts the grains whose centre is below
  double shear_rate = 0;              ///< 1/s, of a cell that is periodic along x and y
  ByAnySide<SideDrive> side;          ///< in the order of model/packing.hpp
  std::int64_t increments = 1;
  std::optional<double> duration;  ///< s; for stages driven by velocity, which do not end at rest
  std::string until;  ///< a condition on numbers of its history that ends it (fields/regime/until.hpp); empty: none
  std::optional<Cycles> cycles;
  std::optional<StrainCycles> strain_cycles;
  std::vector<Programme> programmes;  ///< need a duration; of sides, slides and the like that these drive the values
                                      ///< above are those at the beginning
  EquilibriumCriterion equilibrium;
  std::optional<double> friction;  ///< mu during this stage only (e.g. 0 to densify)
  double drag = 0;                 ///< 1/s, during this stage only, on top of the integration's
  double critical_drag = 0;        ///< drag as a multiple of critical_drag(sample); added to `drag`
  MassScaling mass_scaling = MassScaling::none;
  double inertial_number = default_inertial_number;
  bool glue = false;           ///< adhesion acts from this stage on
  bool bond = false;           ///< bonds are made as the stage begins
  std::int64_t snapshots = 1;  ///< states stored for stages with a duration; increments store one each
  bool operator==(const Stage&) const = default;
};

/// Gravity of a size, turned by an angle about z from straight down, m/s^2.
template <int D> Vec<D> gravity_along(double size, double angle);
template <> inline Vec2 gravity_along(double size, double angle) {
  return size * Vec2{std::sin(angle), -std::cos(angle)};
}
template <> inline Vec3 gravity_along(double size, double angle) {
  return size * Vec3{std::sin(angle), -std::cos(angle), 0};
}

/// How boundaries move in a dimension.
template <int D> const std::vector<BoundaryMotionIn<D>>& boundaries_in(const Stage& stage);
template <> inline const std::vector<BoundaryMotion>& boundaries_in<2>(const Stage& stage) { return stage.boundaries; }
template <> inline const std::vector<BoundaryMotionIn<3>>& boundaries_in<3>(const Stage& stage) {
  return stage.boundaries_in_space;
}
/// Whether one is told to move.
bool moves_boundaries(const Stage& stage);
/// Whether a side goes at a speed, its own or that of a programme.
bool moves_side(const Stage& stage, int side);
/// Whether membranes that slide press on both sides of it, between which the sample may go on as a whole.
bool presses_by_two_membranes(const Stage& stage);
/// Whether the sample is strained at a rate: a cell is sheared, a wall slides, a side goes at a speed.
bool strains_at_a_rate(const Stage& stage);

/// How many increments a stage has, or half cycles of strain.
std::int64_t increment_count(const Stage& stage);

/// Pressures on the sides that are membranes, Pa.
BySide<std::optional<double>> membrane_pressures(const Stage& stage);

/// Steps that a duration takes.
std::int64_t steps_of(double duration, double time_step);

/// One half cycle of strain, counted from 0.
struct StrainHalf {
  double from = 0, to = 0;  ///< strains
  std::int64_t steps = 1;   ///< that it takes
};
StrainHalf strain_half(const StrainCycles& cycles, std::int64_t half, double time_step);

/// How the sample was when the stage began.
struct StageStart {
  double time = 0;               ///< s
  ByAnySide<double> force{};     ///< N
  std::array<double, 3> size{};  ///< width, height and in space depth, m
};

/// One leg of a stage's loading: an increment, a half cycle of strain, or, in a stage that lasts a time, the way to the
/// next state that is stored.
struct Leg {
  ByAnySide<SideDrive> side;  ///< what the sides aim at; pressures act in full at once, forces in equal steps from what
                              ///< acts at the start
  std::optional<double> shear_rate;   ///< 1/s, of a half cycle of shear
  std::optional<std::int64_t> until;  ///< steps of the increment at which it is over; unset: when the sample is at rest
  std::string label;
  std::int64_t cycle = 0;  ///< from 1; 0 before the cycles
  bool ends_half = false, at_maximum = false;
  bool stored = true;    ///< the state at its end
  bool is_whole = true;  ///< an increment or half cycle ends with it
  bool is_last = false;
};

/// Increment `k` of a stage, counted from 0; `snapshot` of its states comes next.
Leg leg_at(const Stage& stage, const StageStart& start, std::int64_t k, std::int64_t snapshot, double time_step);

/// What drives the walls of this domain in a leg: velocities along +x or +y, pressures as forces.
template <int D> WallDrivesIn<D> drives_for(const Stage& stage, const Leg& leg, const DomainIn<D>& domain);

}  // namespace arenite::dem
