#pragma once
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "model/result.hpp"

namespace arenite::test {

/// A cube of 10 mm under 5 N on every side, with one sphere of 2 mm and 2500 kg/m^3, over 400 s; bottom and top bear
/// `shear` N along x.
inline SphereResult cube_of_spheres(double shear) {
  constexpr std::size_t rows = 401;
  SphereResult result;
  auto& packing = result.snapshots.emplace_back().packing;
  packing.materials.emplace_back().density = 2500;
  packing.grains.resize(1);
  packing.grains.radius[0] = 1e-3;
  const auto add = [&](const std::string& name, const std::function<double(double)>& value) {
    std::vector<double> values;
    for (std::size_t k = 0; k < rows; ++k) values.push_back(value(static_cast<double>(k)));
    result.history.columns.push_back({name, "", values});
  };
  add("time", [](double t) { return t; });
  for (const auto& [low, high] : {std::pair{"left", "right"}, {"bottom", "top"}, {"back", "front"}}) {
    add(std::string(low) + "_position", [](double) { return 0.0; });
    add(std::string(high) + "_position", [](double) { return 0.01; });
    for (const char* of : {low, high}) add(std::string(of) + "_force", [](double) { return 5.0; });
  }
  // What bears the shear fluctuates a little, as that of grains does.
  const auto bears = [=](double t) { return shear * (1 + 0.01 * std::sin(2.3 * t)); };
  add("bottom_shear_force_x", bears);
  add("top_shear_force_x", [=](double t) { return -bears(t); });
  return result;
}

/// At `rate`, 1/s.
inline void shear_the_cell(SphereResult& result, double rate) {
  std::vector<double> strain = *result.history.find("time");
  for (double& v : strain) v = 0.1 + rate * v;
  result.history.columns.push_back({"shear_strain", "1", strain});
}

}  // namespace arenite::test
