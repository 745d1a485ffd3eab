#pragma once
#include <string>

#include "model/phase_map.hpp"
#include "model/stress_field.hpp"
#include "solid/peridynamics/bonds.hpp"
#include "solid/peridynamics/hinges.hpp"
#include "solid/peridynamics/loading.hpp"
#include "solid/peridynamics/support.hpp"
#include "solid/peridynamics/watch.hpp"

namespace arenite::peridynamics {

/// Ways to the field at equilibrium.
enum class Method {
  static_solve,  ///< conjugate gradients with the two-level preconditioner
  relaxation,    ///< adaptive dynamic relaxation
  damped         ///< P II.C: explicit dynamics under a fixed viscosity below the critical one
};

struct LoadOptions {
  Stiffness stiffness{};
  Loading loading = Loading::tension;
  LowerEdge lower = LowerEdge::fixed;
  Method method = Method::static_solve;
  double strain = 1e-4;     ///< displacement of the top row over the distance of the two rows
  double tolerance = 1e-6;  ///< of the residual, relative to that of uniform strain
  int max_iterations = 0;   ///< 0: a million steps; for the static solve 50, more for tolerances below 1e-6
  /// P's stretch (|xi + eta| - |xi|)/|xi| along the turned bond; otherwise the linearised one.
  bool exact_stretch = false;
  /// Look for hinges in any case; otherwise only where the solve hints at one (a loose node, or many iterations).
  bool look_for_hinges = false;
  Watch watch{};
};

enum class Ending {
  solved,
  not_converged,  ///< the tolerance was not reached; the field is the last one
  stopped,        ///< the watch asked for it; the field is the last one
  severed,        ///< nothing ties the two clamps: no stress anywhere
  empty           ///< all void
};

struct LoadReport {
  Ending ending = Ending::empty;
  std::string sentence;  ///< the same in words, with what was found loose
  Support support;
  int iterations = 0;
  double residual = 0;
  std::vector<double> history;  ///< of relative residuals
  std::size_t loose_nodes = 0;  ///< that no bond holds in some direction
  std::vector<Hinge> hinges;    ///< that were found, if they were looked for
  std::int32_t coarse_unknowns = 0;
  int repairs = 0;
  Vec2 top_force, bottom_force;  ///< of the clamps on the sample per unit thickness, N/m
  /// sum sigma_yy V over F_top (y_top - y_bottom), less one: zero at equilibrium.
  double identity_defect = 0;
  double modulus = 0;  ///< apparent: mean stress of the top row over the strain, Pa; Young's or shear
  double poisson = 0;  ///< lateral over axial mean gradient of the displacement, middle half; 0 for shear
};

struct LoadResult {
  LoadReport report;
  StressField field;
};

/// Loads a sample by the displacement of its top row and finds its field at equilibrium. Throws InputError for a map or
/// options that make no sense; anything that a sound map can turn out to be is an Ending.
LoadResult load(const PhaseMap& map, const LoadOptions& options);

}  // namespace arenite::peridynamics
