#include "grains/fields/laboratory/box_in_space.hpp"

namespace arenite::fields {

using Values = std::vector<double>;

Values BoxInSpace::volumetric_strain() const {
  Values strain;
  for (std::size_t k = 0; k < rows(); ++k) strain.push_back(1 - volume(k) / (before[0] * before[1] * before[2]));
  return strain;
}

Values BoxInSpace::solid_fraction(double grains) const {
  Values fraction;
  for (std::size_t k = 0; k < rows(); ++k) fraction.push_back(grains / volume(k));
  return fraction;
}

const Values* column_of_side(const History& history, int side, const std::string& what) {
  return history.find(any_side_names[static_cast<std::size_t>(side)] + what);
}

std::optional<BoxInSpace> box_in_space(const SphereResult& result) {
  BoxInSpace box;
  std::array<Values, 3> force;
  for (int axis = 0; axis < 3; ++axis) {
    const auto of = [&](int side, const char* what) { return column_of_side(result.history, side, what); };
    const auto *low = of(2 * axis, "_position"), *high = of(2 * axis + 1, "_position"), *push = of(2 * axis, "_force"),
               *pull = of(2 * axis + 1, "_force");
    if (!low || !high || !push || !pull || low->empty()) return {};
    for (std::size_t k = 0; k < low->size(); ++k) {
      box.size[axis].push_back((*high)[k] - (*low)[k]);
      force[axis].push_back(0.5 * ((*push)[k] + (*pull)[k]));
    }
  }
  box.before = result.asked.box;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (!(box.before[axis] > 0)) box.before[axis] = box.size[axis].front();
  for (int axis = 0; axis < 3; ++axis)
    for (std::size_t k = 0; k < force[axis].size(); ++k) box.stress[axis].push_back(force[axis][k] / box.area(axis, k));
  return box;
}

}  // namespace arenite::fields
