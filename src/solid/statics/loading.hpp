#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/pages.hpp"
#include "core/vec.hpp"
#include "model/phase_map.hpp"
#include "model/voxel_map.hpp"
#include "solid/statics/grid.hpp"
#include "solid/statics/watch.hpp"

/// A sample between two clamps, its lowest and its highest level of nodes (a row in the plane, a layer in space): how
/// it is loaded, what of it hangs together, and what came out, whatever the discretisation.
namespace arenite::statics {

/// How the top level of nodes is moved against the bottom one: up, down, or to the right.
enum class Loading { tension, compression, shear };

/// What holds the bottom level: all components fixed, or free to slide along itself (the top is always held).
enum class LowerEdge { fixed, sliding };

/// Unit vector along which the top level moves.
template <int D> Vec<D> direction_of(Loading loading);

/// What is prescribed in each level of nodes. Throws InputError for shear above a sliding edge.
template <int D> std::vector<std::uint8_t> prescribed_levels(int levels, Loading loading, LowerEdge lower);

/// Throws InputError for a strain or a tolerance that make no sense.
void check_load(double strain, double tolerance);

/// Iterations after which a static solve is given up: 50 for the six decades of the usual tolerance, in space four
/// times as many, more for more.
int usual_cap(double tolerance, int dimension = 2);

/// Which clamp a node moves with where it carries nothing.
enum class Tie : std::uint8_t { none = 0, below = 1, above = 2, both = 3 };

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

template <int D> struct LoadReportIn : StaticReport {
  Ending ending = Ending::empty;
  std::string sentence;  ///< the same in words, with what was found loose
  Support support;
  std::vector<Hinge> hinges;       ///< that were found, if they were looked for
  Vec<D> top_force, bottom_force;  ///< of the clamps on the sample, N; in the plane per unit thickness, N/m
  /// sum sigma V over F_top (y_top - y_bottom), along the load, less one: zero at equilibrium.
  double identity_defect = 0;
  double modulus = 0;  ///< apparent: mean stress of the top over the strain, Pa; Young's or shear
  double poisson = 0;  ///< lateral over axial mean gradient of the displacement, middle half; 0 for shear
};
using LoadReport = LoadReportIn<2>;

template <int D> struct LoadResultIn {
  LoadReportIn<D> report;
  StressIn<D> field;
};
using LoadResult = LoadResultIn<2>;

/// A sample that has been loaded, by its nodes.
struct LoadedSample {
  const Grid& grid;
  const Buffer<Tie>& tie;
  Loading loading;
  double strain, dx, gauge;  ///< lengths in m: spacing of nodes, distance of the clamps
  double section;            ///< of the sample between them: m^2, in the plane m
};

/// Fills in forces of the clamps, the reaction balance, modulus and Poisson's ratio; `force` is that of the sample on
/// every node of unit spacing. The field's stresses stand for dx^2, or dx^3, each.
template <int D>
void judge(const LoadedSample& sample, const FieldIn<D, double>& u, const FieldIn<D, double>& force,
           LoadResultIn<D>& result);

/// Where the sample carries uniform strain; the clamp's displacement where it hangs on one only, none where it floats.
template <int D> FieldIn<D, double> uniform_strain(const Grid& grid, const Buffer<Tie>& tie, Vec<D> top);

/// Of a solve that was made.
Ending ending_of(const StaticReport& report);

/// How it ended, in words.
std::string sentence_of(const LoadReport& report, double tolerance);
/// The same of any solve; `parts` names what the support counts.
std::string sentence_of(Ending ending, const StaticReport& report, const Support& support, double tolerance,
                        const char* parts);

/// Apparent moduli of a sample between rigid clamps, Pa. They hold for the sample with its clamps: a fixed edge hinders
/// contraction (LowerEdge::sliding frees one edge of it), and free sides are softer than the bulk.
struct EffectiveModuli {
  double young_x = 0, young_y = 0;        ///< pulled along x, along y
  double poisson_xy = 0, poisson_yx = 0;  ///< contraction along y when pulled along x, and the other way round
  double shear = 0;                       ///< rows moved along x; above a fixed edge
  std::array<LoadReport, 3> reports;      ///< of the pulls along x and y and of the shearing; NaN where not converged
};

/// Three loads: tension of the map and of the map turned, and shear; `load` is asked for each. The watch sees one run
/// from 0 to 1, and what it stops leaves zeros.
EffectiveModuli effective_moduli(const PhaseMap& map, const Watch& watch,
                                 const std::function<LoadReport(const PhaseMap&, Loading, const Watch&)>& load);

/// The same of a way to load with its options, of which loading, edge and watch are set for each.
template <class Options>
EffectiveModuli effective_moduli(const PhaseMap& map, const Options& options,
                                 LoadResult (*load)(const PhaseMap&, const Options&)) {
  return effective_moduli(map, options.watch, [&](const PhaseMap& sample, Loading loading, const Watch& watch) {
    Options o = options;
    o.loading = loading;
    if (loading == Loading::shear) o.lower = LowerEdge::fixed;
    o.watch = watch;
    return load(sample, o).report;
  });
}

}  // namespace arenite::statics
