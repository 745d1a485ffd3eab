#include "grains/texture/grain_quantities.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "core/text.hpp"
#include "grains/texture/stress.hpp"
#include "grains/texture/texture.hpp"
#include "model/matching.hpp"

namespace arenite::texture {
namespace {

using Values = std::vector<double>;

/// Of each contact, for each grain that it touches.
template <class Add> void for_each_end(const Packing& packing, Add add) {
  const Contacts& contacts = packing.contacts;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    add(static_cast<std::size_t>(contacts.i[c]), c);
    if (!contacts.is_wall(c)) add(static_cast<std::size_t>(contacts.j[c]), c);
  }
}

Values contact_numbers(const Packing& packing) {
  Values numbers(packing.grains.size(), 0.0);
  for_each_end(packing, [&](std::size_t grain, std::size_t) { ++numbers[grain]; });
  return numbers;
}

Values pressures(const Packing& packing) {
  return mapped(grain_stresses(packing), [](const Tensor2& s) { return -0.5 * trace(s); });
}

Values deviators(const Packing& packing) { return mapped(grain_stresses(packing), deviator); }

double length_of(Vec2 v) { return norm(v); }

constexpr const char *speed = "vx vy hypot", *way = "ux uy hypot";

Values ratios_of_forces(const Packing& packing) { return mobilisations(packing); }

}  // namespace

const std::vector<GrainQuantity>& grain_quantities() {
  static const std::vector<GrainQuantity> list{
      {"x", "Position along x", "x", "m", [](const Packing& p) { return mapped(p.grains.position, &Vec2::x); }},
      {"y", "Position along y", "y", "m", [](const Packing& p) { return mapped(p.grains.position, &Vec2::y); }},
      {"size", "Diameter", "d", "m",
       [](const Packing& p) { return mapped(p.grains.radius, [](double r) { return 2 * r; }); }},
      {"coordination", "Contacts", "z", "", contact_numbers},
      {"pressure", "Pressure of grains", "p", "Pa", pressures},
      {"deviator", "Deviator of grains", "q", "Pa", deviators},
      {"stress", "Stress over its mean", "\u03c3_{norm}", ""},
      {"friction", "Mean |F_{t}|/F_{n}", "|F_{t}|/F_{n}", "", ratios_of_forces},
      {"mobilisation", "Mobilised friction, mean |F_{t}|/(\u03bc\u2009F_{n})", "|F_{t}|/(\u03bc\u2009F_{n})", ""},
      {"displacement", "Displacement", "|u|", "m", nullptr, way},
      {"rotation", "Rotation", "\u03b8", "rad"},
      {"speed", "Velocity", "|v|", "m/s", [](const Packing& p) { return mapped(p.grains.velocity, length_of); }, speed},
      {"vx", "Velocity along x", "v_{x}", "m/s", [](const Packing& p) { return mapped(p.grains.velocity, &Vec2::x); }},
      {"vy", "Velocity along y", "v_{y}", "m/s", [](const Packing& p) { return mapped(p.grains.velocity, &Vec2::y); }},
      {"spin", "Angular velocity", "\u03c9", "rad/s", [](const Packing& p) { return p.grains.omega; }}};
  return list;
}

Values values_of(const Packing& packing, std::string_view name) {
  const auto& list = grain_quantities();
  const auto at = std::ranges::find(list, name, &GrainQuantity::name);
  if (at == list.end())
    throw refusal("grains have no {}; there are {}", name, list_of(mapped(list, &GrainQuantity::name), ", "));
  if (!at->of) throw refusal("the {} of grains takes more than one state", name);
  return at->of(packing);
}

Values mobilisations(const Packing& packing, std::optional<double> friction) {
  Values sum(packing.grains.size(), 0.0), count(packing.grains.size(), 0.0);
  if (friction == 0.0) return sum;
  const Contacts& contacts = packing.contacts;
  for_each_end(packing, [&](std::size_t grain, std::size_t c) {
    if (!(contacts.fn[c] > 0)) return;
    sum[grain] += std::abs(contacts.ft[c]) / contacts.fn[c];
    ++count[grain];
  });
  for (std::size_t g = 0; g < sum.size(); ++g) sum[g] /= std::max(1.0, count[g]) * friction.value_or(1);
  return sum;
}

std::vector<std::vector<Vec2>> displacements(const std::vector<Sheared>& states) {
  std::vector<std::vector<Vec2>> ways;
  for (std::size_t k = 0; k < states.size(); ++k) {
    const Grains& now = states[k].packing->grains;
    if (k == 0) {
      ways.emplace_back(now.size(), Vec2{});
      continue;
    }
    const Grains& before = states[k - 1].packing->grains;
    const std::vector<std::int32_t> places = places_in(before, now);
    const Domain& domain = states[k].packing->domain;
    const double middle = 0.5 * (domain.wall[bottom].position + domain.wall[top].position),
                 sheared = states[k].strain - states[k - 1].strain;
    std::vector<Vec2> way(now.size());
    for (std::size_t g = 0; g < now.size(); ++g) {
      if (places[g] < 0) continue;
      const auto then = static_cast<std::size_t>(places[g]);
      const Vec2 step = now.position[g] - before.position[then];
      const double up = domain.nearest_image({0, step.y}).y;
      const double affine = sheared * (before.position[then].y + 0.5 * up - middle);
      way[g] = ways.back()[then] + domain.nearest_image({step.x - affine, step.y});
    }
    ways.push_back(std::move(way));
  }
  return ways;
}

std::vector<std::vector<double>> rotations(const std::vector<const Packing*>& states) {
  std::vector<Values> turned;
  for (std::size_t k = 0; k < states.size(); ++k) {
    const Grains& now = states[k]->grains;
    turned.emplace_back(now.size(), 0.0);
    if (k == 0) continue;
    const Grains& before = states[k - 1]->grains;
    const std::vector<std::int32_t> places = places_in(before, now);
    for (std::size_t g = 0; g < now.size(); ++g) {
      if (places[g] < 0) continue;
      const auto then = static_cast<std::size_t>(places[g]);
      turned[k][g] = turned[k - 1][then] + now.angle[g] - before.angle[then];
    }
  }
  return turned;
}

}  // namespace arenite::texture
