#pragma once
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "model/result.hpp"

namespace arenite::test {

/// A cube of 10 mm that y closes by 1 % over 40 rows, to a force of `top` that is largest half way, between sides with
/// `side`.
inline SphereResult pressed_spheres(double top, double side) {
  constexpr std::size_t rows = 41;
  SphereResult result;
  result.asked.closes = 1;
  result.snapshots.emplace_back();
  const auto add = [&](const std::string& name, auto value) {
    std::vector<double> values;
    for (std::size_t k = 0; k < rows; ++k) values.push_back(value(static_cast<double>(k) / (rows - 1)));
    result.history.columns.push_back({name, "", values});
  };
  for (const auto& [low, high] : {std::pair{"left", "right"}, {"bottom", "top"}, {"back", "front"}}) {
    const bool closes = std::string(low) == "bottom";
    add(std::string(low) + "_position", [](double) { return 0.0; });
    add(std::string(high) + "_position", [&](double t) { return closes ? 0.01 * (1 - 0.01 * t) : 0.01; });
    for (const char* of : {low, high})
      add(std::string(of) + "_force", [&](double t) { return closes ? top * 4 * t * (1 - t) : side; });
  }
  return result;
}

}  // namespace arenite::test
