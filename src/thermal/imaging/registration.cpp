#include "thermal/imaging/registration.hpp"

#include <algorithm>
#include <cmath>

#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "model/packing.hpp"
#include "thermal/imaging/registration_search.hpp"

namespace arenite::imaging {
namespace {

Vec2 turned(Vec2 p, double scale, double rotation, bool mirrored) {
  const double c = scale * std::cos(rotation), s = scale * std::sin(rotation), x = mirrored ? -p.x : p.x;
  return {c * x - s * p.y, s * x + c * p.y};
}

constexpr double least_matched = 0.5;  // share of the smaller set that must find its partner

void check(const PictureGrains& grains, const char* which) {
  if (grains.size() < 3)
    throw refusal("the {} picture shows {} grains; three are needed to register two pictures", which, grains.size());
  for (std::size_t k = 0; k < grains.size(); ++k)
    if (!is_finite(grains.centre[k]) || !(grains.radius[k] > 0))
      throw refusal("grain {} of the {} picture has no position or no positive radius", k, which);
}

/// Of the transform, from the distances that it leaves.
void tell_errors(const PictureGrains& from, const RegistrationSearch& search, Registration& r) {
  const double n = static_cast<double>(r.pairs.size());
  const Vec2 middle = mean_point(mapped(r.pairs, [&](const auto& pair) { return from.centre[pair.first]; }));
  double squares = 0, spread = 0;
  for (const auto& pair : r.pairs) {
    squares += std::pow(search.distance(r.transform, pair), 2);
    spread += dot(from.centre[pair.first] - middle, from.centre[pair.first] - middle);
  }
  r.rms = std::sqrt(squares / (2 * n));
  r.scale_error = std::sqrt(squares / std::max(1.0, 2 * n - 4)) / std::sqrt(spread);
  r.rotation_error = r.scale_error / r.transform.scale;
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
  for (Vec2& centre : grains.centre) centre = transform(centre);
  for (auto* lengths : {&grains.radius, &grains.position_error, &grains.radius_error})
    for (double& v : *lengths) v *= transform.scale;
  return grains;
}

Registration register_circles(const PictureGrains& from, const PictureGrains& to, const RegistrationOptions& options) {
  check(from, "first");
  check(to, "second");
  if (options.scale && !(*options.scale > 0)) throw InputError("the scale between two pictures must be positive");
  const RegistrationSearch search(from, to, options);
  Registration r;
  r.pairs = search.best(r.transform);
  const double smaller = static_cast<double>(std::min(from.size(), to.size()));
  r.matched = static_cast<double>(r.pairs.size()) / smaller;
  if (r.pairs.size() < 3 || r.matched < least_matched)
    throw refusal(
        "the grains of the two pictures do not match: at best {} of {:.0f} have a counterpart; check that both show "
        "the same sample, allow a mirrored picture, or give the scale",
        r.pairs.size(), smaller);
  for (int pass = 0; pass < 4; ++pass) r.pairs = search.refine(r.transform);
  r.matched = static_cast<double>(r.pairs.size()) / smaller;
  tell_errors(from, search, r);
  return r;
}

}  // namespace arenite::imaging
