#include "thermal/imaging/similarity.hpp"

#include <cmath>

namespace arenite::imaging {
namespace {

Vec2 turned(Vec2 p, double scale, double rotation, bool mirrored) {
  const double c = scale * std::cos(rotation), s = scale * std::sin(rotation), x = mirrored ? -p.x : p.x;
  return {c * x - s * p.y, s * x + c * p.y};
}

}  // namespace

Vec2 Similarity::operator()(Vec2 p) const { return turned(p, scale, rotation, mirrored) + shift; }

Similarity Similarity::inverse() const {
  // R(a) M = M R(-a): a mirrored picture turns the other way.
  Similarity back{1 / scale, mirrored ? rotation : -rotation, {}, mirrored};
  back.shift = -turned(shift, back.scale, back.rotation, mirrored);
  return back;
}

Similarity fit_similarity(std::span<const Vec2> from, std::span<const Vec2> to, bool mirrored) {
  const double n = static_cast<double>(from.size());
  Vec2 middle_from, middle_to;
  for (std::size_t k = 0; k < from.size(); ++k) {
    middle_from += (1 / n) * from[k];
    middle_to += (1 / n) * to[k];
  }
  double along = 0, across = 0, squares = 0;
  for (std::size_t k = 0; k < from.size(); ++k) {
    Vec2 a = from[k] - middle_from;
    const Vec2 b = to[k] - middle_to;
    if (mirrored) a.x = -a.x;
    along += dot(a, b);
    across += cross(a, b);
    squares += dot(a, a);
  }
  Similarity fit{std::hypot(along, across) / squares, std::atan2(across, along), {}, mirrored};
  fit.shift = middle_to - turned(middle_from, fit.scale, fit.rotation, mirrored);
  return fit;
}

PictureGrains apply(const Similarity& transform, PictureGrains grains) {
  for (std::size_t g = 0; g < grains.size(); ++g) {
    const Vec2 at = transform({grains.x[g], grains.y[g]});
    grains.x[g] = at.x;
    grains.y[g] = at.y;
  }
  for (auto* lengths : {&grains.radius, &grains.position_error, &grains.radius_error})
    for (double& v : *lengths) v *= transform.scale;
  return grains;
}

}  // namespace arenite::imaging
