#include "grains/texture/grain_quantities.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/formula.hpp"
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
template <int D, class Add> void for_each_end(const PackingIn<D>& packing, Add add) {
  const ContactsIn<D>& contacts = packing.contacts;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    add(static_cast<std::size_t>(contacts.i[c]), c);
    if (!contacts.is_wall(c)) add(static_cast<std::size_t>(contacts.j[c]), c);
  }
}

template <int D> Values contact_numbers(const PackingIn<D>& packing) {
  Values numbers(packing.grains.size(), 0.0);
  for_each_end(packing, [&](std::size_t grain, std::size_t) { ++numbers[grain]; });
  return numbers;
}

template <int D> Values pressures(const PackingIn<D>& packing) {
  return mapped(grain_stresses(packing), [](const Tensor<D>& stress) { return pressure(stress); });
}
template <int D> Values deviators(const PackingIn<D>& packing) {
  return mapped(grain_stresses(packing), [](const Tensor<D>& stress) { return deviator(stress); });
}

/// Over their mean away from the border, as a stage is measured that was asked for nothing else.
template <int D> Values normalised_stresses(const PackingIn<D>& packing) {
  return grain_rows(packing).per_grain.sigma_norm;
}

double length_of(double v) { return std::abs(v); }
double length_of(Vec3 v) { return norm(v); }
/// With its sense, where a number has one.
double spin_of(double omega) { return omega; }
double spin_of(Vec3 omega) { return norm(omega); }

template <int D> Values diameters(const PackingIn<D>& p) {
  return mapped(p.grains.radius, [](double r) { return 2 * r; });
}
Values speeds(const PackingIn<3>& p) {
  return mapped(p.grains.velocity, [](Vec3 v) { return norm(v); });
}
template <int D> Values spins(const PackingIn<D>& p) {
  return mapped(p.grains.omega, [](Turning<D> omega) { return spin_of(omega); });
}
template <int D, int axis> Values places(const PackingIn<D>& p) {
  return mapped(p.grains.position, [](Vec<D> place) { return place[axis]; });
}
template <int D, int axis> Values velocities(const PackingIn<D>& p) {
  return mapped(p.grains.velocity, [](Vec<D> velocity) { return velocity[axis]; });
}

template <int D> Values mean_ratios(const PackingIn<D>& packing, std::optional<double> friction) {
  Values sum(packing.grains.size(), 0.0), count(packing.grains.size(), 0.0);
  if (friction == 0.0) return sum;
  const ContactsIn<D>& contacts = packing.contacts;
  for_each_end(packing, [&](std::size_t grain, std::size_t c) {
    if (!(contacts.fn[c] > 0)) return;
    sum[grain] += length_of(contacts.ft[c]) / contacts.fn[c];
    ++count[grain];
  });
  for (std::size_t g = 0; g < sum.size(); ++g) sum[g] /= std::max(1.0, count[g]) * friction.value_or(1);
  return sum;
}

template <int D> Values ratios_of_forces(const PackingIn<D>& packing) { return mean_ratios(packing, {}); }

template <int D> std::vector<std::vector<Vec<D>>> ways_of(const std::vector<ShearedIn<D>>& states) {
  std::vector<std::vector<Vec<D>>> ways;
  for (std::size_t k = 0; k < states.size(); ++k) {
    const GrainsIn<D>& now = states[k].packing->grains;
    if (k == 0) {
      ways.emplace_back(now.size(), Vec<D>{});
      continue;
    }
    const GrainsIn<D>& before = states[k - 1].packing->grains;
    const std::vector<std::int32_t> places = places_in(before, now);
    const DomainIn<D>& domain = states[k].packing->domain;
    const double middle = 0.5 * (domain.wall[bottom].position + domain.wall[top].position),
                 sheared = states[k].strain - states[k - 1].strain;
    std::vector<Vec<D>> way(now.size());
    for (std::size_t g = 0; g < now.size(); ++g) {
      if (places[g] < 0) continue;
      const auto then = static_cast<std::size_t>(places[g]);
      Vec<D> step = now.position[g] - before.position[then], upwards;
      upwards.y = step.y;
      const double up = domain.nearest_image(upwards).y;
      step.x -= sheared * (before.position[then].y + 0.5 * up - middle);
      way[g] = ways.back()[then] + domain.nearest_image(step);
    }
    ways.push_back(std::move(way));
  }
  return ways;
}

}  // namespace

const std::vector<GrainQuantity>& grain_quantities() {
  using enum ColourScale;
  static const std::vector<GrainQuantity> list{
      {"x", "Position along x", "x", "m", even, places<2, 0>, {}, places<3, 0>},
      {"y", "Position along y", "y", "m", even, places<2, 1>, {}, places<3, 1>},
      {"z", "Position along z", "z", "m", even, nullptr, {}, places<3, 2>},
      {"size", "Diameter", "d", "m", even, diameters<2>, {}, diameters<3>, true},
      {"coordination", "Contacts per grain", "z", "", even, contact_numbers<2>, {}, contact_numbers<3>, true},
      {"pressure", "Pressure of grains", "p", "Pa", stress, pressures<2>, {}, pressures<3>},
      {"deviator", "Deviator of grains", "q", "Pa", stress, deviators<2>, {}, deviators<3>, true},
      {"stress",
       "Stress over its mean",
       "\u03c3_{norm}",
       "",
       stress,
       normalised_stresses<2>,
       {},
       normalised_stresses<3>},
      {"friction", "Mean |F_{t}|/F_{n}", "|F_{t}|/F_{n}", "", even, ratios_of_forces<2>, {}, ratios_of_forces<3>, true},
      {.name = "mobilisation",
       .label = "Mobilised friction, mean |F_{t}|/(\u03bc\u2009F_{n})",
       .symbol = "|F_{t}|/(\u03bc\u2009F_{n})",
       .unit = "",
       .colours = stress,
       .is_magnitude = true},
      {.name = "displacement",
       .label = "Displacement since the first state",
       .symbol = "|u|",
       .unit = "m",
       .is_magnitude = true},
      {"rotation", "Rotation since the first state", "\u03b8", "rad", diverging},
      {"speed", "Velocity", "|v|", "m/s", even, nullptr, "vx vy hypot", speeds, true},
      {"vx", "Velocity along x", "v_{x}", "m/s", diverging, velocities<2, 0>, {}, velocities<3, 0>},
      {"vy", "Velocity along y", "v_{y}", "m/s", diverging, velocities<2, 1>, {}, velocities<3, 1>},
      {"vz", "Velocity along z", "v_{z}", "m/s", diverging, nullptr, {}, velocities<3, 2>},
      {"spin", "Angular velocity", "\u03c9", "rad/s", diverging, spins<2>, {}, spins<3>}};
  return list;
}

const GrainQuantity& grain_quantity(std::string_view name) {
  const auto& list = grain_quantities();
  const auto at = std::ranges::find(list, name, &GrainQuantity::name);
  if (at == list.end())
    throw refusal("grains have no {}; there are {}", name, list_of(mapped(list, &GrainQuantity::name), ", "));
  return *at;
}

Values values_of(const Packing& packing, std::string_view name) {
  const GrainQuantity& quantity = grain_quantity(name);
  if (!quantity.formula.empty())
    return evaluated(quantity.formula, packing.grains.size(),
                     [&](std::string_view part) { return values_of(packing, part); });
  if (!quantity.of && quantity.of_spheres) throw refusal("a state of disks has no {}", name);
  if (!quantity.of)
    throw refusal("a packing alone does not tell the {} of its grains, which takes {}", name,
                  name == "mobilisation" ? "the coefficient of friction" : "the states before it");
  return quantity.of(packing);
}

Values values_of(const PackingIn<3>& packing, std::string_view name) {
  const GrainQuantity& quantity = grain_quantity(name);
  if (!quantity.of_spheres) throw refusal("a state of spheres has no {}", name);
  return quantity.of_spheres(packing);
}

Values mobilisations(const Packing& packing, std::optional<double> friction) { return mean_ratios(packing, friction); }
Values mobilisations(const PackingIn<3>& packing, std::optional<double> friction) {
  return mean_ratios(packing, friction);
}

std::vector<std::vector<Vec2>> displacements(const std::vector<Sheared>& states) { return ways_of(states); }
std::vector<std::vector<Vec3>> displacements(const std::vector<ShearedIn<3>>& states) { return ways_of(states); }

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
