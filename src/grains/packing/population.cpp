#include "grains/packing/population.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <type_traits>
#include <utility>
#include <variant>

#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "core/random.hpp"

namespace arenite::packing {

void Region::declare(ParameterVisitor& v) {
  v.number({"x", "Centre, from the left side.", true}, centre.x, "mm", range::not_negative);
  v.number({"y", "Centre, from the bottom.", true}, centre.y, "mm", range::not_negative);
  v.integer({"count", "Number of grains nearest to the centre, instead of a shape."}, count, {1, 100'000'000});
  v.when(!count, "no count", [&](ParameterVisitor& inner) {
    inner.choice({"shape", "Outline of the region; grains whose centre lies inside are glued."}, shape,
                 {{"circle", "of a radius"}, {"rectangle", "of width and height"}});
  });
  v.when(!count && shape == Region::Shape::circle, "shape = \"circle\"", [&](ParameterVisitor& inner) {
    inner.number({"radius", "Radius of the circle.", true}, radius, "mm", range::positive);
  });
  v.when(!count && shape == Region::Shape::rectangle, "shape = \"rectangle\"", [&](ParameterVisitor& inner) {
    inner.number({"width", "Width of the rectangle.", true}, width, "mm", range::positive);
    inner.number({"height", "Height of the rectangle.", true}, height, "mm", range::positive);
  });
}

void refuse_truncation(const UniformSizes& law, const char* name, const char* centre) {
  throw refusal(
      "from {:g} to {:g} m the {} size law has almost none of its grains; move min and max apart, around its {}",
      law.min, law.max, name, centre);
}

namespace {

/// Grains of each population; shares by largest remainder, ties to the first.
std::vector<std::int64_t> counts_of(const std::vector<Population>& populations, std::int64_t total) {
  std::vector<std::int64_t> counts(populations.size(), 0);
  std::int64_t left = total;
  double ratios = 0;
  for (std::size_t p = 0; p < populations.size(); ++p) {
    if (populations[p].count) left -= counts[p] = *populations[p].count;
    else ratios += populations[p].ratio.value_or(0);
  }
  if (ratios <= 0) return counts;
  if (left <= 0)
    throw InputError(
        "populations with a ratio have no grains to share; raise packing.grains above the sum of the counts");
  std::vector<std::pair<double, std::size_t>> remainders;
  std::int64_t given = 0;
  for (std::size_t p = 0; p < populations.size(); ++p) {
    if (populations[p].count) continue;
    const double share = static_cast<double>(left) * populations[p].ratio.value_or(0) / ratios;
    counts[p] = static_cast<std::int64_t>(std::floor(share));
    given += counts[p];
    remainders.emplace_back(share - std::floor(share), p);
  }
  std::stable_sort(remainders.begin(), remainders.end(), [](auto& a, auto& b) { return a.first > b.first; });
  for (std::size_t r = 0; given < left; ++r, ++given) ++counts[remainders[r % remainders.size()].second];
  return counts;
}

std::int32_t material_index(const Materials& materials, const std::string& name) {
  const std::size_t index = index_of(materials, name);
  if (index == materials.size()) throw refusal("population of unknown material \"{}\"; add [materials.{}]", name, name);
  return static_cast<std::int32_t>(index);
}

bool lies_inside(Vec2 from_centre, const Region& region) {
  if (region.shape == Region::Shape::circle) return dot(from_centre, from_centre) <= region.radius * region.radius;
  return std::abs(from_centre.x) <= region.width / 2 && std::abs(from_centre.y) <= region.height / 2;
}

/// Shapes of grains whose population is known, and their angles; nothing where all are disks.
void give_shapes(Grains& grains, const std::vector<Population>& populations, const std::vector<std::size_t>& population,
                 std::uint64_t seed) {
  if (std::all_of(populations.begin(), populations.end(),
                  [](const Population& p) { return std::holds_alternative<DiskShape>(p.shape); }))
    return;
  std::vector<Shape> unit;
  std::vector<double> gyration;
  for (const Population& p : populations) {
    unit.push_back(scaled_to(std::visit([](const auto& shape) { return shape.make(); }, p.shape), 1));
    gyration.push_back(gyration_of(unit.back()));
  }
  for (std::size_t g = 0; g < grains.size(); ++g) {
    Shape shape = unit[population[g]];
    for (Vec2& place : shape.place) place = grains.radius[g] * place;
    for (double& radius : shape.radius) radius *= grains.radius[g];
    if (std::holds_alternative<DiskShape>(populations[population[g]].shape)) shape.place.front() = {};
    add_shape(grains.shapes, shape, grains.radius[g] * gyration[population[g]]);
    grains.angle[g] = RandomStream(seed, Purpose::orientation, g).uniform(0, 2 * std::numbers::pi);
  }
}

constexpr std::int64_t many = 200'000;  // grains: their curve is the law's to a few thousandths
constexpr std::uint64_t seed = 1;       // no grain of a sample is drawn from it

/// A diameter of grain k of its population, m. A grading by mass is drawn as the numbers of cylinders, which weigh as
/// d^2. Spheres weigh as d^3, so that of each size 1/d as many are needed: a draw is kept as often.
template <class Law> double diameter(const Law& law, int dimension, std::int64_t k, RandomStream& random) {
  for (;;) {
    const double drawn = law.draw(k, random);
    if (dimension == 2 || !std::is_same_v<Law, SieveCurve> || drawn * random.uniform() < law.smallest()) return drawn;
  }
}

Grains draw_all(int dimension, const std::vector<Population>& populations, const Materials& materials,
                std::int64_t total, std::uint64_t seed) {
  struct Drawn {
    double radius;
    std::int32_t material;
    std::size_t population;
  };
  std::vector<Drawn> drawn;
  const auto counts = counts_of(populations, total);
  for (std::size_t p = 0; p < populations.size(); ++p) {
    const auto material = material_index(materials, populations[p].material);
    RandomStream random(seed, Purpose::radius, p);
    std::visit(
        [&](const auto& law) {
          for (std::int64_t k = 0; k < counts[p]; ++k)
            drawn.push_back({diameter(law, dimension, k, random) / 2, material, p});
        },
        populations[p].size);
  }
  if (drawn.empty())
    throw InputError("the populations hold no grains; give each a count, or ratios and packing.grains");

  RandomStream order(seed, Purpose::order);
  for (std::size_t i = drawn.size() - 1; i > 0; --i) std::swap(drawn[i], drawn[order.below(i + 1)]);
  Grains grains;
  grains.resize(drawn.size());
  std::vector<std::size_t> population;
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    grains.radius[i] = drawn[i].radius;
    grains.material[i] = drawn[i].material;
    population.push_back(drawn[i].population);
  }
  give_shapes(grains, populations, population, seed);
  return grains;
}

}  // namespace

std::vector<double> circle_radii(const Grains& grains) {
  std::vector<double> radii = grains.radius;
  for (std::size_t g = 0; g < radii.size() && !grains.shapes.empty(); ++g) radii[g] = reach_of(shape_of(grains, g));
  return radii;
}

Grains draw_grains(const std::vector<Population>& populations, const Materials& materials, std::int64_t total,
                   std::uint64_t seed) {
  return draw_all(2, populations, materials, total, seed);
}

GrainsIn<3> draw_spheres(const std::vector<Population>& populations, const Materials& materials, std::int64_t total,
                         std::uint64_t seed) {
  const Grains drawn = draw_all(3, populations, materials, total, seed);
  GrainsIn<3> spheres;
  spheres.resize(drawn.size());
  spheres.radius = drawn.radius;
  spheres.material = drawn.material;
  return spheres;
}

std::int64_t mark_region(Grains& grains, const Domain& domain, const Region& region) {
  const Vec2 centre = domain.corner() + region.centre;
  std::vector<Vec2> d(grains.size());
  for (std::size_t i = 0; i < grains.size(); ++i) d[i] = domain.nearest_image(grains.position[i] - centre);
  std::fill(grains.zone.begin(), grains.zone.end(), std::uint8_t{0});
  if (region.count) {
    const auto nearest = ordered_by(grains.size(), [&](std::size_t g) { return dot(d[g], d[g]); });
    const auto n =
        std::min<std::size_t>(nearest.size(), static_cast<std::size_t>(std::max<std::int64_t>(0, *region.count)));
    for (std::size_t k = 0; k < n; ++k) grains.zone[nearest[k]] = 1;
  } else {
    for (std::size_t i = 0; i < grains.size(); ++i) grains.zone[i] = lies_inside(d[i], region) ? 1 : 0;
  }
  return std::count(grains.zone.begin(), grains.zone.end(), std::uint8_t{1});
}

SizeCurve measured_size_curve(const Grains& grains, const Materials& materials, std::size_t most) {
  const auto order = ordered_by(grains.size(), [&](std::size_t g) { return grains.radius[g]; });
  const auto mass = [&](std::size_t g) {
    return materials[grains.material[g]].density * grains.radius[g] * grains.radius[g];
  };
  double total = 0;
  for (const std::size_t g : order) total += mass(g);
  SizeCurve curve;
  if (order.empty() || !(total > 0)) return curve;
  curve.diameter.push_back(2 * grains.radius[order.front()]);
  curve.passing.push_back(0);
  double below = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    below += mass(order[k]);
    const bool last = k + 1 == order.size(),
               wider_follows = !last && grains.radius[order[k + 1]] > grains.radius[order[k]];
    const double share = last ? 1 : below / total;
    if (!last && (!wider_follows || share < curve.passing.back() + 1 / static_cast<double>(most))) continue;
    curve.diameter.push_back(2 * grains.radius[order[k]]);
    curve.passing.push_back(share);
  }
  return curve;
}

SizeCurve asked_size_curve(const std::vector<Population>& populations, const Materials& materials, std::int64_t total,
                           std::size_t most) {
  std::int64_t counted = 0;
  for (const Population& p : populations) counted += p.count.value_or(0);
  const std::int64_t times = std::max<std::int64_t>(1, many / std::max<std::int64_t>(1, std::max(total, counted)));
  auto enlarged = populations;
  for (Population& p : enlarged)
    if (p.count) *p.count *= times;
  return measured_size_curve(draw_grains(enlarged, materials, total * times, seed), materials, most);
}

}  // namespace arenite::packing
