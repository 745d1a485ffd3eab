#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/parameters.hpp"
#include "core/thread_count.hpp"
#include "core/vec.hpp"
#include "grains/dem/laws/laws.hpp"
#include "model/elasticity/disk_field.hpp"
#include "model/packing.hpp"

namespace arenite::dem {

using elasticity::EffectiveRadius;

enum class StiffnessRule {
  thesis,
  series
};  ///< thesis: like pairs k, unlike k_i k_j/(k_i + k_j); series: always 1/(1/2k_i + 1/2k_j)
enum class WallStiffness { stiffest, grain, series };
enum class Arms { contact_point, full_radius };
enum class FrictionCap { raised_by_adhesion, as_printed };  ///< mu (F_n + |F_c|), or T (1.28) with F_c printed negative
enum class MassScaling { none, uniform };                   ///< see dem/masses.hpp

/// All integrators, the default first: each is the Integrator of this name in a file of its own, which
/// integrators/integrators.hpp includes.
#define ARENITE_INTEGRATORS(each) each(velocity_verlet) each(leapfrog) each(gear5)
#define ARENITE_ENUMERATOR(name) name,
enum class IntegratorKind { ARENITE_INTEGRATORS(ARENITE_ENUMERATOR) };
#undef ARENITE_ENUMERATOR
#define ARENITE_ONE(name) +1
inline constexpr std::size_t integrator_count = 0 ARENITE_INTEGRATORS(ARENITE_ONE);
#undef ARENITE_ONE

/// How fast a sample yields to a force on its sides, as a share of sqrt(F H/M): F the force, H the way to the other
/// side, M the mass.
inline constexpr double default_inertial_number = 0.01;

/// Everything that decides the force between two grains or a grain and a wall. SI units.
struct ContactParameters {
  NormalLaw normal;  ///< of each family the first law, unless another is chosen
  StiffnessRule stiffness_rule = StiffnessRule::thesis;
  WallStiffness wall_stiffness = WallStiffness::stiffest;
  double restitution = 0.5;              ///< of a binary collision at zero friction; sets alpha_n by pair unless given
  std::optional<double> normal_damping;  ///< alpha_n, N s/m, the same for every pair
  bool attractive_dashpot = false;       ///< false: F_n of non-cohesive contacts is clipped at 0
  FrictionLaw friction_law = CundallStrack{};
  double friction = 0.3;                    ///< mu between grains
  std::optional<double> wall_friction;      ///< mu at walls; that of the grains unless given
  std::optional<double> sliding_viscosity;  ///< gamma_s, N s/m; unless given, the alpha_n of the pair
  double tangential_stiffness_ratio = 0.8;  ///< k_t/k_n of a friction law's spring
  RollingLaw rolling;
  BondLaw bonds;
  Cohesion cohesion;
  Arms arms = Arms::contact_point;
  Adhesion adhesion;
  double surface_energy = 0;  ///< gamma of the adhesion, N/m (T 1.22), between two glued grains
  EffectiveRadius effective_radius = EffectiveRadius::four_reduced;
  FrictionCap friction_cap = FrictionCap::raised_by_adhesion;
  /// Pairs (indices) glued one by one; if empty, every two grains whose zone is > 0 are.
  std::vector<std::pair<std::int32_t, std::int32_t>> glued_pairs;
  bool operator==(const ContactParameters&) const = default;
  void declare(ParameterVisitor& visitor);

  bool adheres() const { return !adhesion.is_none(); }
  bool is_cohesive() const { return !cohesion.is_none(); }
  bool has_bonds() const { return !bonds.is_none(); }
  bool rolls_freely() const { return rolling.is_none(); }
  /// The normal law is one of materials' E and nu.
  bool takes_moduli() const {
    return normal.visit([]<class N>(const N&) { return ElasticContact<N>; });
  }
};

struct IntegrationParameters {
  IntegratorKind integrator = IntegratorKind::velocity_verlet;
  std::optional<double> time_step;  ///< s; beyond the stable step it is refused with the number that would do
  double safety =
      0.1;  ///< share of the sample's shortest contact time T_c = pi sqrt(m_eff/k) taken as step if none is given
  bool rotations = true;        ///< false: grains do not turn
  double drag = 0;              ///< global viscous drag, 1/s: force -drag m v (0: none)
  bool track_energy = false;    ///< account for dissipation and work every step (slower)
  std::string kernel = "auto";  ///< "auto", "portable", "avx2", "avx512"
  int threads = Threads{}.threads;
  bool operator==(const IntegrationParameters&) const = default;
  void declare(ParameterVisitor& visitor);
};

enum class DriveKind { fixed, velocity, force };
/// What drives one wall (or, for periodic sides, one edge of the cell) during an increment.
template <int D> struct WallDriveIn {
  using Kind = DriveKind;
  Kind kind = Kind::fixed;
  double value = 0;     ///< m/s along the wall's axis, or N pressing into the sample (compression positive)
  Along<D> slide = {};  ///< m/s of a wall along itself
  bool operator==(const WallDriveIn&) const = default;
};
template <int D> using WallDrivesIn = std::array<WallDriveIn<D>, sides_in<D>>;
using WallDrive = WallDriveIn<2>;
using WallDrives = WallDrivesIn<2>;

/// How a boundary moves in a stage; one that is not named is there, at rest.
template <int D> struct BoundaryMotionIn {
  std::string name;
  Vec<D> velocity = {};  ///< m/s
  Turning<D> spin = {};  ///< rad/s, counter-clockwise
  std::optional<Vec<D>> centre =
      {};  ///< of the spin as the motion begins, m, which goes with the velocity; unset: the mean of the points
  bool absent = false;
  std::optional<double> mass = {};  ///< kg; with it the boundary moves under its weight, the grains and the force, from
                                    ///< the velocity on that it has
  Vec<D> force = {};                ///< N
  bool operator==(const BoundaryMotionIn&) const = default;
  void declare(ParameterVisitor& visitor);
  bool moves() const { return velocity != Vec<D>{} || spin != Turning<D>{}; }
};
using BoundaryMotion = BoundaryMotionIn<2>;

}  // namespace arenite::dem
