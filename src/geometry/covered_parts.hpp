#pragma once
#include <vector>

#include "geometry/outline.hpp"

namespace arenite::geometry {

/// A part of an edge, t from 0 to 1.
struct Part {
  double from, to;
};

/// Sorts parts and joins those that touch.
void merge(std::vector<Part>& parts);

/// Which side of an edge an outline has to cover for the edge to be no boundary of the union. Beside its own shape's
/// (outside) this settles edges of two shapes that coincide: `either` gives the edge to the other shape.
enum class CoveredSide { outside, either, inside };

/// Appends the parts of `edge` along which `outline` covers that side. Sides are looked at `step` (m) off the edge, far
/// less than the shapes' size and far more than rounding.
void add_covered_parts(const Edge& edge, const Outline& outline, CoveredSide side, double step, std::vector<Part>& parts);

/// Appends the parts of `edge` that do not lie inside the window (on its border counts as not inside).
void add_parts_outside(const Edge& edge, const Rectangle& window, double step, std::vector<Part>& parts);

}  // namespace arenite::geometry
