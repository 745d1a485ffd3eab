#pragma once
#include <tuple>

#include "core/parameters.hpp"
#include "grains/dem/kernels/sweep.hpp"

namespace arenite::dem {

template <int D> struct SampleIn;

/// Kicks the rates of walls and boundaries by their accelerations and drifts with them, like Step.
template <int D> void kick_walls(SampleIn<D>& sample, double kick, double ahead);

/// What a scheme does beside its loop over disks or spheres.
template <int D> struct OwnSteps {
  /// A step of everything that is no disk or body and goes before them: walls, boundaries; `kick` and `ahead` as in
  /// SweepTask.
  void (*move_walls)(SampleIn<D>& sample, double kick, double ahead) = kick_walls<D>;
  /// Finds starting values from a state whose velocities are those of its places; null where none are needed.
  void (*start)(SampleIn<D>&) = nullptr;
};

/// One scheme for Newton's equations. Its loop over disks is Step.
struct Integrator {
  Word word;
  /// The integrated velocities are behind the places by this share of a step, and those that forces see are ahead of
  /// them by that.
  double lag, ahead;
  /// Share of a step by which the places are ahead of the velocities that memories of friction are fed with.
  double lead;
  /// The stable step: p (omega dt)^2 + q lambda dt = 1 with damping lambda, and omega dt = undamped without.
  double p, q, undamped;

  std::tuple<OwnSteps<2>, OwnSteps<3>> own = {};
  /// Between steps a predictor and corrector holds a predicted state, whose rates lack this share of the change of
  /// acceleration times dt/2, and its places this share of that times dt^2/2; 0 and 0 of other schemes.
  double velocity_share = 0, position_share = 0;
  /// Moves grains that are no disks, and boundaries that have a mass, too: by a kick and a drift.
  bool moves_bodies = true;

  bool corrects() const { return velocity_share > 0; }
};

}  // namespace arenite::dem
