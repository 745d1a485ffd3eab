#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "model/phase_map.hpp"
#include "solid/peridynamics/options.hpp"

namespace arenite::peridynamics {

enum class Ending {
  solved,
  not_converged,  ///< the tolerance was not reached; the field is the last one
  stopped,        ///< the watch asked for it; the field is the last one
  severed,        ///< nothing ties the two clamps: no stress anywhere
  empty           ///< all void
};

/// What of a sample hangs together between its two clamps; counts are nodes that are not void.
struct Support {
  std::size_t solid = 0;
  std::size_t carrying = 0;    ///< tied to both clamps
  std::size_t held_below = 0;  ///< tied to the lower clamp only: moves with it, without stress
  std::size_t held_above = 0;  ///< tied to the upper clamp only
  std::size_t floating = 0;    ///< tied to neither: left where it is, without stress
  int islands = 0;             ///< separate parts among the floating
};

/// A node about which a part of the sample can turn, because nothing else ties that part to the rest.
struct Hinge {
  std::int32_t x, y;  ///< node
  std::size_t nodes;  ///< of the part behind it, seen from the bottom row
  bool carries;       ///< the part holds the upper clamp: the load itself passes the hinge
};

/// How a solve ended.
struct StaticReport {
  bool converged = false;
  bool stopped = false;  ///< the watch asked for it
  int iterations = 0;
  double residual = 0;          ///< relative, of the field that is handed back, worked out anew
  std::vector<double> history;  ///< relative residual after each iteration, the start first
  int repairs = 0;              ///< CoarseSpace::repairs
  std::size_t loose_nodes = 0;  ///< that no bond holds in some direction
};

struct LoadReport : StaticReport {
  Ending ending = Ending::empty;
  std::string sentence;  ///< the same in words, with what was found loose
  Support support;
  std::vector<Hinge> hinges;     ///< that were found, if they were looked for
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

/// Apparent moduli of a sample between rigid clamps, Pa. They hold for the sample with its clamps: a fixed edge hinders
/// contraction (LowerEdge::sliding frees one edge of it), and free sides are softer than the bulk.
struct EffectiveModuli {
  double young_x = 0, young_y = 0;        ///< pulled along x, along y
  double poisson_xy = 0, poisson_yx = 0;  ///< contraction along y when pulled along x, and the other way round
  double shear = 0;                       ///< rows moved along x; above a fixed edge
  std::array<LoadReport, 3> reports;      ///< of the pulls along x and y and of the shearing
};

/// Three loads: tension, tension of the transposed map, shear. `options.loading` is not used; the watch sees one run
/// from 0 to 1, and what it stops leaves zeros.
EffectiveModuli effective_moduli(const PhaseMap& map, const LoadOptions& options);

}  // namespace arenite::peridynamics
