#pragma once
#include "grains/dem/parts/part.hpp"
#include "grains/dem/stage.hpp"

namespace arenite::dem {

/// What drives the sides over time, and the force-controlled ones among them, which follow or come to rest (walls.hpp).
template <int D> struct LoadingIn : PartOf<D> {
  Programmes programmes;  ///< of the stage under way; not stored, since every stage sets them

  void set_up(SampleIn<D>& sample);
  void prepare(SampleIn<D>& sample);
  /// Velocities of sides and boundaries and the rate of shear are those of the step's middle, so that the ways made are
  /// the areas below the tables; boundaries whose place is given go there.
  void before_step(SampleIn<D>& sample);
  /// Forces, pressures and gravity are those of the step's end.
  void after_step(SampleIn<D>& sample);
  bool drives(const SampleIn<D>& /*sample*/) const { return !programmes.list.empty(); }
};

/// Tables that sides, shear and gravity follow from now on, step by step; what they drive the other functions leave to
/// them. `begin` and the gravity that they turn or scale are of the caller. They are no part of a stored state: set
/// them before it is restored.
template <int D> void set_programmes(SampleIn<D>& sample, Programmes programmes);

/// What drives the walls where programmes do, and elsewhere as given: a force as it is now; a velocity stays, since it
/// is set step by step.
template <int D> WallDrivesIn<D> under_programmes(const SampleIn<D>& sample, WallDrivesIn<D> drives);

}  // namespace arenite::dem
