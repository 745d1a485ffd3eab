#include "workflow/predict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <numbers>
#include <utility>

#include "core/error.hpp"
#include "core/root.hpp"
#include "grains/dem/coefficients.hpp"
#include "grains/dem/engine.hpp"
#include "grains/dem/run_stage.hpp"
#include "grains/texture/texture.hpp"
#include "workflow/run.hpp"

namespace arenite::workflow {

double collision_time(double reduced_mass, double stiffness) { return std::numbers::pi * std::sqrt(reduced_mass / stiffness); }

double inertial_number(double rate, double diameter, double density, double pressure) { return std::abs(rate) * diameter * std::sqrt(density / pressure); }

std::string_view flow_regime(double number) { return number < 1e-3 ? "quasi-static" : number <= 0.1 ? "dense flow" : "inertial"; }

double overlap_under(const dem::NormalLaw& law, double stiffness, double diameter, double force) {
  const auto excess = [&](double h) {
    double memory = 0;
    return std::visit([&](const auto& normal) { return normal.elastic(h, stiffness, 4 / diameter, memory); }, law) - force;
  };
  const double most = excess(diameter);
  return most <= 0 ? diameter : bracketed_root<double>(excess, 0, -force, diameter, most);
}

double stiffness_number(const dem::NormalLaw& law, double stiffness, double diameter, double thickness, double pressure) {
  return diameter / overlap_under(law, stiffness, diameter, pressure * thickness * diameter);
}

double slowest_period(double mass, double stiffness) { return 4 * std::sqrt(mass / stiffness); }

double settling_time(double period, double drag, double unbalanced, bool pressed_all_round) {
  const double periods = pressed_all_round ? 1.0 : 4.5;
  return std::log(1 / unbalanced) / (1 / (periods * period) + 0.5 * drag);
}

namespace {

/// As the engine bounds it: Hertz contacts count as stiff as at an overlap of 2 %.
double tangent(const dem::ContactParameters& contact, double stiffness) {
  return std::visit([&](const auto& law) { return law.tangent(0.02, stiffness, 1.0); }, contact.normal);
}

}  // namespace

ShortestCollision shortest_collision(const Packing& packing, const dem::ContactParameters& contact) {
  const dem::CoefficientTable table(packing.materials, packing.grains, contact);
  ShortestCollision shortest;
  for (std::size_t k = 0; k < packing.grains.size(); ++k) {
    const std::int32_t material = packing.grains.material[k];
    const double mass = texture::mass_of(packing, k), radius = packing.grains.radius[k];
    const double pair = collision_time(0.5 * mass, tangent(contact, table.pair_stiffness(material, material, radius, radius)));
    const double wall = collision_time(mass, tangent(contact, table.wall_stiffness(material, radius)));
    if (const double time = std::min(pair, wall); shortest.time == 0 || time < shortest.time) shortest = {time, radius, material, wall < pair};
  }
  return shortest;
}

namespace {

/// A sample as a whole.
struct Bulk {
  double diameter = 0;  ///< mean, m
  double density = 0;   ///< of the grains, kg/m^3
  double solid_fraction = 0;
  double stiffness = 0;  ///< of the softest pair of its materials, N/m
  double width = 0, height = 0, thickness = 0;
  double larger = 1;  ///< how much wider it is than the sample that was made
};

Bulk bulk_of(const Packing& packing, const dem::ContactParameters& contact) {
  const Grains& g = packing.grains;
  Bulk bulk{0, 0, 0, 0, packing.domain.width(), packing.domain.height(), packing.domain.thickness, 1};
  double mass = 0, area = 0;
  for (std::size_t k = 0; k < g.size(); ++k) {
    mass += texture::mass_of(packing, k);
    area += std::numbers::pi * g.radius[k] * g.radius[k];
    bulk.diameter += 2 * g.radius[k] / static_cast<double>(g.size());
  }
  bulk.density = mass / (area * bulk.thickness);
  bulk.solid_fraction = area / packing.domain.area();
  const dem::CoefficientTable table(packing.materials, g, contact);
  const auto there = [&](std::size_t m) { return std::find(g.material.begin(), g.material.end(), static_cast<int>(m)) != g.material.end(); };
  for (std::size_t a = 0; a < packing.materials.size(); ++a)
    for (std::size_t b = 0; b <= a; ++b)
      if (there(a) && there(b)) {
        const double k = table.pair_stiffness(static_cast<int>(a), static_cast<int>(b), bulk.diameter / 2, bulk.diameter / 2);
        bulk.stiffness = bulk.stiffness == 0 ? k : std::min(bulk.stiffness, k);
      }
  return bulk;
}

using Kind = dem::SideDrive::Kind;

/// What a side does at its most.
double largest_drive(const dem::Stage& stage, std::size_t side) {
  double value = stage.side[side].value;
  for (const dem::Programme& programme : stage.programmes)
    if (programme.drives_side() && programme.side() == static_cast<int>(side))
      for (const Vec2& row : programme.table) value = std::max(value, std::abs(row.y));
  return value;
}

/// Along x (axis 0) or y (1): Pa, the larger of what its two sides press with; 0 where none presses.
double pressure_along(const dem::Stage& stage, const Bulk& bulk, std::size_t axis) {
  const double loaded = (axis == 0 ? bulk.height : bulk.width) * bulk.thickness;
  double pressure = 0;
  for (std::size_t side = 2 * axis; side < 2 * axis + 2; ++side) {
    const dem::SideDrive& drive = stage.side[side];
    if (drive.kind == Kind::pressure) pressure = std::max(pressure, largest_drive(stage, side));
    if (drive.kind == Kind::force) pressure = std::max(pressure, largest_drive(stage, side) / loaded);
    if (drive.kind == Kind::force && stage.cycles && stage.cycles->side == side_names[side]) pressure = std::max(pressure, stage.cycles->max / loaded);
  }
  return pressure;
}

/// Pa; what the grains of half the height weigh.
double weight(const dem::Stage& stage, const Bulk& bulk) {
  return stage.gravity ? 0.5 * bulk.solid_fraction * bulk.density * stage.gravity_size * bulk.height : 0;
}

/// 1/s; what closes the sample.
double closing_rate(const dem::Stage& stage, const Bulk& bulk) {
  double rate = 0;
  for (std::size_t side = 0; side < 4; ++side)
    if (stage.side[side].kind == Kind::velocity) rate = std::max(rate, std::abs(largest_drive(stage, side)) / (side < 2 ? bulk.width : bulk.height));
  return rate;
}

/// 1/s; what shears it.
double shear_rate(const dem::Stage& stage, const Bulk& bulk) {
  const double across = std::abs(stage.slide[right] - stage.slide[left]) / bulk.width;
  const double along = std::abs(stage.slide[top] - stage.slide[bottom]) / bulk.height;
  double rate = std::max({std::abs(stage.shear_rate), across, along});
  if (stage.strain_cycles) rate = std::max(rate, stage.strain_cycles->rate);
  for (const dem::Programme& programme : stage.programmes)
    if (programme.of == dem::Programme::shear_rate)
      for (const Vec2& row : programme.table) rate = std::max(rate, std::abs(row.y));
  return rate;
}

/// The pressures of a stage, Pa: the largest, and the one that confines it. Sides that only move or stand keep what the stage before left.
struct Pressures {
  double largest = 0, confining = 0;
};

Pressures pressures_of(const dem::Stage& stage, const Bulk& bulk, const Pressures& before) {
  const double x = pressure_along(stage, bulk, 0), y = pressure_along(stage, bulk, 1), w = weight(stage, bulk);
  if (x == 0 && y == 0) return w > 0 ? Pressures{w, w} : before;
  return {std::max({x, y, w}), std::max(x > 0 && y > 0 ? std::min(x, y) : x + y, w)};
}

/// Time in which a loose sample is pressed together, s: its sides come in at some 2 I sqrt(F H/M) (dem/walls.hpp; measured on examples/01 and 05).
/// `bulk` is then as dense as that leaves it.
double closing_time(const dem::Stage& stage, const Pressures& pressures, bool without_friction, Bulk& bulk) {
  const double dense = without_friction ? 0.84 : 0.81;  // random packings of disks, with little and with some friction
  const bool x = pressure_along(stage, bulk, 0) > 0, y = pressure_along(stage, bulk, 1) > 0;
  if ((!x && !y && !stage.gravity) || bulk.solid_fraction >= dense) return 0;
  const double rest = x && y ? std::sqrt(bulk.solid_fraction / dense) : bulk.solid_fraction / dense;
  const double speed = 2 * stage.inertial_number * std::sqrt(pressures.largest / (bulk.solid_fraction * bulk.density));
  const double way = (1 - rest) * std::max(x ? bulk.width : 0.0, y || !x ? bulk.height : 0.0);
  if (x) bulk.width *= rest;
  if (y || !x) bulk.height *= rest;
  bulk.solid_fraction = dense;
  return way / (x || y ? speed : std::sqrt(stage.gravity_size * way));
}

StagePrediction predict_stage(dem::Engine& engine, const recipe::Recipe& recipe, const dem::Stage& stage, Bulk& bulk, Pressures& pressures) {
  dem::begin_stage(engine, stage);
  StagePrediction p;
  p.name = stage.name;
  p.time_step = engine.time_step();
  pressures = pressures_of(stage, bulk, pressures);
  p.pressure = pressures.largest;
  if (p.pressure > 0) {
    p.stiffness_number = stiffness_number(recipe.contact.normal, bulk.stiffness, bulk.diameter, bulk.thickness, p.pressure);
    p.overlap = 1 / *p.stiffness_number;
  }
  if (const double rate = std::max(closing_rate(stage, bulk), shear_rate(stage, bulk)); rate > 0 && pressures.confining > 0)
    p.inertial_number = inertial_number(rate, bulk.diameter, bulk.density, pressures.confining);
  p.exact = stage.duration || stage.strain_cycles;
  if (p.exact) {
    p.duration = stage.duration.value_or(0);
    for (std::int64_t half = 0; half < dem::increment_count(stage) && stage.strain_cycles; ++half)
      p.duration += static_cast<double>(dem::strain_half(*stage.strain_cycles, half, p.time_step).steps) * p.time_step;
    p.steps = dem::steps_of(p.duration, p.time_step);
    return p;
  }
  const double critical = engine.critical_drag() / bulk.larger;
  const double drag = recipe.integration.drag + stage.drag + stage.critical_drag * critical;
  const auto increments = static_cast<double>(dem::increment_count(stage));
  const bool without_friction = stage.friction.value_or(recipe.contact.friction) < 0.05;
  const bool all_round =
      std::all_of(stage.side.begin(), stage.side.end(), [](const auto& side) { return side.kind == Kind::force || side.kind == Kind::pressure; });
  const double settling = settling_time(4 * std::numbers::pi / critical, drag, stage.equilibrium.unbalanced, all_round);
  p.duration = closing_time(stage, pressures, without_friction, bulk) + increments * settling;
  p.steps = dem::steps_of(p.duration, p.time_step);
  return p;
}

/// Processor's seconds that a step will take, from some hundred at the begin of the first stage.
double measured_step(dem::Engine& engine, const dem::Stage& stage) {
  dem::StageRun run = dem::begin_stage(engine, stage);
  dem::continue_stage(engine, stage, run);  // warms up
  const std::int64_t first = engine.step();
  const std::clock_t began = std::clock();
  const auto seconds = [&] { return static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC; };
  for (int round = 0; round < 20 && !run.finished && seconds() < 0.2; ++round) dem::continue_stage(engine, stage, run);
  const std::int64_t steps = engine.step() - first;
  constexpr double dense = 1.25;  // a sample under load has more contacts (measured on examples/01 and 05)
  return steps > 0 ? dense * seconds() / static_cast<double>(steps) : 0;
}

StepLimit limit_of(const dem::Engine& engine, const recipe::Recipe& recipe, double collision) {
  if (recipe.integration.time_step) return StepLimit::given;
  if (engine.time_step() > 0.999 * recipe.integration.safety * collision) return StepLimit::collision;
  const dem::StepBounds bounds = engine.bounds();
  return bounds.damping < bounds.stiffness ? StepLimit::damping : StepLimit::stiffness;
}

constexpr std::size_t most_grains = 20'000, few_grains = 4'000;

/// Of the recipe, before anything is made; 0 where only its file knows.
std::size_t count_of(const recipe::Recipe& recipe) {
  if (recipe.packing.method == recipe::PackingParameters::Method::file) return 0;
  if (recipe.bidisperse) {
    const auto& law = recipe.bidisperse->law;
    constexpr double solid = 0.6;  // about what the sampling reaches
    const double large = solid * law.box_area * law.volume_ratio / (1 + law.volume_ratio);
    return static_cast<std::size_t>(large * (1 + law.size_ratio * law.size_ratio / law.volume_ratio));
  }
  std::int64_t sum = 0;
  bool shares = false;
  for (const auto& population : recipe.populations) {
    sum += population.count.value_or(0);
    shares |= population.ratio.has_value();
  }
  return static_cast<std::size_t>(std::max(sum, shares ? recipe.packing.grains : 0));
}

/// The same with fewer grains in a frame that is smaller alike.
recipe::Recipe with_fewer(recipe::Recipe recipe, double share) {
  if (recipe.bidisperse) recipe.bidisperse->law.box_area *= share;
  const auto fewer = [share](std::int64_t count) { return std::max<std::int64_t>(1, std::llround(share * static_cast<double>(count))); };
  for (auto& population : recipe.populations)
    if (population.count) population.count = fewer(*population.count);
  recipe.packing.grains = fewer(recipe.packing.grains);
  recipe.container.width *= std::sqrt(share);
  recipe.container.height *= std::sqrt(share);
  return recipe;
}

void warn(Prediction& p, const recipe::Recipe& recipe) {
  constexpr double tiny = 0.01;
  if (p.time_step < tiny * p.collision.time)
    p.warnings.push_back(fmt::format("a collision takes {:.0f} steps; a tenth of its duration as the step would do{}", p.collision.time / p.time_step,
                                     p.limit == StepLimit::damping ? ", and damping forbids it: weaker dashpots or less drag" : ""));
  for (std::size_t s = 0; s < p.stages.size(); ++s) {
    const StagePrediction& stage = p.stages[s];
    if (stage.overlap && *stage.overlap > 0.01)
      p.warnings.push_back(fmt::format("stage {}: grains overlap by some {:.2g} % of their diameter (k/P = {:.3g}); they are hard above 1e4", stage.name,
                                       100 * *stage.overlap, *stage.stiffness_number));
    const auto& sides = recipe.stages[s].side;
    const bool closes = std::any_of(sides.begin(), sides.end(), [](const auto& side) { return side.kind == Kind::velocity; });
    if (stage.inertial_number && *stage.inertial_number > 0.1 && closes)
      p.warnings.push_back(fmt::format("stage {}: I = {:.2g}: it is deformed faster than grains can make way; below 1e-3 it would be quasi-static", stage.name,
                                       *stage.inertial_number));
    if (const double each = static_cast<double>(stage.steps) / static_cast<double>(dem::increment_count(recipe.stages[s]));
        !stage.exact && each > static_cast<double>(recipe.stages[s].equilibrium.max_steps))
      p.warnings.push_back(
          fmt::format("stage {}: an increment may need more than equilibrium.max_steps = {}", stage.name, recipe.stages[s].equilibrium.max_steps));
  }
}

}  // namespace

double Prediction::seconds() const {
  double sum = 0;
  for (const StagePrediction& stage : stages) sum += stage.seconds;
  return sum;
}

Prediction predict(const recipe::Recipe& recipe) {
  Prediction p;
  const std::size_t expected = count_of(recipe);
  const double share = expected > most_grains ? static_cast<double>(few_grains) / static_cast<double>(expected) : 1.0;
  const Packing start = make_packing(share < 1 ? with_fewer(recipe, share) : recipe).frames.back().packing;
  p.sample = start.grains.size();
  p.grains = share < 1 ? expected : p.sample;
  dem::Engine engine(start, recipe.contact, recipe.integration);
  p.time_step = engine.time_step();
  p.largest_step = engine.bounds().largest();
  p.collision = shortest_collision(start, recipe.contact);
  p.material = start.materials[static_cast<std::size_t>(p.collision.material)].name;
  p.limit = limit_of(engine, recipe, p.collision.time);
  Bulk bulk = bulk_of(start, recipe.contact);
  bulk.larger = 1 / std::sqrt(share);
  bulk.width *= bulk.larger;
  bulk.height *= bulk.larger;
  Pressures pressures;
  for (const dem::Stage& stage : recipe.stages) p.stages.push_back(predict_stage(engine, recipe, stage, bulk, pressures));
  if (recipe.stages.empty()) return p;
  try {
    dem::Engine timed(start, recipe.contact, recipe.integration);
    p.seconds_per_step = measured_step(timed, recipe.stages.front()) / share;
  } catch (const CannotGoOn& error) { p.warnings.push_back(fmt::format("stage {}: {}", recipe.stages.front().name, error.what())); }
  for (StagePrediction& stage : p.stages) stage.seconds = p.seconds_per_step * static_cast<double>(stage.steps);
  warn(p, recipe);
  return p;
}

}  // namespace arenite::workflow
