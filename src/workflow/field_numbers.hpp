#pragma once
#include <optional>
#include <string>

#include "solid/cement/cement.hpp"
#include "model/phase_map.hpp"
#include "solid/peridynamics/damage.hpp"
#include "solid/peridynamics/moduli.hpp"
#include "solid/raster/cavities.hpp"
#include "solid/raster/raster.hpp"
#include "statistics/numbers.hpp"
#include "solid/stress/grains.hpp"
#include "recipe/recipe.hpp"
#include "grains/texture/gap_coordination.hpp"

/// Numbers of results on a raster, each statistic as value and error.
namespace arenite::study {

/// What is known of a cemented packing beyond its map.
struct SampleReports {
  CementSection section;
  cement::CementReport cement;
  raster::RasterReport raster;
  double gap = 0;                                            ///< at which grains are neighbours, m
  std::optional<texture::GapCoordination> coordination;      ///< where there are two classes
};

/// Size, phases, S_m, grains, pores and voids of any map. Volumes of pores and voids are over pi reference_radius^2.
Numbers map_numbers(const PhaseMap& map, const raster::CavityRules& rules, double reference_radius);

/// The same with what cement, raster and coordination say.
Numbers with_reports(Numbers numbers, const SampleReports& reports);

/// Numbers of a load added to those of its sample.
Numbers with_load(Numbers numbers, const Load& load, const peridynamics::LoadReport& report,
                  const std::optional<peridynamics::EffectiveModuli>& moduli);
Numbers with_failure(Numbers numbers, const Load& load, const peridynamics::DamageResult& result);

/// Those of stress::numbers added as "stress"; `note` instead where there is none.
Numbers with_stress(Numbers numbers, Numbers stress);
/// How mean stresses of grains agree with those from the contact forces that pressed the packing.
Numbers with_agreement(Numbers numbers, const stress::GrainComparison& comparison);
Numbers with_note(Numbers numbers, const std::string& note);

}  // namespace arenite::study
