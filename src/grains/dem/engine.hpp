#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "grains/dem/parameters.hpp"
#include "grains/dem/stage.hpp"
#include "model/packing.hpp"
#include "model/result.hpp"

namespace arenite::dem {

/// Largest steps that the sample in hand allows, s.
struct StepBounds {
  double stiffness = 0;  ///< from the largest eigenfrequency bound of a grain's contacts
  double damping = 0;    ///< from the largest damping rate (dashpots, sliding viscosity with rotation)
  double largest() const { return stiffness < damping ? stiffness : damping; }
};

/// How many grains, and what they weigh by density, radius and thickness, kg.
struct Amount {
  std::size_t grains = 0;
  double mass = 0;
};

/// The bonds that there are, and that there were.
struct BondCount {
  std::size_t intact = 0, in_tension = 0, in_bending = 0, in_shear = 0;  ///< whole ones; those broken so
  double energy = 0;                                                     ///< of the whole ones, J
  std::size_t made() const { return intact + in_tension + in_bending + in_shear; }
};

/// The pairs that cohesion joins: all, and those whose grains do not touch.
struct CohesionCount {
  std::size_t joined = 0, apart = 0;
};

/// A sample that moves. Inside, disks are sorted by place and their contacts listed; at the border grains keep the
/// caller's order. Same input, same kernel: same bits for any thread count.
class Engine {
 public:
  /// Throws InputError for a step beyond the bounds, naming the step that would do.
  Engine(const Packing& start, const ContactParameters& contact, const IntegrationParameters& integration);
  ~Engine();
  Engine(Engine&&) noexcept;
  Engine& operator=(Engine&&) noexcept;

  void set_gravity(Vec2 g);                   ///< m/s^2
  void set_drives(const WallDrives& drives);  ///< from the next step on
  /// Tables that sides, shear and gravity follow from now on, step by step; what they drive the other functions leave
  /// to them. `begin` and the gravity that they turn or scale are of the caller. They are no part of `save`: set them
  /// before `restore`.
  void set_programmes(Programmes programmes);
  void set_drag(double rate);  ///< 1/s
  /// The grains' own masses, or even ones for a compaction (bounds.hpp); never with gravity. A step that they do not
  /// allow is shortened, or refused (InputError) where it was given.
  void set_mass_scaling(MassScaling mass_scaling);
  void set_inertial_number(double number);  ///< how fast the sample yields to its force-controlled sides (walls.hpp)
  void set_friction(std::optional<double> mu);  ///< for grains and walls; nullopt: what the parameters say
  /// Shears a cell that is periodic both ways, du_x/dy, 1/s (Lees and Edwards 1972); grains are given the velocities of
  /// the change at once.
  void set_shear_rate(double rate);
  /// Walls, by side, that hold the grains nearer than half their radius; those of walls that are not named are let go.
  void set_rough(const BySide<bool>& rough);
  /// Walls, by side, that are taken away; one comes back only where no grain lies beyond it (InputError).
  void set_open(const BySide<bool>& open);
  /// How the domain's boundaries move from now on; InputError for a name that none has.
  void set_boundaries(const std::vector<BoundaryMotion>& motions);
  void set_glue(bool on);  ///< adhesion acts; for bonds that break for good: pairs that touch now are bonded
  /// Bonds grains that touch now or nearly (contact.bonds), free of stress, unless they are or were bonded already. A
  /// step that the bonds do not allow is shortened, or refused (InputError) where it was given.
  void make_bonds();

  void advance(std::int64_t steps);

  double time() const;
  std::int64_t step() const;
  double time_step() const;
  StepBounds bounds() const;
  std::string kernel() const;  ///< name of the kernel in use

  std::size_t grain_count() const;
  std::int64_t list_builds() const;  ///< how often the contact list has been built
  double critical_drag() const;      ///< that damps the slowest wave of a crystal of this size critically, 1/s
  double skin() const;               ///< surface gap within which pairs are listed, m

  const IntegrationParameters& integration() const;  ///< as given
  double shear_strain() const;                       ///< by set_shear_rate so far
  const Domain& domain() const;                      ///< wall positions, velocities and forces now
  Packing packing() const;            ///< grains and contacts now, in the caller's order; contacts sorted by (i, j)
  Amount below(double height) const;  ///< grains whose centre is below this, m
  BondCount bond_count() const;
  bool is_cohesive() const;  ///< contact.cohesion acts
  CohesionCount cohesion_count() const;
  Energies energies() const;  ///< dissipation and work only if track_energy
  Equilibrium equilibrium() const;
  std::uint64_t state_hash() const;  ///< of every bit that decides the future

  /// The whole state as bytes, and back: an engine built from the same start and parameters and then restored goes on
  /// with the same bits as if it had never stopped.
  std::vector<std::uint8_t> save() const;
  void restore(const std::vector<std::uint8_t>& bytes);

 private:
  struct Machine;
  std::unique_ptr<Machine> machine_;
};

}  // namespace arenite::dem
