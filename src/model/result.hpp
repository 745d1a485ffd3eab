#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "model/cement.hpp"
#include "model/measuring.hpp"
#include "model/packing.hpp"
#include "model/phase_map.hpp"
#include "model/voxel_map.hpp"
#include "statistics/numbers.hpp"

namespace arenite {

/// Energies of a sample, J. Closed when kinetic + elastic + adhesive = work_walls + work_gravity + exchanged -
/// dissipated_* + what was there at the start.
struct Energies {
  double kinetic = 0;              ///< translation and rotation of grains, motion of servo walls
  double elastic = 0;              ///< springs of contacts and bonds
  double adhesive = 0;             ///< potential of the adhesion, <= 0
  double dissipated_normal = 0;    ///< by normal dashpots
  double dissipated_friction = 0;  ///< by sliding and tangential viscosity
  double dissipated_drag = 0;      ///< by global drag and by the walls' servo damping
  double dissipated_breakage = 0;  ///< lost when a bond breaks for good
  double work_walls = 0;           ///< done on the sample by walls or by a moving periodic cell
  double work_gravity = 0;
  double exchanged = 0;  ///< stored by grains as they came in, less what was stored by those that left
};

/// Where a term stands in the balance: stored and spent ones change by what is supplied.
enum class EnergyRole : std::uint8_t { stored, spent, supplied };

/// One term of the account: its name in files and tables, and in a sentence.
struct EnergyTerm {
  const char *name, *phrase;
  double Energies::*value;
  EnergyRole role;
  bool tracked;  ///< added up on the way, and 0 where a run was not asked to; other terms are always known
};
inline constexpr EnergyTerm energy_terms[] = {
    {"kinetic", "kinetic energy", &Energies::kinetic, EnergyRole::stored, false},
    {"elastic", "elastic energy", &Energies::elastic, EnergyRole::stored, false},
    {"adhesive", "adhesive energy", &Energies::adhesive, EnergyRole::stored, false},
    {"dissipated_normal", "dissipated by dashpots", &Energies::dissipated_normal, EnergyRole::spent, true},
    {"dissipated_friction", "dissipated by friction", &Energies::dissipated_friction, EnergyRole::spent, true},
    {"dissipated_drag", "dissipated by drag and wall damping", &Energies::dissipated_drag, EnergyRole::spent, true},
    {"dissipated_breakage", "dissipated by broken bonds", &Energies::dissipated_breakage, EnergyRole::spent, false},
    {"work_walls", "work of the sides", &Energies::work_walls, EnergyRole::supplied, true},
    {"work_gravity", "work of gravity", &Energies::work_gravity, EnergyRole::supplied, true}};
/// A further term of samples that grains came into or left; others have no such column.
inline constexpr EnergyTerm exchange_term{"exchanged", "brought by grains that came in, less taken by those that left",
                                          &Energies::exchanged, EnergyRole::supplied, false};

/// How far a state is from rest.
struct Equilibrium {
  double unbalanced_ratio = 0;  ///< mean resultant force on a grain (forces, weight) over the mean contact force
  double kinetic_ratio = 0;     ///< kinetic over elastic energy; grains with fewer than two pressed contacts left out
  double mobilisation = 0;      ///< mean |F_t|/F_n of contacts with F_n > 0
  double wall_speed = 0;        ///< fastest wall or point of a boundary, m/s
  double falling =
      0;  ///< share of grains that weigh, have fewer than two pressed contacts, and whose weight nothing holds
  double loose_kinetic =
      0;  ///< kinetic energy of the grains with fewer than two pressed contacts over the elastic energy
};

/// One stored state of a stage.
template <int D> struct SnapshotIn {
  double time = 0;  ///< s since the start of the run
  std::int64_t step = 0;
  std::string label;  ///< "increment 3 of 10", "cycle 2 maximum"
  PackingIn<D> packing;
  Energies energies;
  Equilibrium equilibrium;
};
using Snapshot = SnapshotIn<2>;

/// Scalars sampled often while a stage runs; all columns have one length. Columns have fixed names, e.g. "time",
/// "bottom_position", "bottom_force", "kinetic", "unbalanced_ratio"; units beside them.
struct History {
  struct Column {
    std::string name, unit;
    std::vector<double> values;
  };
  std::vector<Column> columns;
  /// The values of the column of that name; null where there is none.
  const std::vector<double>* find(std::string_view name) const {
    const auto at =
        std::find_if(columns.begin(), columns.end(), [&](const Column& column) { return column.name == name; });
    return at == columns.end() ? nullptr : &at->values;
  }
};

/// What every output carries, so that a number can be traced to what made it.
struct Provenance {
  std::string version;     ///< of Arenite
  std::string stage;       ///< "load", "texture", ...
  std::string input_hash;  ///< of everything that the result depends on; names the file
  std::string recipe;      ///< resolved recipe, TOML
  std::uint64_t seed = 0;
  std::string kernel;  ///< "portable", "avx2", "avx512"
  std::vector<std::pair<std::string, std::string>> options;
  std::string title = {};  ///< of the recipe; empty: it has none
};

/// What the result of every kind of stage begins with.
struct ResultHead {
  Provenance provenance;
  std::string name;       ///< stage's name in the recipe
  bool converged = true;  ///< equilibrium was reached (in every increment)
  std::string outcome;    ///< one sentence
};

/// What a stage was asked for, in numbers: all that those who read its result need of its recipe, whose text in the
/// provenance is for people.
struct Asked {
  bool known = false;                      ///< else the numbers below say nothing
  double friction = statistics::unknown;   ///< mu between grains
  int pull = 0;                            ///< what can make contacts pull (texture::Pull)
  Vec2 gravity{};                          ///< at the end of the stage, m/s^2
  ByAnySide<double> slide{};               ///< of walls along themselves as the stage begins, m/s
  double load_axis = statistics::unknown;  ///< along which it compresses, rad from x
  std::array<double, 3> load_direction{};  ///< of spheres: the same as a unit vector; 0: unknown
  int cycled = -1;                         ///< the side that goes to and fro; -1: none
  int closes = -1;                         ///< of spheres: the axis that their test closes at a speed; -1: none
  std::array<double, 3> box{};             ///< of spheres: m, what their strains refer to; 0: to the first row
  bool in_motion = false;                  ///< it ends while its sample is strained or flows
  bool in_equilibrium = false;             ///< its last state is, by the criterion that it set
  std::optional<Measuring> measure = {};   ///< how its states are measured, along the axis above; unset: by default
  std::vector<double> diameter, passing;   ///< size curve of the grains, m and share of the mass; empty without a law
};

/// The result of one stage: one file in the store.
template <int D> struct StageResultIn : ResultHead {
  Asked asked;
  std::optional<double> began;  ///< s; of a stage that ended before it came to its own end; else its duration tells
  std::vector<SnapshotIn<D>> snapshots;  ///< in time order; the last is the state handed on
  History history;
  History cycles;   ///< of a stage with cycles: a row at the end of each half, as in the history, behind "cycle" and
                    ///< "at_maximum"
  Numbers texture;  ///< texture of the last state, as `show --json` gives it; empty if not measured
  std::vector<std::uint8_t>
      continuation;  ///< the engine's state at the end, for the next stage; empty if there is none
};
using StageResult = StageResultIn<2>;
using SphereResult = StageResultIn<3>;  ///< of a sample in space

/// A bond that broke in a test to failure.
struct Crack {
  float x = 0, y = 0;     ///< middle of the bond, m
  std::uint8_t type = 0;  ///< 1 matrix, 2 interface, 3 particle
  double strain = 0;      ///< of the sample when it broke
};

/// The same of a sample in space: a bond between two voxels.
struct SpaceCrack : Crack {
  float z = 0;                                         ///< m
  std::int32_t along_x = 0, along_y = 0, along_z = 0;  ///< from its first voxel to its second, voxels
};

/// The result of a stage on a grid: a cemented sample, or its stresses under load. One file in the store.
struct FieldResult : ResultHead {
  Packing packing;  ///< what was rasterised, in the map's coordinates; no grains if the map came from an image
  Cement cement;    ///< of that packing
  PhaseMap map;
  StressField field;    ///< empty (size 0) if nothing was loaded; for a test to failure that at the largest stress
  History convergence;  ///< columns "iteration", "residual"
  History curve;        ///< of a test to failure: "strain", "stress", "work", "elastic", "released", "broken"
  std::vector<Crack> cracks;  ///< in the order of breaking
  Numbers numbers;            ///< report and statistics as `show --json` gives them
};

/// A sample in space under load. One file in the store.
struct VoxelResult : ResultHead {
  VoxelMap map;
  VoxelStress field;               ///< for a test to failure that at the largest stress
  History convergence;             ///< columns "iteration", "residual"
  History curve;                   ///< of a test to failure, as a FieldResult's
  std::vector<SpaceCrack> cracks;  ///< in the order of breaking
  Numbers numbers;                 ///< of the sample, the load and its stresses, as `show --json` gives them
};

}  // namespace arenite
