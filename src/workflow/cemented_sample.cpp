#include "workflow/cemented_sample.hpp"

#include <fmt/core.h>

#include <cmath>
#include <utility>

#include "core/mapped.hpp"
#include "grains/texture/texture.hpp"
#include "solid/grid/crop.hpp"
#include "solid/grid/map_numbers.hpp"
#include "statistics/correlation.hpp"
#include "workflow/field_numbers.hpp"

namespace arenite::workflow {
namespace {

constexpr double gap_over_radius = 0.075,
                 crop_over_radius = 25.6;  // P's 3 nodes and 1024 nodes of 40 to a large radius

/// Mean radius of the grains of a material (of all: -1); 0 without any.
double mean_radius(const Packing& packing, std::int32_t material) {
  const auto counts =
      mapped<std::uint8_t>(packing.grains.material, [&](auto m) { return material < 0 || m == material; });
  const double mean = statistics::mean_of_known(packing.grains.radius, counts);
  return std::isfinite(mean) ? mean : 0;
}

/// P's crop where nothing else is asked for and the sample is wide enough for it; 0: the largest square.
double crop_side(const recipe::Recipe& recipe, const recipe::GridSection& section, const Packing& packing,
                 double radius) {
  if (section.crop) return *section.crop;
  const double side = crop_over_radius * radius;
  return recipe.bidisperse && grid::crop_window(packing, 0).width() >= side ? side : 0;
}

std::string sentence(const SampleReports& reports, const PhaseMap& map, const recipe::GridSection& section) {
  const auto& r = reports.grid;
  std::string text = fmt::format(
      "{0} x {0} nodes of {1:.4g} mm, {2} grains; S_m {3:.4f} by geometry; areas on the nodes off by {4:+.2g} % "
      "(particles)",
      section.nodes, 1e3 * map.dx, map.grain_class.size(), reports.cement.saturation, 100 * r.particle_area_error);
  if (r.exact_matrix_area > 0) text += fmt::format(" and {:+.2g} % (matrix)", 100 * r.matrix_area_error);
  if (r.necks > 0) text += fmt::format("; the thinnest of {} necks spans {} nodes", r.necks, r.thinnest_neck);
  if (r.lost_necks > 0)
    text += fmt::format("; {} no node: refine the grid",
                        r.lost_necks == 1 ? "1 neck has" : fmt::format("{} necks have", r.lost_necks));
  return text;
}

}  // namespace

std::optional<ClassMaterials> class_materials(const recipe::Recipe& recipe, const Packing& packing) {
  const auto index = [&](const std::string& name) {
    return static_cast<std::int32_t>(index_of(packing.materials, name));
  };
  if (recipe.bidisperse) return ClassMaterials{index(recipe.bidisperse->large), index(recipe.bidisperse->small)};
  if (packing.materials.size() != 2) return std::nullopt;
  const double a = mean_radius(packing, 0), b = mean_radius(packing, 1);
  if (a == 0 || b == 0 || a == b) return std::nullopt;
  return a > b ? ClassMaterials{0, 1} : ClassMaterials{1, 0};
}

std::vector<GrainClass> classes(const Packing& packing, const std::optional<ClassMaterials>& materials) {
  std::vector<GrainClass> result;
  if (!materials) return result;
  for (const std::int32_t m : packing.grains.material)
    result.push_back(m == materials->large   ? GrainClass::large
                     : m == materials->small ? GrainClass::small
                                             : GrainClass::none);
  return result;
}

FieldResult make_cemented_sample(const recipe::Recipe& recipe, const Packing& packing) {
  const recipe::GridSection section = recipe.grid_or_default();
  const auto materials = class_materials(recipe, packing);
  // What gaps and crops are measured by: the mean radius of the large grains, as it was asked for or as it is, or of
  // all.
  const double radius =
      recipe.bidisperse ? recipe.bidisperse->law.large_radius : mean_radius(packing, materials ? materials->large : -1);
  SampleReports reports;
  reports.law = recipe.cement_or_none();
  if (!reports.law.gap) reports.law.gap = gap_over_radius * radius;
  const double side = crop_side(recipe, section, packing, radius);
  const auto window = grid::crop_window(packing, side);
  const Cement cement = cement::make_cement(packing, reports.law, window, reports.cement);
  FieldResult result;
  result.name = "cement";
  result.map = grid::rasterise(packing, cement, {section.nodes, side}, classes(packing, materials), reports.grid);
  auto cropped = grid::crop(packing, cement, reports.grid.grain_of_label, {window.x_min, window.y_min});
  result.packing = std::move(cropped.packing);
  result.cement = std::move(cropped.cement);
  if (materials)
    reports.coordination =
        texture::gap_coordination(packing, *reports.law.gap, materials->large, materials->small, window);
  result.outcome = sentence(reports, result.map, section);
  result.numbers = grid::map_numbers(result.map, section.cavities, radius);
  add_reports(result.numbers, reports);
  return result;
}

}  // namespace arenite::workflow
