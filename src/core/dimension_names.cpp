#include <fmt/format.h>

#include <array>
#include <utility>

#include "core/units.hpp"

namespace arenite {
namespace {

struct NamedDimension {
  Dimension dimension;
  std::string_view name, unit;
};
constexpr std::array named_dimensions{
    NamedDimension{dimension::none, "a number without unit", ""},
    NamedDimension{dimension::length, "a length", "m"},
    NamedDimension{dimension::mass, "a mass", "kg"},
    NamedDimension{dimension::time, "a time", "s"},
    NamedDimension{dimension::temperature, "a temperature", "K"},
    NamedDimension{dimension::area, "an area", "m^2"},
    NamedDimension{dimension::volume, "a volume", "m^3"},
    NamedDimension{dimension::frequency, "a rate", "1/s"},
    NamedDimension{dimension::velocity, "a velocity", "m/s"},
    NamedDimension{dimension::acceleration, "an acceleration", "m/s^2"},
    NamedDimension{dimension::density, "a density", "kg/m^3"},
    NamedDimension{dimension::force, "a force", "N"},
    NamedDimension{dimension::pressure, "a pressure", "Pa"},
    NamedDimension{dimension::energy, "an energy", "J"},
    NamedDimension{dimension::stiffness, "a force per length", "N/m"},
    NamedDimension{dimension::damping, "a damping coefficient", "N s/m"},
    NamedDimension{dimension::thermoelastic_factor, "a thermoelastic factor", "K/Pa"},
    NamedDimension{dimension::toughness, "a fracture toughness", "Pa m^0.5"},
};

const NamedDimension* find_name(Dimension d) {
  for (const auto& named : named_dimensions) {
    if (named.dimension == d) return &named;
  }
  return nullptr;
}

}  // namespace

std::string si_unit(Dimension dimension) {
  if (const auto* named = find_name(dimension)) return std::string(named->unit);
  std::string text;
  const std::array<std::pair<const char*, double>, 4> bases{
      {{"kg", dimension.mass}, {"m", dimension.length}, {"s", dimension.time}, {"K", dimension.temperature}}};
  for (const auto& [symbol, power] : bases) {
    if (power == 0) continue;
    text += (text.empty() ? "" : " ") + std::string(symbol);
    if (power != 1) text += fmt::format("^{}", power);
  }
  return text;
}

std::string describe(Dimension dimension) {
  const auto* named = find_name(dimension);
  return named ? std::string(named->name) : "a quantity in " + si_unit(dimension);
}

}  // namespace arenite
