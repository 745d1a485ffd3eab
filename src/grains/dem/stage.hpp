#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "grains/dem/parameters.hpp"
#include "model/packing.hpp"

namespace arenite::dem {

/// A quantity of a stage's loading that a table gives over time: linear between two rows, as the first and last say
/// before and after them; two rows of one time are a jump.
struct Programme {
  static constexpr int drives = 3, slide = sides * drives, shear_rate = slide + sides, gravity_size = shear_rate + 1,
                       gravity_angle = gravity_size + 1, boundary = gravity_angle + 1, count = boundary + 8;
  /// What drives a boundary: where it is from where it was as the programme began, how fast it is, or the force on it.
  enum class OfBoundary { x, y, angle, velocity_x, velocity_y, spin, force_x, force_y };
  int of = 0;  ///< drives * side + (0: velocity inward, 1: force, 2: pressure), slide + side, boundary + OfBoundary, or
               ///< one of the others
  std::vector<Vec2> table;  ///< time since the stage began, s, and value in SI
  bool repeat = false;      ///< from the last row on it begins anew
  std::string name = {};    ///< of the boundary that it drives
  bool operator==(const Programme&) const = default;
  void declare(ParameterVisitor& visitor);

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
inline constexpr std::array<ProgrammeTarget, Programme::count> programme_targets{{{"left.velocity", "mm/s"},
                                                                                  {"left.force", "kN"},
                                                                                  {"left.pressure", "kPa"},
                                                                                  {"right.velocity", "mm/s"},
                                                                                  {"right.force", "kN"},
                                                                                  {"right.pressure", "kPa"},
                                                                                  {"bottom.velocity", "mm/s"},
                                                                                  {"bottom.force", "kN"},
                                                                                  {"bottom.pressure", "kPa"},
                                                                                  {"top.velocity", "mm/s"},
                                                                                  {"top.force", "kN"},
                                                                                  {"top.pressure", "kPa"},
                                                                                  {"slide.left", "mm/s"},
                                                                                  {"slide.right", "mm/s"},
                                                                                  {"slide.bottom", "mm/s"},
                                                                                  {"slide.top", "mm/s"},
                                                                                  {"shear_rate", "1/s"},
                                                                                  {"gravity_size", "m/s^2"},
                                                                                  {"gravity_angle", "deg"},
                                                                                  {"boundary.x", "mm"},
                                                                                  {"boundary.y", "mm"},
                                                                                  {"boundary.angle", "deg"},
                                                                                  {"boundary.velocity_x", "mm/s"},
                                                                                  {"boundary.velocity_y", "mm/s"},
                                                                                  {"boundary.spin", "deg/s"},
                                                                                  {"boundary.force_x", "N"},
                                                                                  {"boundary.force_y", "N"}}};

/// What a sample follows, from a time on.
struct Programmes {
  std::vector<Programme> list;
  double begin = 0;                            ///< s, of the sample's time
  double gravity_size = 0, gravity_angle = 0;  ///< m/s^2 and rad, where no programme says otherwise
};

inline constexpr double standard_gravity = 9.81;  ///< m/s^2

/// When an increment counts as done.
struct EquilibriumCriterion {
  double unbalanced = 1e-4;  ///< unbalanced force ratio
  double kinetic = 1e-6;     ///< kinetic over elastic energy
  double falling = 1e-3;     ///< share of grains that may still fall
  std::optional<double>
      loose_kinetic;  ///< kinetic energy of grains that carry nothing over elastic energy; unset: 1e5 kinetic
  std::optional<double> mobilisation;   ///< mean |F_t|/F_n below this as well; unset: not asked
  std::int64_t max_steps = 20'000'000;  ///< of one increment; then the stage ends with exit status 3
  bool operator==(const EquilibriumCriterion&) const = default;
  void declare(ParameterVisitor& visitor);
};

/// What one side does in a stage. A force is reached from its present value in `increments` equal steps; a pressure
/// acts in full at once.
struct SideDrive {
  enum class Kind { fixed, velocity, force, pressure };
  Kind kind = Kind::fixed;
  double value = 0;  ///< m/s inward, N, or Pa
  bool operator==(const SideDrive&) const = default;
};

/// Force cycles on one side after the ramp, e.g. 6-60 kN (T 3.2.1); each half cycle is a ramp to rest.
struct Cycles {
  int side = bottom;        ///< model/packing.hpp
  double min = 0, max = 0;  ///< N
  std::int64_t count = 0;
  std::int64_t increments = 5;              ///< a half cycle
  std::optional<std::int64_t> store_every;  ///< states are stored in the first cycle and every so many; unset: in all
  bool operator==(const Cycles&) const = default;
  void declare(ParameterVisitor& visitor);
};

/// Cycles of strain at a given rate: one side goes in and out, or a periodic cell is sheared to and fro, between two
/// strains of the sample as the stage begins. The first half cycle goes from there to `max`.
struct StrainCycles {
  static constexpr int shear = 4;
  int of = top;  ///< a side (model/packing.hpp): shortening, positive inward; or `shear`
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
  BySide<double> slide{};                  ///< m/s of each wall along itself, along +y or +x
  BySide<bool> rough{};                    ///< walls that hold the grains nearest to them as the stage begins
  BySide<bool> open{};                     ///< walls that are taken away
  std::vector<BoundaryMotion> boundaries;
  std::optional<double> count_below;  ///< m; the history counts the grains whose centre is below
  double shear_rate = 0;              ///< 1/s, of a cell that is periodic both ways
  BySide<SideDrive> side;             ///< in the order of model/packing.hpp
  std::int64_t increments = 1;
  std::optional<double> duration;  ///< s; for stages driven by velocity, which do not end at rest
  std::optional<Cycles> cycles;
  std::optional<StrainCycles> strain_cycles;
  std::vector<Programme> programmes;  ///< need a duration; of sides, slides and the like that these drive the values
                                      ///< above are those at the beginning
  EquilibriumCriterion equilibrium;
  std::optional<double> friction;  ///< mu during this stage only (e.g. 0 to densify)
  double drag = 0;                 ///< 1/s, during this stage only, on top of the integration's
  double critical_drag = 0;        ///< drag as a multiple of Engine::critical_drag; added to `drag`
  MassScaling mass_scaling = MassScaling::none;
  double inertial_number = default_inertial_number;
  bool glue = false;           ///< adhesion acts from this stage on
  bool bond = false;           ///< bonds are made as the stage begins
  std::int64_t snapshots = 1;  ///< states stored for stages with a duration; increments store one each
  bool operator==(const Stage&) const = default;
};

/// How many increments a stage has, or half cycles of strain.
std::int64_t increment_count(const Stage& stage);

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
  BySide<double> force{};        ///< N
  std::array<double, 2> size{};  ///< width and height, m
};

/// One leg of a stage's loading: an increment, a half cycle of strain, or, in a stage that lasts a time, the way to the
/// next state that is stored.
struct Leg {
  BySide<SideDrive> side;  ///< what the sides aim at; pressures act in full at once, forces in equal steps from what
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
WallDrives drives_for(const Stage& stage, const Leg& leg, const Domain& domain);

}  // namespace arenite::dem
