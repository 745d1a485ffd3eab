#pragma once
#include <optional>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "model/packing.hpp"

namespace arenite::python {

/// The container of a packing of one's own.
struct OwnContainer {
  Vec2 corner;                                  ///< lower left, m
  double width = 0, height = 0, thickness = 0;  ///< m
  std::string periodic;
};

/// A packing of arrays. `contacts` is None, or anything with columns i and j, and perhaps fn, ft, nx, ny: a dict, a
/// table of pandas, Contacts. Throws InputError with every row that cannot be meant.
Packing own_packing(const ArrayLike& x, const ArrayLike& y, const ArrayLike& radius,
                    const std::optional<ArrayLike>& material, std::vector<Material> materials,
                    const OwnContainer& container, const py::object& contacts);

}  // namespace arenite::python
