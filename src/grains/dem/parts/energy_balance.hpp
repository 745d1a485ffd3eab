#pragma once
#include <array>
#include <vector>

#include "grains/dem/parts/part.hpp"

namespace arenite::dem {

/// Work done on the sample in a step (J), or the power (W), by class of force.
struct WorkTerms {
  double dashpots = 0, friction = 0, drag = 0, gravity = 0, walls = 0, servo = 0;
};
constexpr double WorkTerms::*work_terms[] = {&WorkTerms::dashpots, &WorkTerms::friction, &WorkTerms::drag,
                                             &WorkTerms::gravity,  &WorkTerms::walls,    &WorkTerms::servo};

/// Forces by class and velocities at one time: what the work of a step is made of. Disks by the index of Sample::start,
/// then bodies (mover_of). Under Verlet the velocities are those of the middle of the step that ends there.
struct ForcesAndRates {
  struct Disk {
    Motion<2> own;
    double mass = 0;
    Load<2> dash;  ///< normal dashpots, dashpots of bonds
    Load<2> slip;  ///< tangential forces
    Vec2 drag;
  };
  /// Along its way, +x or +y: force of the sample on the wall, all of it and by class; force of the drive; servo
  /// damping.
  struct Edge {
    double rate = 0, force = 0, dash = 0, slip = 0, drive = 0, damping = 0;
    bool servo = false;
    void push(double by_dash, double by_slip) {
      dash += by_dash;
      slip += by_slip;
    }
  };
  std::vector<Disk> disk;
  std::vector<Edge> boundary;  ///< three each: along +x and +y, and about the centre with torques for forces
  std::vector<Edge> node;      ///< two each of the nodes of membranes: along +x and +y
  std::array<Edge, 9> edge;    ///< walls along their normals, walls along themselves, and the shear of the cell
  Vec2 gravity;                ///< m/s^2
  double springs = 0;          ///< energy of the tangential springs, J
  double normal_springs = 0;   ///< of normal springs that remember, J
};

/// Account of dissipation and work, closed by the scheme's own identity where there is one. Under Verlet a step changes
/// sum m v^2/2 - (dt^2/8) m a^2 by exactly (F_n + F_n+1)/2 times the way made, so each class of force is given that
/// share of the work; of a linear spring that is the change of its energy, so what stays open is the second term (0 at
/// rest) and the steps in which a contact opens or closes. Under Gear the powers are integrated by the Adams-Moulton
/// rule of fourth order. What friction takes from the motion and its springs do not store is dissipated.
struct EnergyBalance : PartOf<2> {
  bool open = false;  ///< `last` belongs to the present state
  ForcesAndRates last;
  std::array<WorkTerms, 3> powers{};  ///< Gear: now, one and two steps ago
  int known = 0;                      ///< how many of them are

  void break_step(Sample& /*sample*/) { open = false; }
  /// Takes the present state as the start of the next step, where drives, gravity or drag have changed.
  void begin(Sample& sample);
  /// Books the step that has just been made.
  void after_forces(Sample& sample);
  template <class Members> void transfer(Sample& /*sample*/, Members& members) {
    members(open, known);
    for (WorkTerms& power : powers)
      for (const auto term : work_terms) members(power.*term);
  }
  /// A snapshot of the same state has the same bits; Gear's powers are older.
  void go_on(Sample& sample);
};

}  // namespace arenite::dem
