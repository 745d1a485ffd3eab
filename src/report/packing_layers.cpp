#include "report/page_document.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "core/mapped.hpp"
#include "grains/fields/coarse_grained.hpp"
#include "grains/packing/population.hpp"
#include "model/shapes.hpp"
#include "recipe/recipe.hpp"

namespace arenite::report {
namespace {

constexpr double most_cells = 2500;

Numbers curve_of(const packing::SizeCurve& curve, NumberBlock& block) {
  return {{"diameter", block.add_reals(curve.diameter, "m")}, {"passing", block.add_coarse(curve.passing)}};
}

}  // namespace

Numbers coarse_fields_of(const Packing& packing, double shear_rate, NumberBlock& block) {
  if (!fields::has_fields(packing)) return {};
  const double spacing = std::max(fields::mean_diameter(packing.grains), std::sqrt(packing.domain.area() / most_cells));
  const auto f = fields::coarse_fields(packing, shear_rate, spacing, spacing);
  const auto& b = f.grid.bounds;
  Numbers out{{"bounds", {b.x_min, b.x_max, b.y_min, b.y_max}}, {"columns", f.grid.columns}, {"rows", f.grid.rows}, {"width", spacing}};
  out["solid_fraction"] = block.add_coarse(f.solid_fraction);
  out["density"] = block.add_coarse(f.density, "kg/m^3");
  const auto add = [&](const char* name, auto of_stresses) {  // of contacts and kinetic
    std::vector<double> values;
    for (std::size_t k = 0; k < f.grid.size(); ++k) values.push_back(of_stresses(f.contact_stress[k], f.kinetic_stress[k]));
    out[name] = block.add_coarse(values, "Pa");
  };
  using Stress = const Tensor2&;
  add("pressure", [](Stress c, Stress t) { return -0.5 * (trace(c) + trace(t)); });
  add("deviator", [](Stress c, Stress t) { return 0.5 * std::hypot(c.xx + t.xx - c.yy - t.yy, c.xy + c.yx + t.xy + t.yx); });
  add("shear", [](Stress c, Stress t) { return 0.5 * (c.xy + c.yx + t.xy + t.yx); });
  if (std::ranges::all_of(f.kinetic_stress, [](Stress t) { return trace(t) == 0; })) return out;
  out["vx"] = block.add_coarse(mapped(f.velocity, &Vec2::x), "m/s");
  out["vy"] = block.add_coarse(mapped(f.velocity, &Vec2::y), "m/s");
  add("kinetic", [](Stress, Stress t) { return -0.5 * trace(t); });
  return out;
}

Numbers shapes_of(Grains grains, NumberBlock& block) {
  grains.angle.assign(grains.size(), 0.0);
  std::vector<std::uint32_t> first{0};
  std::vector<Vec2> rim;
  for (std::size_t g = 0; g < grains.size(); ++g) {
    for (const Vec2& p : outline_of(grains, g, 0.3)) rim.push_back(p - grains.position[g]);
    first.push_back(static_cast<std::uint32_t>(rim.size()));
  }
  return {{"first", block.add_indices(first)}, {"x", block.add_reals(mapped(rim, &Vec2::x), "m")}, {"y", block.add_reals(mapped(rim, &Vec2::y), "m")}};
}

void add_grain_values(Numbers& out, const Packing& packing, const std::vector<Tensor2>& stresses, NumberBlock& block) {
  std::vector<double> pressure, deviator;
  for (const Tensor2& stress : stresses) {
    pressure.push_back(-0.5 * trace(stress));
    deviator.push_back(texture::deviator(stress));
  }
  const Grains& grains = packing.grains;
  add_columns(out, grains, io::grain_state_columns, {"x", "y", "angle"}, block);
  out["pressure"] = block.add_reals(pressure, "Pa");
  out["deviator"] = block.add_coarse(deviator, "Pa");
  const auto add_motion = [&](std::initializer_list<std::string_view> names) {
    add_columns(out, grains, io::grain_state_columns, names, block, &NumberBlock::add_coarse);
  };
  if (!std::ranges::all_of(grains.velocity, [](Vec2 v) { return v == Vec2{}; })) add_motion({"vx", "vy"});
  if (!std::ranges::all_of(grains.omega, [](double v) { return v == 0; })) add_motion({"omega"});
}

Numbers bonds_of(const Packing& packing, NumberBlock& block) {
  return {{"i", block.add_indices(mapped(packing.bonds, &Bond::i))},
          {"j", block.add_indices(mapped(packing.bonds, &Bond::j))},
          {"broken", block.add_indices(mapped(packing.bonds, &Bond::broken))}};
}

Numbers cohesive_of(const Packing& packing, NumberBlock& block) {
  return {{"i", block.add_indices(mapped(packing.cohesive, &CohesivePair::i))},
          {"j", block.add_indices(mapped(packing.cohesive, &CohesivePair::j))},
          {"gap", block.add_coarse(mapped(packing.cohesive, &CohesivePair::gap), "m")},
          {"pull", block.add_coarse(mapped(packing.cohesive, &CohesivePair::pull), "N")}};
}

Numbers boundaries_of(const Domain& domain, NumberBlock& block) {
  Numbers list = Numbers::list();
  for (const Boundary& boundary : domain.boundaries) {
    list.push_back({{"name", boundary.name},
                    {"closed", boundary.closed},
                    {"present", boundary.present},
                    {"x", block.add_reals(mapped(boundary.points, &Vec2::x), "m")},
                    {"y", block.add_reals(mapped(boundary.points, &Vec2::y), "m")},
                    {"force", {boundary.force.x, boundary.force.y}},
                    {"torque", boundary.torque}});
  }
  return list;
}

Numbers size_curves_of(const Packing& packing, const std::string& recipe, NumberBlock& block) {
  try {
    const recipe::Recipe asked = recipe::parse_recipe(recipe, "recipe");
    if (asked.populations.empty()) return {};
    return {{"measured", curve_of(packing::measured_size_curve(packing.grains, packing.materials), block)},
            {"asked", curve_of(packing::asked_size_curve(asked.populations, asked.materials, asked.packing.grains), block)}};
  } catch (const InputError&) {
    return {};  // a packing that no recipe made
  }
}

}  // namespace arenite::report
