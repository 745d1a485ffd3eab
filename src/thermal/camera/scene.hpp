#pragma once
#include <vector>

#include "core/vec.hpp"
#include "model/packing.hpp"
#include "model/result.hpp"
#include "thermal/camera/camera.hpp"

namespace arenite::camera {

/// The peak-to-peak change of sigma_kk inside one grain, on a square grid round its centre, x fast, from the lower
/// left.
struct Patch {
  int cells = 0;             ///< a side
  double cell = 0;           ///< m
  std::vector<float> value;  ///< Pa, mean over each cell
  /// Between cells, linear; `offset` from the grain's centre, m.
  float at(Vec2 offset) const;
};

/// What is filmed: grains in their places at the smallest and at the largest load, and how their stress changes
/// between.
struct Scene {
  Grains grains;              ///< at the smallest load
  std::vector<Vec2> travel;   ///< to their places at the largest load, m
  std::vector<Patch> stress;  ///< change from the smallest to the largest load
  Domain low, high;
  Materials materials;
};

/// The scene between two states of the same grains (T eq. 1.55 with the field of disks under their contact forces).
/// Throws InputError if the grains differ.
Scene scene_between(const Packing& low, const Packing& high, const Parameters& parameters);

/// The scene from no load to a state; nothing moves.
Scene scene_of_state(const Packing& state, const Parameters& parameters);

/// What the lower wall does between two states, as a testing machine tells it: from the smallest load (null: none) to
/// the largest.
struct WallChange {
  double force = 0;   ///< N
  double travel = 0;  ///< m, upwards
};
WallChange change_of_lower_wall(const Packing* low, const Packing& high);

/// The scene from no load to the stresses that peridynamics found in the grains of a cemented sample (their matrix
/// warms by nothing of its own). Grains move by the mean displacement of their nodes. Throws InputError for a sample
/// without load, or one whose grains are no disks.
Scene scene_of_field(const FieldResult& result, const Parameters& parameters);

}  // namespace arenite::camera
