#include "model/cement.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/error.hpp"
#include "core/mapped.hpp"
#include "geometry/meniscus.hpp"
#include "model/periodic_images.hpp"

namespace arenite {
namespace {

using geometry::Outline;

/// Shifts of the periodic images that are looked at: the cell and its eight neighbours.
std::vector<Vec2> image_shifts(const Domain& domain) {
  std::vector<Vec2> shifts;
  for (int y = domain.periodic[1] ? -1 : 0; y <= (domain.periodic[1] ? 1 : 0); ++y)
    for (int x = domain.periodic[0] ? -1 : 0; x <= (domain.periodic[0] ? 1 : 0); ++x) shifts.push_back({x * domain.width(), y * domain.height()});
  return shifts;
}

bool reaches(Vec2 centre, double reach, const geometry::Rectangle& w) {
  return centre.x + reach > w.x_min && centre.x - reach < w.x_max && centre.y + reach > w.y_min && centre.y - reach < w.y_max;
}

struct Placer {
  const Packing& packing;
  Vec2 middle;
  std::vector<Vec2> shifts;
  PlacedCement& placed;

  void add_grain(std::size_t g) {
    const double r = packing.grains.radius[g];
    for (const Vec2 shift : shifts) {
      const Vec2 centre = packing.domain.wrapped(packing.grains.position[g]) + shift - middle;
      if (reaches(centre, r + placed.coating, placed.window)) placed.grains.push_back({centre, r, static_cast<std::int32_t>(g)});
    }
  }

  void add_neck(std::size_t i, std::size_t j, PlacedCement::Neck neck, std::vector<PlacedCement::Neck>& necks) {
    const Domain& domain = packing.domain;
    const Grains& grains = packing.grains;
    const Vec2 apart = domain.nearest_image(grains.position[j] - grains.position[i]);
    const double reach = 0.5 * norm(apart) + std::max({grains.radius[i], grains.radius[j], neck.half_a, neck.half_b});
    for (const Vec2 shift : shifts) {
      neck.a = domain.wrapped(grains.position[i]) + shift - middle;
      // Without images the second centre keeps its own digits, as the grain there does.
      neck.b = domain.is_cell() ? neck.a + apart : grains.position[j] - middle;
      neck.radius_a = grains.radius[i];
      neck.radius_b = grains.radius[j];
      if (reaches(0.5 * (neck.a + neck.b), reach, placed.window)) necks.push_back(neck);
    }
  }
};

}  // namespace

PlacedCement place(const Packing& packing, const Cement& cement, const geometry::Rectangle& window) {
  check(packing, cement);
  const Vec2 middle{0.5 * (window.x_min + window.x_max), 0.5 * (window.y_min + window.y_max)};
  PlacedCement placed;
  placed.window = {-0.5 * window.width(), 0.5 * window.width(), -0.5 * window.height(), 0.5 * window.height()};
  placed.full = cement.full;
  placed.coating = cement.coating;
  Placer placer{packing, middle, image_shifts(packing.domain), placed};
  for (std::size_t g = 0; g < packing.grains.size(); ++g) placer.add_grain(g);
  for (std::size_t k = 0; k < cement.bridges.size(); ++k) {
    const Bridge& b = cement.bridges[k];
    placer.add_neck(b.i, b.j, {{}, {}, 0, 0, b.half_i, b.half_j, 0, static_cast<std::int32_t>(k)}, placed.bridges);
  }
  for (std::size_t k = 0; k < cement.menisci.size(); ++k) {
    const Meniscus& m = cement.menisci[k];
    placer.add_neck(m.i, m.j, {{}, {}, 0, 0, 0, 0, m.radius, static_cast<std::int32_t>(k)}, placed.menisci);
  }
  return placed;
}

void check(const Packing& packing, const Cement& cement) {
  std::vector<Problem> problems;
  const auto report = [&](std::string message) {
    if (problems.size() < 20) problems.push_back({{}, 0, 0, std::move(message)});
  };
  const Grains& g = packing.grains;
  if (packing.domain.tilt != 0) report(fmt::format("the periodic cell is sheared by {:g} m; cement and grid need an upright one", packing.domain.tilt));
  for (std::size_t i = 0; i < g.size(); ++i)
    if (!is_finite(g.position[i]) || !(g.radius[i] > 0) || !std::isfinite(g.radius[i]))
      report(fmt::format("grain {} has centre ({:g}, {:g}) m and radius {:g} m; give finite numbers and a positive radius", i, g.position[i].x, g.position[i].y,
                         g.radius[i]));
  const auto pair = [&](const char* what, std::size_t k, std::int32_t i, std::int32_t j) {
    const auto n = static_cast<std::int32_t>(g.size());
    if (i < 0 || j < 0 || i >= n || j >= n || i == j) report(fmt::format("{} {} joins grains {} and {}; give two of the {} grains", what, k, i, j, n));
  };
  if (!(cement.coating >= 0) || !std::isfinite(cement.coating)) report(fmt::format("the coating is {:g} m thick; give a length of at least 0", cement.coating));
  for (std::size_t k = 0; k < cement.bridges.size(); ++k) {
    const Bridge& b = cement.bridges[k];
    pair("bridge", k, b.i, b.j);
    if (!(b.half_i >= 0 && b.half_j >= 0 && std::isfinite(b.half_i) && std::isfinite(b.half_j)))
      report(fmt::format("bridge {} has half bases {:g} and {:g} m; give lengths of at least 0", k, b.half_i, b.half_j));
  }
  for (std::size_t k = 0; k < cement.menisci.size(); ++k) {
    pair("meniscus", k, cement.menisci[k].i, cement.menisci[k].j);
    if (!(cement.menisci[k].radius > 0)) report(fmt::format("meniscus {} has radius {:g} m; give a positive one", k, cement.menisci[k].radius));
  }
  if (!problems.empty()) throw InputError(std::move(problems));
}

std::vector<Outline> grain_outlines(const PlacedCement& placed) {
  return mapped(placed.grains, [](const auto& g) { return Outline::disk(g.centre, g.radius); });
}

std::vector<Outline> matrix_outlines(const PlacedCement& placed) {
  std::vector<Outline> outlines;
  if (placed.coating > 0)
    for (const auto& g : placed.grains) outlines.push_back(Outline::disk(g.centre, g.radius + placed.coating));
  for (const auto& b : placed.bridges) add_bridge_outline(b, outlines);
  for (const auto& m : placed.menisci) add_meniscus_outlines(m, outlines);
  return outlines;
}

void add_bridge_outline(const PlacedCement::Neck& j, std::vector<Outline>& outlines) {
  const Vec2 d = j.b - j.a;
  const double length = norm(d);
  if (length == 0 || (j.half_a == 0 && j.half_b == 0)) return;
  const Vec2 up = (1 / length) * perpendicular(d);
  outlines.push_back({Outline::Kind::quadrilateral, {j.a - j.half_a * up, j.b - j.half_b * up, j.b + j.half_b * up, j.a + j.half_a * up}, {}, 0});
}

void add_meniscus_outlines(const PlacedCement::Neck& m, std::vector<Outline>& outlines) {
  const Vec2 d = m.b - m.a;
  const auto shape = geometry::meniscus_shape({m.radius_a, m.radius_b, norm(d)}, m.arc);
  if (!shape) return;
  const Vec2 along = (1 / shape->length) * d, up = perpendicular(along);
  for (const double side : {1.0, -1.0}) {
    const auto at = [&](Vec2 p) { return m.a + p.x * along + (side * p.y) * up; };
    const Vec2 touch_a = at(shape->touch_i), touch_b = at(shape->touch_j);
    Outline half{shape->radius > 0 ? Outline::Kind::hollow : Outline::Kind::quadrilateral, {}, at(shape->centre), shape->radius};
    half.corner = side > 0 ? std::array{m.a, m.b, touch_b, touch_a} : std::array{m.b, m.a, touch_a, touch_b};
    outlines.push_back(half);
  }
}

}  // namespace arenite
