#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/problems.hpp"
#include "core/vec.hpp"

namespace arenite::fields {

/// What a point is smeared out into.
enum class KernelShape {
  lucy,     ///< (1 + 3 r/c)(1 - r/c)^3 times 5/(pi c^2), in space times 105/(16 pi c^3), zero beyond c: two continuous
            ///< derivatives (L. B. Lucy, Astron. J. 82, 1013, 1977)
  gaussian  ///< exp(-r^2/2w^2) over 2 pi w^2, in space over (2 pi)^1.5 w^3: smooth to all orders, reaches far
};

/// Numbers of the kernels, in the plane and in space.
namespace kernels {
constexpr double gaussian_reach = 8.5;                                       // exp(-8.5^2/2) = 2.1e-16
constexpr std::array lucy_reach{3.3466401061363023, 3.4641016151377544};     // sqrt(56/5): <x^2> = 5 c^2/56; sqrt(12)
constexpr std::array lucy_factor{5.0, 105.0};                                // over
constexpr std::array lucy_divisor{std::numbers::pi, 16 * std::numbers::pi};  // and so many c
inline const std::array gaussian_divisor{2 * std::numbers::pi, 2 * std::numbers::pi* std::sqrt(2 * std::numbers::pi)};
inline const std::array line_divisor{std::sqrt(8 * std::numbers::pi), 4 * std::numbers::pi};  // of a Gaussian's line

/// Integral of Lucy's function 1 - 6 q^2 + 8 q^3 - 3 q^4 = (1 + 3 q)(1 - q)^3, q^2 = p^2 + t^2, along the line at
/// distance p from the centre, from t0 to t1; zero outside the unit circle. Given is p^2, lengths are in c.
template <int D> double lucy_along(double p2, double t0, double t1) {
  if (p2 >= 1) return 0;
  const double chord = std::sqrt(1 - p2), from = std::max(t0, -chord), to = std::min(t1, chord);
  if (from >= to) return 0;
  const double r0 = from > t0 ? 1 : std::sqrt(p2 + from * from), r1 = to < t1 ? 1 : std::sqrt(p2 + to * to);
  const auto powers = [p2](double t, double r) {
    const double t2 = t * t;
    const double squares = t * (p2 + t2 / 3), fourths = t * (p2 * p2 + t2 * (2 * p2 / 3 + t2 / 5));
    return t - 6 * squares + 8 * t * r * (r * r / 4 + 3 * p2 / 8) - 3 * fourths;
  };
  double integral = powers(to, r1) - powers(from, r0);
  // asinh t1/p - asinh t0/p, of r + t without a difference of equal numbers; nothing of a line through the centre.
  const auto sum = [p2](double t, double r) { return t > 0 ? r + t : p2 / (r - t); };
  if (p2 > 1e-24) integral += 3 * p2 * p2 * std::log(sum(to, r1) / sum(from, r0));
  return lucy_factor[D - 2] / lucy_divisor[D - 2] * integral;
}

/// The same of the Gaussian of width 1, zero where the line lies beyond its reach.
template <int D> double gaussian_along(double p2, double t0, double t1) {
  if (p2 > gaussian_reach * gaussian_reach || t0 > gaussian_reach || t1 < -gaussian_reach) return 0;
  constexpr double root = std::numbers::sqrt2 / 2;
  return std::exp(-0.5 * p2) / line_divisor[D - 2] * (std::erf(root * t1) - std::erf(root * t0));
}

/// Square of how far the centre lies from the line through a place along a unit vector.
inline double off_line2(Vec2 place, Vec2 along) { return cross(place, along) * cross(place, along); }
inline double off_line2(Vec3 place, Vec3 along) { return dot(cross(place, along), cross(place, along)); }

}  // namespace kernels

/// A coarse-graining function of the plane or of space: not negative, the same in all directions, of integral 1.
/// `width` is the standard deviation along one axis for either shape, m, so that fields of one width compare; for
/// Lucy's function c = sqrt(56/5) width, in space sqrt(12) width.
template <int D> class KernelIn {
 public:
  /// Throws InputError unless the width is positive and finite.
  KernelIn(KernelShape shape, double width) : shape_(shape), width_(width) {
    if (!(width > 0) || !std::isfinite(width))
      throw refusal("a coarse-graining width of {:g} m; give a positive length", width);
    const bool smooth = shape == KernelShape::gaussian;
    reach_ = width * (smooth ? kernels::gaussian_reach : kernels::lucy_reach[D - 2]);
    unit_ = smooth ? width : reach_;
    divisor_ = smooth ? kernels::gaussian_divisor[D - 2] : kernels::lucy_divisor[D - 2];
    const double c2 = reach_ * reach_;
    double of_slope = divisor_ * c2 * c2;
    for (int k = 0; k < D; ++k) divisor_ *= unit_;
    for (int k = 2; k < D; ++k) of_slope *= reach_;
    peak_ = kernels::lucy_factor[D - 2] / divisor_;
    // d/dq (1 + 3 q)(1 - q)^3 = -12 q (1 - q)^2, and grad q = d/(q c^2).
    slope_ = -12 * kernels::lucy_factor[D - 2] / of_slope;
  }

  /// Distance beyond which the function is zero, or below 2.1e-16 of its maximum (Gaussian, 8.5 widths), m.
  double reach() const { return reach_; }

  /// phi at a vector from the centre, 1/m^D.
  double value(Vec<D> d) const {
    if (shape_ == KernelShape::gaussian) return std::exp(-0.5 * dot(d, d) / (width_ * width_)) / divisor_;
    const double q = norm(d) / reach_;
    return q < 1 ? peak_ * (1 + 3 * q) * (1 - q) * (1 - q) * (1 - q) : 0;
  }

  /// Gradient of phi there, over 1 m more.
  Vec<D> gradient(Vec<D> d) const {
    if (shape_ == KernelShape::gaussian) return -value(d) / (width_ * width_) * d;
    const double q = norm(d) / reach_;
    return q < 1 ? slope_ * (1 - q) * (1 - q) * d : Vec<D>{};
  }

  /// A straight line that something is smeared out along: from a place to what is farther by `branch`, m.
  struct Line {
    explicit Line(Vec<D> way) : branch(way), length(norm(way)), along(length > 0 ? way / length : way) {}
    Vec<D> branch;
    double length;
    Vec<D> along;
  };

  /// Mean of phi along a line, integral over s in [0, 1] of phi(from + s branch), in closed form, 1/m^D.
  double line_mean(Vec<D> from, const Line& line) const {
    if (!(line.length > 0)) return value(from);
    const double p2 = kernels::off_line2(from, line.along) / (unit_ * unit_), t0 = dot(from, line.along) / unit_,
                 t1 = t0 + line.length / unit_;
    double over = unit_ * line.length;
    for (int k = 2; k < D; ++k) over *= unit_;
    return (shape_ == KernelShape::gaussian ? kernels::gaussian_along<D>(p2, t0, t1)
                                            : kernels::lucy_along<D>(p2, t0, t1)) /
           over;
  }

 private:
  KernelShape shape_;
  double width_, reach_, unit_;    ///< m
  double divisor_, peak_, slope_;  ///< of the function, and of Lucy's at its centre and of its gradient
};
using Kernel = KernelIn<2>;

}  // namespace arenite::fields
