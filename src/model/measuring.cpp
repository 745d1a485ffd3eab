#include "model/measuring.hpp"

#include <limits>
#include <numbers>

#include "core/parameters.hpp"

namespace arenite {

void declare(ParameterVisitor& v, Measuring& measuring) {
  v.number({"border", "Width of the strip left out along walls, in mean diameters."}, measuring.border, "",
           range::between(0, 1000));
  v.number({"load_axis",
            "Direction of the load for signed anisotropies, from x; unless given, the axis along which sides load, or "
            "that of greatest compression."},
           measuring.load_axis, "deg", range::between(0, std::numbers::pi));
  v.integer({"seed", "Seed of the random positions of windows."}, measuring.seed,
            {0, std::numeric_limits<std::int64_t>::max()});
}

}  // namespace arenite
