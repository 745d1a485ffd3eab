#pragma once
#include <array>
#include <vector>

#include "grains/dem/kernels/kernel.hpp"
#include "model/packing.hpp"

namespace arenite::dem {

template <int D> struct SampleIn;

/// Forces by class and velocities at one time: what the work of a step is made of. Disks by the index of Sample::start,
/// then bodies (mover_of). Under Verlet the velocities are those of the middle of the step that ends there.
template <int D> struct ForcesAndRates {
  struct Disk {
    Motion<D> own;
    double mass = 0;  ///< kg, that gravity works on
    Load<D> dash;     ///< normal dashpots, dashpots of bonds
    Load<D> slip;     ///< tangential forces
    Vec<D> drag;
  };
  /// Along its way, an axis: force of the sample on the wall, all of it and by class; force of the drive; servo
  /// damping.
  struct Edge {
    double rate = 0, force = 0, dash = 0, slip = 0, drive = 0, damping = 0;
    bool servo = false;
    void push(double by_dash, double by_slip) {
      dash += by_dash;
      slip += by_slip;
    }
  };
  /// Where walls along themselves, each in D - 1 directions, and the shear of the cell stand among edges.
  static constexpr std::size_t slides = sides_in<D>, cell_shear = slides + sides_in<D> * (D - 1);
  std::vector<Disk> disk;
  std::vector<Edge> boundary;             ///< of each along the axes, and about the centre with torques for forces
  std::vector<Edge> node;                 ///< two each of the nodes of membranes: along +x and +y
  std::array<Edge, cell_shear + 1> edge;  ///< walls along their normals, walls along themselves, the shear of the cell
  Vec<D> gravity;                         ///< m/s^2
  double springs = 0;                     ///< energy of the tangential springs, J
  double normal_springs = 0;              ///< of normal springs that remember, J
};

/// Those of now.
template <int D> ForcesAndRates<D> forces_and_rates(const SampleIn<D>& sample);

}  // namespace arenite::dem
