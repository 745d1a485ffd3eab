#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "model/result.hpp"

namespace arenite::fields {

/// A box of spheres row by row of its history: its extents along the axes, m, and the mean stresses on the two sides
/// across each, Pa, compression positive.
struct BoxInSpace {
  std::array<std::vector<double>, 3> size, stress;
  std::array<double, 3> before{};  ///< extents that strains refer to, m

  std::size_t rows() const { return size[0].size(); }
  double volume(std::size_t row) const { return size[0][row] * size[1][row] * size[2][row]; }
  /// Of the two sides across an axis, m^2.
  double area(int axis, std::size_t row) const { return size[(axis + 1) % 3][row] * size[(axis + 2) % 3][row]; }
  /// Decrease of the volume over that before.
  std::vector<double> volumetric_strain() const;
  /// Volume of grains over that of the box.
  std::vector<double> solid_fraction(double grains) const;
};

/// Nothing without the sides' places and forces. Strains refer to Asked::box.
std::optional<BoxInSpace> box_in_space(const SphereResult& result);

/// What a history tells of a side: "_position", "_force", ..; null where it does not.
const std::vector<double>* column_of_side(const History& history, int side, const std::string& what);

}  // namespace arenite::fields
