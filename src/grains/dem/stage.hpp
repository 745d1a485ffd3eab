#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "grains/dem/parameters.hpp"
#include "model/packing.hpp"

namespace arenite::dem {

inline constexpr double standard_gravity = 9.81;  ///< m/s^2

/// When an increment counts as done.
struct EquilibriumCriterion {
  double unbalanced = 1e-4;             ///< unbalanced force ratio
  double kinetic = 1e-6;                ///< kinetic over elastic energy
  double falling = 1e-3;                ///< share of grains that may still fall
  std::optional<double> loose_kinetic;  ///< kinetic energy of grains that carry nothing over elastic energy; unset: 1e5 kinetic
  double mobilisation = -1;             ///< mean |F_t|/F_n below this as well; < 0: not asked
  std::int64_t max_steps = 20'000'000;  ///< of one increment; then the stage ends with exit status 3
  bool operator==(const EquilibriumCriterion&) const = default;
};

/// What one side does in a stage. A force is reached from its present value in `increments` equal steps; a pressure acts in full at once.
struct SideDrive {
  enum class Kind { fixed, velocity, force, pressure };
  Kind kind = Kind::fixed;
  double value = 0;  ///< m/s inward, N, or Pa
  bool operator==(const SideDrive&) const = default;
};

/// Force cycles on one side after the ramp, e.g. 6-60 kN (T 3.2.1); each half cycle is a ramp to rest.
struct Cycles {
  std::string side;         ///< "left", "right", "bottom", "top"
  double min = 0, max = 0;  ///< N
  std::int64_t count = 0;
  std::int64_t increments = 5;  ///< a half cycle
  bool operator==(const Cycles&) const = default;
};

/// How a boundary moves in a stage; one that is not named is there, at rest.
struct BoundaryMotion {
  std::string name;
  Vec2 velocity;               ///< m/s
  double spin = 0;             ///< rad/s, counter-clockwise
  std::optional<Vec2> centre;  ///< of the spin as the stage begins, m; unset: the mean of the points
  bool absent = false;
  bool operator==(const BoundaryMotion&) const = default;
};

/// One stage of loading.
struct Stage {
  std::string name;
  bool gravity = false;
  double gravity_size = standard_gravity;  ///< m/s^2
  double gravity_angle = 0;                ///< rad, by which it is turned from straight down, counter-clockwise
  std::array<double, 4> slide{};           ///< m/s of each wall along itself, along +y or +x
  std::array<bool, 4> rough{};             ///< walls that hold the grains nearest to them as the stage begins
  std::array<bool, 4> open{};              ///< walls that are taken away
  std::vector<BoundaryMotion> boundaries;
  std::optional<double> count_below;  ///< m; the history counts the grains whose centre is below
  double shear_rate = 0;              ///< 1/s, of a cell that is periodic both ways
  std::array<SideDrive, 4> side;      ///< in the order of model/packing.hpp
  std::int64_t increments = 1;
  std::optional<double> duration;  ///< s; for stages driven by velocity, which do not end at rest
  std::optional<Cycles> cycles;
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

/// One step of a stage's loading: what every side aims at when the increment is over.
struct Increment {
  std::array<SideDrive, 4> side;
  std::array<double, 4> slide{};
  std::string label;
};

/// What the sides of a stage aim at with a share (0 to 1) of the way from the start's forces (N) done; pressures act in full from the start.
Increment on_the_ramp(const Stage& stage, const std::array<double, 4>& force_at_start, double share, std::string label = {});

/// The increments of a stage, in order. Forces go from what acts at the start (N; compression positive) to their values in equal steps, pressures act
/// in full at once; cycles follow, each half cycle a ramp of its own.
std::vector<Increment> increments_of(const Stage& stage, const std::array<double, 4>& force_at_start);

/// What drives the walls of this domain in an increment: velocities along +x or +y, pressures as forces.
WallDrives drives_for(const Increment& increment, const Domain& domain);

/// How the boundaries of this domain move in a stage. InputError for a name that none has.
std::vector<BoundaryDrive> boundary_drives_for(const Stage& stage, const Domain& domain);

}  // namespace arenite::dem
