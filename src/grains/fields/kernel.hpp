#pragma once
#include "core/vec.hpp"

namespace arenite::fields {

/// What a point is smeared out into.
enum class KernelShape {
  gaussian,  ///< exp(-r^2/2w^2)/(2 pi w^2): smooth to all orders, reaches far
  lucy       ///< 5/(pi c^2) (1 + 3 r/c)(1 - r/c)^3, zero beyond c: two continuous derivatives (L. B. Lucy, Astron. J. 82, 1013, 1977)
};

/// A coarse-graining function of the plane: not negative, the same in all directions, of integral 1. `width` is the standard deviation
/// along one axis for either shape, m, so that fields of one width compare; for Lucy's function c = sqrt(56/5) width.
class Kernel {
 public:
  /// Throws InputError unless the width is positive and finite.
  Kernel(KernelShape shape, double width);

  /// Distance beyond which the function is zero, or below 2.1e-16 of its maximum (Gaussian, 8.5 widths), m.
  double reach() const { return reach_; }

  /// phi at a vector from the centre, 1/m^2.
  double value(Vec2 d) const;

  /// Gradient of phi there, 1/m^3.
  Vec2 gradient(Vec2 d) const;

  /// Mean of phi along a straight line, integral over s in [0, 1] of phi(from + s (to - from)), in closed form, 1/m^2.
  double line_mean(Vec2 from, Vec2 to) const;

 private:
  KernelShape shape_;
  double width_, reach_;
};

}  // namespace arenite::fields
