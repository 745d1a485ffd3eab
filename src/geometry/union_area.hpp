#pragma once
#include <span>

#include "core/vec.hpp"
#include "geometry/outline.hpp"
#include "geometry/rectangle.hpp"

namespace arenite::geometry {

/// Area of the part of a window that at least one outline covers, by Green's theorem over those pieces of the
/// boundaries that no other outline covers; exact to rounding, boundaries that coincide included. Cost is linear in the
/// number of outlines for shapes of like size.
double union_area(std::span<const Outline> outlines, const Rectangle& window);

/// Area that a disk and a rectangle have in common, exact to rounding (union_area.cpp).
double disk_window_area(Vec2 centre, double radius, const Rectangle& window);

}  // namespace arenite::geometry
