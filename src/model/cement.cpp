#include "model/cement.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/problems.hpp"
#include "geometry/meniscus.hpp"
#include "model/periodic_images.hpp"

namespace arenite {

using geometry::Outline;

PlacedCement place(const Packing& packing, const Cement& cement, const geometry::Rectangle& window) {
  check(packing, cement);
  const Domain& domain = packing.domain;
  const std::vector<Vec2>& position = packing.grains.position;
  const std::vector<double>& radius = packing.grains.radius;
  const Vec2 middle = window.middle();
  const double half_width = 0.5 * window.width(), half_height = 0.5 * window.height();
  PlacedCement placed{{-half_width, half_width, -half_height, half_height}, {}, {}, cement.full, cement.coating};
  for (std::size_t g = 0; g < position.size(); ++g) {
    const Vec2 at = domain.wrapped(position[g]);
    for_each_image(domain, geometry::square_about(at, radius[g] + cement.coating), window,
                   [&](const ImageShift& image) {
                     placed.grains.push_back({at + image.shift - middle, radius[g], static_cast<std::int32_t>(g)});
                   });
  }
  const auto add_neck = [&](std::int32_t i, std::int32_t j, double half_i, double half_j, double arc) {
    const Vec2 at = domain.wrapped(position[i]), apart = domain.nearest_image(position[j] - position[i]);
    const double reach = 0.5 * norm(apart) + std::max({radius[i], radius[j], half_i, half_j});
    for_each_image(domain, geometry::square_about(at + 0.5 * apart, reach), window, [&](const ImageShift& image) {
      const Vec2 a = at + image.shift - middle;
      // Without images the second centre keeps its own digits, as the grain there does.
      placed.necks.push_back(
          {a, domain.is_cell() ? a + apart : position[j] - middle, radius[i], radius[j], half_i, half_j, arc});
    });
  };
  for (const Bridge& b : cement.bridges) add_neck(b.i, b.j, b.half_i, b.half_j, 0);
  for (const Meniscus& m : cement.menisci) add_neck(m.i, m.j, 0, 0, m.radius);
  return placed;
}

void check(const Packing& packing, const Cement& cement) {
  Problems problems;
  const Grains& g = packing.grains;
  const auto n = static_cast<std::int32_t>(g.size());
  problems.unless(packing.domain.tilt == 0,
                  "the periodic cell is sheared by {:g} m; cement and grid need a rectangular one",
                  packing.domain.tilt);
  for (std::size_t i = 0; i < g.size(); ++i)
    problems.unless(is_finite(g.position[i]) && g.radius[i] > 0 && std::isfinite(g.radius[i]),
                    "grain {} has centre ({:g}, {:g}) m and radius {:g} m; give finite numbers and a positive radius",
                    i, g.position[i].x, g.position[i].y, g.radius[i]);
  const auto pair = [&](const char* what, std::size_t k, std::int32_t i, std::int32_t j) {
    problems.unless(i >= 0 && j >= 0 && i < n && j < n && i != j,
                    "{} {} joins grains {} and {}; give two of the {} grains", what, k, i, j, n);
  };
  problems.unless(cement.coating >= 0 && std::isfinite(cement.coating),
                  "the coating is {:g} m thick; give a length of at least 0", cement.coating);
  for (std::size_t k = 0; k < cement.bridges.size(); ++k) {
    const Bridge& b = cement.bridges[k];
    pair("bridge", k, b.i, b.j);
    problems.unless(b.half_i >= 0 && b.half_j >= 0 && std::isfinite(b.half_i) && std::isfinite(b.half_j),
                    "bridge {} has half bases {:g} and {:g} m; give lengths of at least 0", k, b.half_i, b.half_j);
  }
  for (std::size_t k = 0; k < cement.menisci.size(); ++k) {
    pair("meniscus", k, cement.menisci[k].i, cement.menisci[k].j);
    problems.unless(cement.menisci[k].radius > 0, "meniscus {} has radius {:g} m; give a positive one", k,
                    cement.menisci[k].radius);
  }
  problems.raise();
}

std::vector<Outline> outlines_of(const PlacedCement::Neck& neck) {
  const auto& [a, b, radius_a, radius_b, half_a, half_b, arc] = neck;
  const Vec2 d = b - a;
  if (d == Vec2{} || (arc == 0 && half_a == 0 && half_b == 0)) return {};
  const Vec2 along = (1 / norm(d)) * d, up = perpendicular(along);
  if (arc == 0)
    return {
        {Outline::Kind::quadrilateral, {a - half_a * up, b - half_b * up, b + half_b * up, a + half_a * up}, {}, 0}};
  const auto shape = geometry::meniscus_shape({radius_a, radius_b, norm(d)}, arc);
  std::vector<Outline> halves;
  for (const double side : {1.0, -1.0}) {
    if (!shape) break;
    const auto at = [&](Vec2 p) { return neck.a + p.x * along + (side * p.y) * up; };
    const Vec2 touch_a = at(shape->touch_i), touch_b = at(shape->touch_j);
    Outline half{
        shape->radius > 0 ? Outline::Kind::hollow : Outline::Kind::quadrilateral, {}, at(shape->centre), shape->radius};
    half.corner = side > 0 ? std::array{a, b, touch_b, touch_a} : std::array{b, a, touch_a, touch_b};
    halves.push_back(half);
  }
  return halves;
}

}  // namespace arenite
