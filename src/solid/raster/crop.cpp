#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "solid/raster/raster.hpp"

namespace arenite::raster {
namespace {

/// The frame; where there is none, what surrounds the grains.
geometry::Rectangle sample_of(const Packing& packing) {
  const Domain& d = packing.domain;
  if (d.width() > 0 && d.height() > 0)
    return {d.wall[left].position, d.wall[right].position, d.wall[bottom].position, d.wall[top].position};
  const Grains& g = packing.grains;
  if (g.size() == 0) return {};
  geometry::Rectangle box{INFINITY, -INFINITY, INFINITY, -INFINITY};
  for (std::size_t i = 0; i < g.size(); ++i)
    box = {std::min(box.x_min, g.x[i] - g.radius[i]), std::max(box.x_max, g.x[i] + g.radius[i]),
           std::min(box.y_min, g.y[i] - g.radius[i]), std::max(box.y_max, g.y[i] + g.radius[i])};
  return box;
}

}  // namespace

geometry::Rectangle crop_window(const Packing& packing, double crop) {
  const geometry::Rectangle sample = sample_of(packing);
  if (!(sample.width() > 0 && sample.height() > 0) || !std::isfinite(sample.area()))
    throw InputError("a sample without frame and grains has nothing to crop; give it a domain with positive sides");
  if (!(crop >= 0) || !std::isfinite(crop))
    throw InputError(fmt::format("the crop is {:g} m wide; give a positive length, or 0 for the largest square", crop));
  const double largest = std::min(sample.width(), sample.height());
  if (crop > largest * (1 + 1e-12))
    throw InputError(fmt::format("the crop of {:g} m does not fit into the sample of {:g} x {:g} m; give at most {:g} m", crop,
                                 sample.width(), sample.height(), largest));
  const double half = 0.5 * (crop > 0 ? std::min(crop, largest) : largest);
  const double x = 0.5 * (sample.x_min + sample.x_max), y = 0.5 * (sample.y_min + sample.y_max);
  return {x - half, x + half, y - half, y + half};
}

}  // namespace arenite::raster
