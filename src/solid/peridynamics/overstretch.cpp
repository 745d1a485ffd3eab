#include "solid/peridynamics/overstretch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"

namespace arenite::peridynamics {

double critical_stretch(double toughness, double young, double dx) {
  return toughness / young * std::sqrt(4 * std::numbers::pi / (9 * horizon * dx));
}

std::array<double, 4> critical_stretches(const Toughness& k, const Stiffness& e, double dx) {
  for (const auto& [name, value] :
       {std::pair{"matrix", k.matrix}, std::pair{"interface", k.interface}, std::pair{"particle", k.particle}})
    if (!(value > 0) || !std::isfinite(value))
      throw InputError(fmt::format("the toughness of {} bonds is {:g} Pa m^0.5; give a positive one", name, value));
  return {0, critical_stretch(k.matrix, e.matrix, dx), critical_stretch(k.interface, e.interface, dx),
          critical_stretch(k.particle, e.particle, dx)};
}

double Overstretch::largest() {
  for (int y = 0; y < bonds_.grid.height; ++y) {
    double worst = 0;
    each_bond_of_row(bonds_, y, [&](const Bond& b) { worst = std::max(worst, ratio(b)); });
    by_row_[static_cast<std::size_t>(y)] = worst;
  }
  return *std::max_element(by_row_.begin(), by_row_.end());
}

}  // namespace arenite::peridynamics
