#pragma once
#include "grains/dem/parts/part.hpp"
#include "grains/dem/stage.hpp"

namespace arenite::dem {

/// What drives the sides over time, and the force-controlled ones among them, which follow or come to rest (walls.hpp).
struct Loading : PartOf<2> {
  Programmes programmes;  ///< of the stage under way; not stored, since every stage sets them

  void set_up(Sample& sample);
  void prepare(Sample& sample);
  /// Velocities of sides and boundaries and the rate of shear are those of the step's middle, so that the ways made are
  /// the areas below the tables; boundaries whose place is given go there.
  void before_step(Sample& sample);
  /// Forces, pressures and gravity are those of the step's end.
  void after_step(Sample& sample);
  bool drives(const Sample& /*sample*/) const { return !programmes.list.empty(); }
};

/// Tables that sides, shear and gravity follow from now on, step by step; what they drive the other functions leave to
/// them. `begin` and the gravity that they turn or scale are of the caller. They are no part of a stored state: set
/// them before it is restored.
void set_programmes(Sample& sample, Programmes programmes);

/// What drives the walls where programmes do, and elsewhere as given: a force as it is now; a velocity stays, since it
/// is set step by step.
WallDrives under_programmes(const Sample& sample, WallDrives drives);

}  // namespace arenite::dem
