#include <fmt/format.h>

#include <algorithm>

#include "core/nearest.hpp"
#include "core/units.hpp"
#include "recipe/recipe_key_parts.hpp"

namespace arenite::study {
namespace {

using Visitor = ParameterVisitor;

void declare(Visitor& v, Material& material) {
  v.number({"density", "Mass density.", true}, material.density, "kg/m^3", range::positive);
  v.number({"stiffness", "Contact stiffness k of two grains of this material.", true}, material.stiffness, "kN/mm",
           range::positive);
  v.number({"thermoelastic_factor", "Temperature rise per fall of the sum of principal stresses; 0: not known."},
           material.thermoelastic_factor, "K/MPa", range::not_negative);
}

/// Names that stand in a column of a CSV.
bool is_label(const std::string& name) {
  return !name.empty() && std::none_of(name.begin(), name.end(), [](unsigned char c) {
    return c < ' ' || c == 127 || c == ',' || c == '"' || c == '\'' || c == ';';
  });
}

void declare(Visitor& v, SizeLaw& law) {
  using Kind = SizeLaw::Kind;
  v.choice({"law", "How diameters are drawn.", true}, law.kind,
           {{"fixed", "one diameter"},
            {"uniform", "evenly between min and max"},
            {"normal", "Gaussian of mean and deviation, cut to min..max"},
            {"list", "the values in turn, from the start again when used up"}});
  v.when(law.kind == Kind::fixed, "law = \"fixed\"", [&](Visitor& inner) {
    inner.number({"diameter", "The diameter.", true}, law.diameter, "mm", range::positive);
  });
  v.when(law.kind == Kind::normal, "law = \"normal\"", [&](Visitor& inner) {
    inner.number({"mean", "Mean diameter before the cut.", true}, law.mean, "mm", range::positive);
    inner.number({"deviation", "Standard deviation before the cut.", true}, law.deviation, "mm", range::not_negative);
  });
  v.when(law.kind == Kind::uniform || law.kind == Kind::normal, "law = \"uniform\" or \"normal\"", [&](Visitor& inner) {
    inner.number({"min", "Smallest diameter.", true}, law.min, "mm", range::positive);
    inner.number({"max", "Largest diameter.", true}, law.max, "mm", range::positive);
    inner.require(law.max >= law.min, {"max", "min"}, "must not be below min");
  });
  v.when(law.kind == Kind::normal, "law = \"normal\"", [&](Visitor& inner) {
    inner.require(law.mean >= law.min && law.mean <= law.max, {"mean", "min", "max"}, "must lie between min and max");
  });
  v.when(law.kind == Kind::list, "law = \"list\"", [&](Visitor& inner) {
    inner.numbers({"values", "The diameters.", true}, law.values, "mm", range::positive);
    inner.require(!law.values.empty(), {"values"}, "must hold at least one diameter");
  });
}

void require_known_material(Visitor& v, const Population& population, const Materials& materials) {
  std::vector<std::string> names;
  for (const auto& material : materials) names.push_back(material.name);
  const bool known = names.empty() || std::find(names.begin(), names.end(), population.material) != names.end();
  const std::string near = nearest(population.material, names);
  v.require(known, {"material"},
            fmt::format("there is no section [materials.{}]; {}", population.material,
                        near.empty() ? "add it" : fmt::format("did you mean \"{}\"?", near)));
}

double largest_diameter(const SizeLaw& law) {
  if (law.kind == SizeLaw::Kind::fixed) return law.diameter;
  if (law.kind == SizeLaw::Kind::list) return law.values.empty() ? 0 : *std::max_element(law.values.begin(), law.values.end());
  return law.max;
}

}  // namespace

void declare_materials(Visitor& v, Materials& materials) {
  v.sections({"materials", "Constitutive materials of the grains, by name.", true},
             {[&] { return materials.size(); }, [&](std::size_t n) { materials.resize(n); },
              [&](Visitor& inner, std::size_t i) {
                inner.require(is_label(materials[i].name), {},
                              "a material's name must not be empty or hold commas, quotes or control characters");
                declare(inner, materials[i]);
              },
              [&](std::size_t i) -> std::string& { return materials[i].name; }});
}

void declare(Visitor& v, Population& population, const Recipe& recipe) {
  v.text({"material", "Name of a section of [materials].", true}, population.material);
  require_known_material(v, population, recipe.materials);
  v.integer({"count", "Number of grains."}, population.count, {1, 100'000'000});
  v.number({"ratio", "Share by number of packing.grains, relative to the ratios of the other populations."},
           population.ratio, "", range::positive);
  v.require(population.count.has_value() != population.ratio.has_value(), {"ratio", "count"},
            "give either count or ratio");

  auto& size = population.size;
  const bool is_fixed = size.kind == SizeLaw::Kind::fixed;
  std::optional<double> diameter = is_fixed && size.diameter > 0 ? std::optional(size.diameter) : std::nullopt;
  v.number({"diameter", "Diameter of every grain; short for size = { law = \"fixed\", ... }."}, diameter, "mm",
           range::positive);
  if (diameter) size.diameter = *diameter;
  bool has_law = !is_fixed;
  v.section({"size", "Size law of the grains, where they are not all equal."}, has_law,
            [&](Visitor& inner) { declare(inner, size); });
  v.require(diameter.has_value() != has_law, {"size", "diameter"}, "give either diameter or size");
  const double width = recipe.frame.width;
  v.require(width <= 0 || largest_diameter(size) <= width, {"diameter", "size"},
            fmt::format("the largest grain ({}) is wider than the frame ({})",
                        format_quantity(largest_diameter(size), "mm"), format_quantity(width, "mm")));
}

}  // namespace arenite::study
