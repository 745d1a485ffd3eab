#pragma once
#include <optional>
#include <string>

#include "cement/cement.hpp"
#include "model/phase_map.hpp"
#include "peridynamics/damage.hpp"
#include "peridynamics/moduli.hpp"
#include "raster/cavities.hpp"
#include "raster/raster.hpp"
#include "stress/grains.hpp"
#include "study/recipe.hpp"
#include "texture/gap_coordination.hpp"

/// Numbers of results on a raster as JSON, each statistic as value and error.
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
std::string map_numbers(const PhaseMap& map, const raster::CavityRules& rules, double reference_radius);

/// The same with what cement, raster and coordination say.
std::string with_reports(const std::string& numbers, const SampleReports& reports);

/// Numbers of a load added to those of its sample.
std::string with_load(const std::string& numbers, const Load& load, const peridynamics::LoadReport& report,
                      const std::optional<peridynamics::EffectiveModuli>& moduli);
std::string with_failure(const std::string& numbers, const Load& load, const peridynamics::DamageResult& result);

/// JSON of stress::to_json added as "stress"; `note` instead where there is none.
std::string with_stress(const std::string& numbers, const std::string& stress_json);
/// How mean stresses of grains agree with those from the contact forces that pressed the packing.
std::string with_agreement(const std::string& numbers, const stress::GrainComparison& comparison);
std::string with_note(const std::string& numbers, const std::string& note);

}  // namespace arenite::study
