#include "workflow/cemented_sample.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "core/problems.hpp"
#include "grains/texture/gap_coordination.hpp"
#include "grains/texture/texture.hpp"
#include "model/grain_classes.hpp"
#include "model/sphere_pack.hpp"
#include "solid/grid/crop.hpp"
#include "solid/grid/label_grains.hpp"
#include "solid/grid/map_numbers.hpp"
#include "solid/grid/rasterise_spheres.hpp"
#include "workflow/field_numbers.hpp"

namespace arenite::workflow {
namespace {

/// P's crop where nothing else is asked for and the sample is wide enough for it; 0: the largest square.
double crop_side(const recipe::Recipe& recipe, const recipe::GridSection& section, const Packing& packing,
                 double radius) {
  if (section.crop) return *section.crop;
  const double side = sample_lengths(radius).window;
  return recipe.bidisperse && grid::crop_window(packing, 0).width() >= side ? side : 0;
}

std::string sentence(const SampleReports& reports, const PhaseMap& map) {
  const auto& r = reports.grid;
  std::string text = fmt::format(
      "{0} x {0} nodes of {1:.4g} mm, {2} grains; S_m {3:.4f} by geometry; areas on the nodes off by {4:+.2g} % "
      "(particles)",
      map.width, 1e3 * map.dx, map.grain_class.size(), reports.cement.saturation, 100 * r.particle_area_error);
  if (r.exact_matrix_area > 0) text += fmt::format(" and {:+.2g} % (matrix)", 100 * r.matrix_area_error);
  if (r.necks > 0) text += fmt::format("; the thinnest of {} necks spans {} nodes", r.necks, r.thinnest_neck);
  if (r.lost_necks > 0)
    text += fmt::format("; {} no node: refine the grid",
                        r.lost_necks == 1 ? "1 neck has" : fmt::format("{} necks have", r.lost_necks));
  return text;
}

/// Those of [bidisperse], or by the radii.
template <int D>
std::optional<ClassMaterials> class_materials(const recipe::Recipe& recipe, const PackingIn<D>& packing) {
  if (!recipe.bidisperse) return classes_by_radius(packing);
  const auto index = [&](const std::string& name) {
    return static_cast<std::int32_t>(index_of(packing.materials, name));
  };
  return ClassMaterials{index(recipe.bidisperse->large), index(recipe.bidisperse->small)};
}

/// What gaps and crops are measured by, m: the mean radius of the large grains, as it was asked for or as it is, or of
/// all.
template <int D>
double length_of(const recipe::Recipe& recipe, const PackingIn<D>& packing,
                 const std::optional<ClassMaterials>& materials) {
  return recipe.bidisperse ? recipe.bidisperse->law.large_radius
                           : mean_radius(packing, materials ? materials->large : -1);
}

/// Spheres, and those of their periodic images that reach into a cube in the middle of their container or, by their
/// necks, might.
SpherePack cube_of(const PackingIn<3>& packing, std::optional<double> crop, double gap) {
  const DomainIn<3>& cell = packing.domain;
  const Vec3 size = cell.size();
  const double widest = std::min({size.x, size.y, size.z}), side = crop.value_or(widest);
  if (side > (1 + 1e-9) * widest)
    throw refusal("grid.crop of {:.4g} mm is wider than the sample of {:.4g} x {:.4g} x {:.4g} mm; ask for less",
                  1e3 * side, 1e3 * size.x, 1e3 * size.y, 1e3 * size.z);
  SpherePack pack;
  const Vec3 half{side / 2, side / 2, side / 2}, middle = cell.corner() + 0.5 * size;
  pack.low = middle - half, pack.high = middle + half;
  const double around = gap + 2 * *std::ranges::max_element(packing.grains.radius);
  for (std::size_t g = 0; g < packing.grains.size(); ++g)
    cell.each_near_cell([&](Cells<3> cells) {
      const Vec3 centre = cell.wrapped(packing.grains.position[g]) + cell.way(cells), off = centre - middle;
      const double reach = side / 2 + packing.grains.radius[g] + around;
      if (std::max({std::abs(off.x), std::abs(off.y), std::abs(off.z)}) > reach) return;
      pack.centre.push_back(centre);
      pack.radius.push_back(packing.grains.radius[g]);
      pack.label.push_back(static_cast<std::int32_t>(g));
    });
  return pack;
}

}  // namespace

VoxelMap make_cemented_sample(const recipe::Recipe& recipe, const PackingIn<3>& packing,
                              const std::function<void(const std::string&)>& notice) {
  const recipe::GridSection section = recipe.grid_or_default();
  const auto materials = class_materials(recipe, packing);
  cement::CementParameters law = recipe.cement_or_none();
  if (!law.gap) law.gap = sample_lengths(length_of(recipe, packing, materials)).gap;
  double parameter = 0;
  VoxelMap map =
      grid::cemented_voxels(cube_of(packing, section.crop, *law.gap), law, static_cast<int>(section.voxels), parameter);
  map.grain_class = classes_of(packing, materials);
  map.grain_class.resize(packing.grains.size(), GrainClass::none);
  grid::drop_absent_grains(map);
  notice(fmt::format("cement: {0} x {0} x {0} voxels of {1:.4g} mm, {2} grains; S_m {3:.4f}", map.width, 1e3 * map.dx,
                     map.grain_class.size(), grid::saturation_of(map)));
  if (const std::string doubt = grid::doubt_about_cement(law, map); !doubt.empty()) notice("cement: " + doubt);
  return map;
}

FieldResult make_cemented_sample(const recipe::Recipe& recipe, const Packing& packing) {
  const recipe::GridSection section = recipe.grid_or_default();
  const auto materials = class_materials(recipe, packing);
  const double radius = length_of(recipe, packing, materials);
  SampleReports reports;
  reports.law = recipe.cement_or_none();
  if (!reports.law.gap) reports.law.gap = sample_lengths(radius).gap;
  const double side = crop_side(recipe, section, packing, radius);
  const auto window = grid::crop_window(packing, side);
  const Cement cement = cement::make_cement(packing, reports.law, window, reports.cement);
  FieldResult result;
  result.name = "cement";
  result.map = grid::rasterise(packing, cement, {section.nodes, side}, classes_of(packing, materials), reports.grid);
  auto cropped = grid::crop(packing, cement, reports.grid.grain_of_label, {window.x_min, window.y_min});
  result.packing = std::move(cropped.packing);
  result.cement = std::move(cropped.cement);
  if (materials)
    reports.coordination =
        texture::gap_coordination(packing, *reports.law.gap, materials->large, materials->small, window);
  result.outcome = sentence(reports, result.map);
  result.numbers = grid::map_numbers(result.map, section.cavities, radius);
  add_reports(result.numbers, reports);
  return result;
}

}  // namespace arenite::workflow
