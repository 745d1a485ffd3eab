#include "grains/fields/coarse_grained.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"

namespace arenite::fields {
namespace {

using std::numbers::pi;

constexpr double gaussian_reach = 8.5;             // exp(-8.5^2/2) = 2.1e-16
constexpr double lucy_reach = 3.3466401061363023;  // sqrt(56/5): <x^2> = 5 c^2/56

/// Integral from 0 to t of 1 - 6 q^2 + 8 q^3 - 3 q^4 = (1 + 3 q)(1 - q)^3 with q^2 = p^2 + t^2: lengths in c.
double lucy_primitive(double p, double t) {
  const double p2 = p * p, t2 = t * t, r = std::sqrt(p2 + t2);
  const double squares = t * (p2 + t2 / 3), fourths = t * (p2 * p2 + t2 * (2 * p2 / 3 + t2 / 5));
  const double cubes = t * r * (r * r / 4 + 3 * p2 / 8) + (p2 > 0 ? 3 * p2 * p2 / 8 * std::asinh(t / p) : 0.0);
  return t - 6 * squares + 8 * cubes - 3 * fourths;
}

/// Integral of Lucy's function along the line at distance p from the centre, from t0 to t1; zero outside the unit circle.
double lucy_along(double p, double t0, double t1) {
  if (p >= 1) return 0;
  const double chord = std::sqrt(1 - p * p);
  const double from = std::clamp(t0, -chord, chord), to = std::clamp(t1, -chord, chord);
  return from < to ? 5 / pi * (lucy_primitive(p, to) - lucy_primitive(p, from)) : 0.0;
}

/// The same of the Gaussian of width 1, zero where the line lies beyond its reach.
double gaussian_along(double p, double t0, double t1) {
  if (p > gaussian_reach || t0 > gaussian_reach || t1 < -gaussian_reach) return 0;
  constexpr double root = std::numbers::sqrt2 / 2;
  return std::exp(-0.5 * p * p) / std::sqrt(8 * pi) * (std::erf(root * t1) - std::erf(root * t0));
}

}  // namespace

Kernel::Kernel(KernelShape shape, double width) : shape_(shape), width_(width), reach_(width * (shape == KernelShape::gaussian ? gaussian_reach : lucy_reach)) {
  if (!(width > 0) || !std::isfinite(width)) throw InputError(fmt::format("a coarse-graining width of {:g} m; give a positive length", width));
}

double Kernel::value(Vec2 d) const {
  if (shape_ == KernelShape::gaussian) return std::exp(-0.5 * dot(d, d) / (width_ * width_)) / (2 * pi * width_ * width_);
  const double q = norm(d) / reach_;
  return q < 1 ? 5 / (pi * reach_ * reach_) * (1 + 3 * q) * (1 - q) * (1 - q) * (1 - q) : 0;
}

Vec2 Kernel::gradient(Vec2 d) const {
  if (shape_ == KernelShape::gaussian) return -value(d) / (width_ * width_) * d;
  // d/dq (1 + 3 q)(1 - q)^3 = -12 q (1 - q)^2, and grad q = d/(q c^2).
  const double c2 = reach_ * reach_, q = norm(d) / reach_;
  return q < 1 ? -60 / (pi * c2 * c2) * (1 - q) * (1 - q) * d : Vec2{};
}

double Kernel::line_mean(Vec2 from, Vec2 to) const {
  const double length = norm(to - from), unit = shape_ == KernelShape::gaussian ? width_ : reach_;
  if (!(length > 0)) return value(from);
  const Vec2 along = (to - from) / length;
  const double p = std::abs(cross(from, along)) / unit, t0 = dot(from, along) / unit, t1 = dot(to, along) / unit;
  return (shape_ == KernelShape::gaussian ? gaussian_along(p, t0, t1) : lucy_along(p, t0, t1)) / (unit * length);
}

}  // namespace arenite::fields
