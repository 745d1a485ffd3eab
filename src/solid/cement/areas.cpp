#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solid/cement/cement.hpp"
#include "core/error.hpp"
#include "geometry/union_area.hpp"
#include "model/placed_cement.hpp"

namespace arenite::cement {

Areas exact_areas(const Packing& packing, const Cement& cement, const Window& window) {
  if (!(window.width() > 0 && window.height() > 0) || !std::isfinite(window.area()))
    throw InputError(fmt::format("the window for exact areas is {:g} x {:g} m; give it positive sides", window.width(),
                                 window.height()));
  const PlacedCement placed = place(packing, cement, window);
  auto outlines = grain_outlines(placed);
  Areas areas{window.area(), geometry::union_area(outlines, placed.window), 0};
  if (cement.full) {
    areas.matrix = areas.window - areas.particle;
    return areas;
  }
  const auto matrix = matrix_outlines(placed);
  if (matrix.empty()) return areas;
  outlines.insert(outlines.end(), matrix.begin(), matrix.end());
  areas.matrix = std::max(0.0, geometry::union_area(outlines, placed.window) - areas.particle);
  return areas;
}

}  // namespace arenite::cement
