#pragma once
#include <string>
#include <vector>

#include "model/image.hpp"
#include "thermal/imaging/circles.hpp"

namespace arenite::imaging {

/// Circles of these radii (m; empty: of any); those of one class have one radius, which their mean gives better than
/// each by itself. `pixel` of the picture in m.
FoundCircles circles_of(const std::vector<double>& radii, const FloatImage& picture, double pixel,
                        CircleOptions options = {});

/// Materials of grains by their brightness, parted into as many classes as there are materials, of which `brightness`
/// gives the order; `where` names the picture in the InputError for one that cannot be parted.
void take_materials(const std::vector<double>& brightness, const std::string& where, PictureGrains& grains);

}  // namespace arenite::imaging
