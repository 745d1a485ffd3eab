#include <fmt/format.h>

#include <algorithm>

#include "workflow/cropped_packing.hpp"
#include "workflow/field_numbers.hpp"
#include "workflow/field_stages.hpp"

namespace arenite::study {
namespace {

constexpr double gap_over_radius = 0.075, crop_over_radius = 25.6;  // P's 3 nodes and 1024 nodes of 40 to a large radius

/// Mean radius of the grains of a material (of all: -1); 0 without any.
double mean_radius(const Packing& packing, std::int32_t material) {
  double sum = 0, count = 0;
  for (std::size_t g = 0; g < packing.grains.size(); ++g)
    if (material < 0 || packing.grains.material[g] == material) sum += packing.grains.radius[g], ++count;
  return count > 0 ? sum / count : 0;
}

std::int32_t index_of(const Materials& materials, const std::string& name) {
  const auto at = std::find_if(materials.begin(), materials.end(), [&](const Material& m) { return m.name == name; });
  return static_cast<std::int32_t>(at - materials.begin());
}

/// P's crop where nothing else is asked for and the sample is wide enough for it; 0: the largest square.
double crop_side(const Recipe& recipe, const RasterSection& section, const Packing& packing, double radius) {
  if (section.crop) return *section.crop;
  const double side = crop_over_radius * radius;
  return recipe.bidisperse && raster::crop_window(packing, 0).width() >= side ? side : 0;
}

std::string sentence(const SampleReports& reports, const PhaseMap& map, const RasterSection& section) {
  const auto& r = reports.raster;
  std::string text = fmt::format("{0} x {0} nodes of {1:.4g} mm, {2} grains; S_m {3:.4f} by geometry; areas on the nodes off by {4:+.2g} % (particles)",
                                 section.nodes, 1e3 * map.dx, map.grain_class.size(), reports.cement.saturation, 100 * r.particle_area_error);
  if (r.exact_matrix_area > 0) text += fmt::format(" and {:+.2g} % (matrix)", 100 * r.matrix_area_error);
  if (r.joints > 0) text += fmt::format("; the thinnest of {} joints spans {} nodes", r.joints, r.thinnest_joint);
  if (r.lost_joints > 0) text += fmt::format("; {} no node: refine the raster", r.lost_joints == 1 ? "1 joint has" : fmt::format("{} joints have", r.lost_joints));
  return text;
}

}  // namespace

std::optional<ClassMaterials> class_materials(const Recipe& recipe, const Packing& packing) {
  if (recipe.bidisperse)
    return ClassMaterials{index_of(packing.materials, recipe.bidisperse->large), index_of(packing.materials, recipe.bidisperse->small)};
  if (packing.materials.size() != 2) return std::nullopt;
  const double a = mean_radius(packing, 0), b = mean_radius(packing, 1);
  if (a == 0 || b == 0 || a == b) return std::nullopt;
  return a > b ? ClassMaterials{0, 1} : ClassMaterials{1, 0};
}

std::vector<GrainClass> classes(const Packing& packing, const std::optional<ClassMaterials>& materials) {
  std::vector<GrainClass> result;
  if (!materials) return result;
  for (const std::int32_t m : packing.grains.material)
    result.push_back(m == materials->large ? GrainClass::large : m == materials->small ? GrainClass::small : GrainClass::none);
  return result;
}

double reference_radius(const Recipe& recipe, const Packing& packing) {
  if (recipe.bidisperse) return recipe.bidisperse->law.large_radius;
  const auto materials = class_materials(recipe, packing);
  return mean_radius(packing, materials ? materials->large : -1);
}

FieldResult make_cemented_sample(const Recipe& recipe, const Packing& packing) {
  const RasterSection section = recipe.raster_or_default();
  const auto materials = class_materials(recipe, packing);
  const double radius = reference_radius(recipe, packing);
  SampleReports reports;
  reports.section = recipe.cement_or_none();
  reports.gap = reports.section.gap.value_or(gap_over_radius * radius);
  auto law = reports.section.law;
  law.gap = reports.gap;

  const double side = crop_side(recipe, section, packing, radius);
  const auto window = raster::crop_window(packing, side);
  const Cement cement = cement::make_cement(packing, law, window, reports.cement);
  FieldResult result;
  result.name = "cement";
  result.map = raster::rasterise(packing, cement, {section.nodes, side}, classes(packing, materials), reports.raster);
  auto cropped = crop(packing, cement, reports.raster.grain_of_label, {window.x_min, window.y_min});
  result.packing = std::move(cropped.packing);
  result.cement = std::move(cropped.cement);
  if (materials) reports.coordination = texture::gap_coordination(packing, reports.gap, materials->large, materials->small, window);
  result.outcome = sentence(reports, result.map, section);
  result.numbers = with_reports(map_numbers(result.map, section.cavities, radius), reports);
  return result;
}

}  // namespace arenite::study
