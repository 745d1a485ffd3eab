#pragma once
#include <optional>
#include <string>

#include "model/kinds.hpp"
#include "model/phase_map.hpp"
#include "recipe/recipe.hpp"
#include "solid/cement/cement.hpp"
#include "solid/grid/rasterise.hpp"
#include "solid/peridynamics/damage.hpp"
#include "solid/peridynamics/load.hpp"
#include "statistics/numbers.hpp"

namespace arenite::workflow {

/// One value for each kind of bonds, elements or cracks, by its name.
template <class T> Numbers by_type(const T& matrix, const T& interface, const T& particle) {
  return {{std::string(crack_types[1]), matrix},
          {std::string(crack_types[2]), interface},
          {std::string(crack_types[3]), particle}};
}

/// What is known of a cemented packing beyond its map.
struct SampleReports {
  cement::CementParameters law;  ///< with the gap at which grains are neighbours
  cement::CementReport cement;
  grid::GridReport grid;
  Numbers coordination;  ///< of large and small grains, where there are two classes
};

/// Adds what cement, grid and coordination say.
void add_reports(Numbers& numbers, const SampleReports& reports);

/// Add numbers of a load to those of its sample.
void add_load(Numbers& numbers, const recipe::Load& load, const peridynamics::LoadReport& report,
              const std::optional<peridynamics::EffectiveModuli>& moduli);
/// Of a test to failure on a grid of this spacing, in the plane or in space; `asked` is what it was asked for.
template <int D>
void add_failure(Numbers& numbers, Numbers asked, const recipe::Load& load, const peridynamics::DamageOutcome& result,
                 double dx);
/// What a load of a sample of the plane was asked for.
Numbers as_asked(const recipe::Load& load);

/// Of a sample of bonds, a sentence on the longest void that is thinner than their horizon, if it is longer than a
/// tenth of the sample's side, all in nodes: a crack that bonds reach across. Empty else.
std::string note_of_bridged_crack(int length, int side, int horizon, const std::string& remedy);

/// Tells how many bonds reach across voids, and notes where nothing else ties the clamps of a map, upright as it was
/// loaded.
void note_bonds_across_voids(Numbers& numbers, const recipe::Load& load, const PhaseMap& upright);

}  // namespace arenite::workflow
