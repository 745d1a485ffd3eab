#include <fmt/format.h>

#include <algorithm>

#include "recipe/recipe_key_parts.hpp"
#include "recipe/recipe_words.hpp"

namespace arenite::study {
namespace {

using Visitor = ParameterVisitor;

bool has_material(const Materials& materials, const std::string& name) {
  return std::any_of(materials.begin(), materials.end(), [&](const Material& m) { return m.name == name; });
}

void declare(Visitor& v, BidisperseSection& classes, const Materials& materials) {
  auto& law = classes.law;
  v.number({"large_radius", "Mean radius of the large disks.", true}, law.large_radius, "mm", range::positive);
  v.number({"size_ratio", "gamma: mean large over mean small radius."}, law.size_ratio, "", range::between(1, 20));
  v.number({"volume_ratio", "theta: area of the large over area of the small disks."}, law.volume_ratio, "", range::above(0, 100));
  v.number({"deviation", "Standard deviation of each class over its mean radius."}, law.deviation, "", range::between(0, 0.5));
  v.number({"cut", "Radii are cut at this many standard deviations."}, law.cut, "", range::above(0, 1.9));
  v.flag({"cut_each_class", "Each class is cut by itself; otherwise both to their common range."}, law.cut_each_class);
  v.flag({"hold_radius", "A radius is kept until it is placed; otherwise drawn anew at each trial, which favours small ones."},
         law.hold_radius);
  v.number({"box_area", "Area of the square box over pi large_radius^2."}, law.box_area, "", range::between(20, 1e6));
  std::int64_t trials = law.trials;
  v.integer({"trials", "Places tried round a disk before it is given up."}, trials, {1, 10'000});
  law.trials = static_cast<int>(trials);
  v.flag({"maximal", "After the trials every place is filled where a disk of the class still fits; the paper stops with the trials."}, law.maximal);
  v.number({"tolerance", "Relative error of the volume ratio at which the search for the gap between large disks ends."}, law.tolerance, "",
           range::between(1e-4, 0.5));
  v.text({"large", "Material of the large disks, a section of [materials]."}, classes.large);
  v.text({"small", "Material of the small disks, another section of [materials]."}, classes.small);
  for (const auto& [key, name] : {std::pair{"large", classes.large}, {"small", classes.small}})
    v.require(materials.empty() || has_material(materials, name), {key},
              fmt::format("there is no section [materials.{0}]; add it, or say which material the {1} disks have with bidisperse.{1}",
                          name, key));
  v.require(classes.large != classes.small, {"small", "large"},
            fmt::format("both classes are made of \"{}\"; give each a material of its own, with the same numbers if they are alike", classes.small));
  v.require(law.deviation * law.cut < 0.95, {"cut", "deviation"}, "radii would be cut at less than 5 % of their mean; lower cut or deviation");
}

void declare(Visitor& v, CementSection& cement) {
  using Kind = cement::CementParameters::Kind;
  auto& law = cement.law;
  v.choice({"kind", "Where the matrix is."}, law.kind, words(law.kind));
  v.number({"gap", "Widest surface gap that is bridged, and at which two grains count as neighbours; unless given, 0.075 of the "
                   "mean large radius."}, cement.gap, "mm", range::not_negative);
  const bool is_free = law.kind == Kind::bridges || law.kind == Kind::coating || law.kind == Kind::menisci;
  v.when(is_free, "kind = \"bridges\", \"coating\" or \"menisci\"", [&](Visitor& inner) {
    inner.number({"saturation", "S_m, the share of the space between grains that is matrix: width, thickness or volume is then found."},
                 law.saturation, "", range::above(0, 1));
  });
  const bool given = !law.saturation;
  v.when(law.kind == Kind::bridges, "kind = \"bridges\"", [&](Visitor& inner) {
    inner.flag({"full_width", "width is the whole base of a bridge over the radius, not half of it."}, law.full_width);
  });
  v.when(law.kind == Kind::bridges && given, "kind = \"bridges\" without saturation", [&](Visitor& inner) {
    inner.number({"width", "eta: half base of a bridge over the radius of its grain."}, law.width, "", range::above(0, 2));
  });
  v.when(law.kind == Kind::coating && given, "kind = \"coating\" without saturation", [&](Visitor& inner) {
    inner.number({"thickness", "Thickness of the layer.", true}, law.thickness, "mm", range::positive);
  });
  v.when(law.kind == Kind::menisci && given, "kind = \"menisci\" without saturation", [&](Visitor& inner) {
    inner.number({"volume", "Volume of one meniscus per unit length.", true}, law.volume, "mm^2", range::positive);
  });
}

void declare(Visitor& v, RasterSection& raster) {
  v.integer({"nodes", "Nodes along a side of the square."}, raster.nodes, {7, 32'768});
  v.number({"crop", "Side of the centred square that is cut out; unless given, 25.6 mean large radii of a sampled packing, otherwise "
                    "the largest square inside the sample."}, raster.crop, "mm", range::positive);
  v.flag({"eight_connected", "Pores and voids hang together over corners, too."}, raster.cavities.eight_connected);
  std::int64_t fewest = raster.cavities.fewest_nodes;
  v.integer({"fewest_nodes", "Pores and voids of fewer nodes are specks of the raster and left out."}, fewest, {1, 1'000'000});
  raster.cavities.fewest_nodes = static_cast<int>(fewest);
  v.flag({"leave_out_border", "Pores and voids that touch the edge are cut, and left out."}, raster.cavities.leave_out_border);
}

}  // namespace

peridynamics::Stiffness StiffnessSection::resolved() const {
  return {matrix, interface.value_or(matrix), particle.value_or(4 * matrix), calibrated};
}

peridynamics::Toughness ToughnessSection::resolved() const {
  return {matrix, interface.value_or(matrix), particle.value_or(3.5 * matrix)};
}

void declare_bidisperse(ParameterVisitor& v, Recipe& recipe) {
  const bool sampled = recipe.packing.method == PackingParameters::Method::poisson;
  v.when(sampled, "packing.method = \"poisson\"", [&](Visitor& outer) {
    outer.optional_section<BidisperseSection>(
        {"bidisperse", "Two size classes of disks in a square box of their own.", sampled}, recipe.bidisperse,
        [&](Visitor& inner, BidisperseSection& classes) { declare(inner, classes, recipe.materials); });
  });
}

void declare_second_road(ParameterVisitor& v, Recipe& recipe) {
  v.optional_section<CementSection>({"cement", "Binding matrix between the grains, put there when the stages are over."}, recipe.cement,
                                    [](Visitor& inner, CementSection& cement) { declare(inner, cement); });
  v.optional_section<RasterSection>({"raster", "The square of nodes that the cemented packing becomes."}, recipe.raster,
                                    [](Visitor& inner, RasterSection& raster) { declare(inner, raster); });
  v.list<Load>({"loads", "Loadings of the cemented sample by peridynamics, each from the unloaded state."}, recipe.loads,
               [&](Visitor& inner, Load& load) { declare(inner, load, recipe); });
}

}  // namespace arenite::study
