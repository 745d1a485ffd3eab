#include "grains/fields/regime/prediction.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <variant>

#include "core/problems.hpp"
#include "core/root.hpp"
#include "grains/dem/bounds.hpp"
#include "grains/dem/coefficients.hpp"
#include "grains/dem/engine.hpp"
#include "grains/dem/exchange/traffic.hpp"
#include "grains/dem/run_stage.hpp"
#include "grains/fields/regime/coming_to_rest.hpp"

namespace arenite::fields {

double collision_time(double reduced_mass, double stiffness) {
  return std::numbers::pi * std::sqrt(reduced_mass / stiffness);
}

double inertial_number(double rate, double diameter, double density, double pressure) {
  return std::abs(rate) * diameter * std::sqrt(density / pressure);
}

std::string_view flow_regime(double number) {
  return number < 1e-3 ? "quasi-static" : number <= 0.1 ? "dense flow" : "inertial";
}

double overlap_under(const dem::NormalLaw& law, double stiffness, double diameter, double force) {
  const auto excess = [&](double h) {
    double memory = 0;
    return std::visit([&](const auto& normal) { return normal.elastic(h, stiffness, 4 / diameter, memory); }, law) -
           force;
  };
  const double most = excess(diameter);
  return most <= 0 ? diameter : bracketed_root<double>(excess, 0, -force, diameter, most);
}

double stiffness_number(const dem::NormalLaw& law, double stiffness, double diameter, double thickness,
                        double pressure) {
  return diameter / overlap_under(law, stiffness, diameter, pressure * thickness * diameter);
}

double time_asked(const dem::Stage& stage) {
  if (!stage.strain_cycles) return stage.duration.value_or(0);
  const dem::StrainCycles& cycles = *stage.strain_cycles;
  return 2 * static_cast<double>(cycles.count) * (cycles.max - cycles.min) / cycles.rate;
}

std::string too_many_steps(const dem::Stage& stage, double time_step) {
  const double time = time_asked(stage), steps = time / time_step;
  if (steps <= most_steps) return {};
  return fmt::format("{:.3g} s are {:.2g} steps of {:.3g} s, more than can be counted; shorten the stage{}", time,
                     steps, time_step, stage.strain_cycles ? ": fewer cycles or a higher rate" : "");
}

namespace {

using Kind = dem::SideDrive::Kind;

/// The largest of a value and of what the programmes that `drive` it make of it.
template <class Drive> double largest(const dem::Stage& stage, double value, Drive drive) {
  for (const dem::Programme& programme : stage.programmes)
    if (drive(programme))
      for (const Vec2& row : programme.table) value = std::max(value, std::abs(row.y));
  return value;
}

/// What a side does at its most.
double largest_drive(const dem::Stage& stage, std::size_t side) {
  return largest(stage, stage.side[side].value,
                 [&](const auto& p) { return p.of.is_of_side() && p.of.side == static_cast<int>(side); });
}

/// Along x (axis 0) or y (1): Pa, the larger of what its two sides press with; 0 where none presses.
double pressure_along(const dem::Stage& stage, const Bulk& bulk, std::size_t axis) {
  const double loaded = (axis == 0 ? bulk.height : bulk.width) * bulk.thickness;
  double pressure = 0;
  for (std::size_t side = 2 * axis; side < 2 * axis + 2; ++side) {
    const dem::SideDrive& drive = stage.side[side];
    if (drive.kind == Kind::pressure || drive.is_skin()) pressure = std::max(pressure, largest_drive(stage, side));
    if (drive.kind == Kind::force) pressure = std::max(pressure, largest_drive(stage, side) / loaded);
    if (stage.cycles && stage.cycles->side == static_cast<int>(side))
      pressure = std::max(pressure, stage.cycles->max / (stage.cycles->of_pressure ? 1 : loaded));
  }
  return pressure;
}

/// Pa; what the grains of half the height weigh.
double weight(const dem::Stage& stage, const Bulk& bulk) {
  return stage.gravity ? 0.5 * bulk.solid_fraction * bulk.density * stage.gravity_size * bulk.height : 0;
}

/// 1/s; difference of the principal strain rates where sides close the sample, which yields where sides press across.
double closing_rate(const dem::Stage& stage, const Bulk& bulk) {
  double rate = 0;
  for (int side = 0; side < sides; ++side) {
    if (stage.side[side].kind != Kind::velocity) continue;
    const double own = std::abs(largest_drive(stage, side)) / (side < 2 ? bulk.width : bulk.height);
    rate = std::max(rate, pressure_along(stage, bulk, 1 - side / 2) > 0 ? 2 * own : own);
  }
  return rate;
}

/// 1/s; what shears it.
double shear_rate(const dem::Stage& stage, const Bulk& bulk) {
  const double across = std::abs(stage.slide[right] - stage.slide[left]) / bulk.width;
  const double along = std::abs(stage.slide[top] - stage.slide[bottom]) / bulk.height;
  double rate = std::max({std::abs(stage.shear_rate), across, along});
  if (stage.strain_cycles) rate = std::max(rate, stage.strain_cycles->rate);
  return largest(stage, rate, [](const auto& p) { return p.of.is(dem::Programme::What::shear_rate); });
}

/// What a stage that lasts so long strains its sample by: shear, or the larger closing of an axis, which the bulk then
/// has. Programmes are not followed.
std::optional<double> strain_over(double duration, const dem::Stage& stage, Bulk& bulk) {
  if (!stage.programmes.empty() || stage.strain_cycles) return {};
  if (const double rate = shear_rate(stage, bulk); rate > 0) return rate * duration;
  std::optional<double> strain;
  for (int axis = 0; axis < 2; ++axis) {
    double speed = 0;
    for (int side = 2 * axis; side < 2 * axis + 2; ++side)
      if (stage.side[side].kind == Kind::velocity) speed += stage.side[side].value;
    double& length = axis == 0 ? bulk.width : bulk.height;
    const double closed = speed * duration / length;
    if (speed == 0) continue;
    length = std::max(length * (1 - closed), 0.0);
    if (!strain || std::abs(closed) > std::abs(*strain)) strain = closed;
  }
  return strain;
}

Pressures pressures_of(const dem::Stage& stage, const Bulk& bulk, const Pressures& before) {
  const double x = pressure_along(stage, bulk, 0), y = pressure_along(stage, bulk, 1), w = weight(stage, bulk);
  if (x == 0 && y == 0) return w > 0 ? Pressures{w, w} : before;
  return {std::max({x, y, w}), std::max(x > 0 && y > 0 ? std::min(x, y) : x + y, w)};
}

/// As the engine bounds it before grains overlap.
double tangent(const dem::ContactParameters& contact, double stiffness) {
  return std::visit([&](const auto& law) { return law.tangent(dem::reference_share, stiffness, 1.0); }, contact.normal);
}

}  // namespace

Bulk bulk_of(const Packing& packing, const dem::ContactParameters& contact) {
  const Grains& g = packing.grains;
  Bulk bulk{0, 0, 0, 0, packing.domain.width(), packing.domain.height(), packing.domain.thickness, 1};
  bulk.diameter = g.mean_diameter();
  bulk.density = mean_density(packing);
  bulk.solid_fraction = g.area() / packing.domain.area();
  const dem::CoefficientTable table(packing.materials, g.material, contact);
  const auto there = [&](std::size_t m) {
    return std::find(g.material.begin(), g.material.end(), static_cast<int>(m)) != g.material.end();
  };
  for (std::size_t a = 0; a < packing.materials.size(); ++a)
    for (std::size_t b = 0; b <= a; ++b)
      if (there(a) && there(b)) {
        const auto mean_grain = [&](std::size_t material) {
          return dem::DiskRecord{.radius = bulk.diameter / 2, .material = static_cast<int>(material)};
        };
        const double k = table.pair_stiffness(mean_grain(a), mean_grain(b));
        bulk.stiffness = bulk.stiffness == 0 ? k : std::min(bulk.stiffness, k);
      }
  return bulk;
}

namespace {

StagePrediction of_stage(const dem::Engine& engine, const dem::ContactParameters& contact, double steady_drag,
                         const dem::Stage& stage, Bulk& bulk, Pressures& pressures) {
  StagePrediction p;
  p.name = stage.name;
  p.time_step = engine.dt;
  pressures = pressures_of(stage, bulk, pressures);
  p.pressure = pressures.largest;
  if (p.pressure > 0) {
    p.stiffness_number = stiffness_number(contact.normal, bulk.stiffness, bulk.diameter, bulk.thickness, p.pressure);
    p.overlap = 1 / *p.stiffness_number;
  }
  if (const double rate = std::max(closing_rate(stage, bulk), shear_rate(stage, bulk));
      rate > 0 && pressures.confining > 0)
    p.inertial_number = inertial_number(rate, bulk.diameter, bulk.density, pressures.confining);
  p.exact = stage.duration || stage.strain_cycles;
  if (p.exact) {
    count_steps(p, stage);
    p.strain = strain_over(p.duration, stage, bulk);
    p.inserted = dem::grains_due(engine, stage.exchange, p.duration);
    return p;
  }
  const double critical = critical_drag(engine) / bulk.larger;
  const double settling = settling_time(stage, std::span(stage.side).first<sides>(), critical, steady_drag);
  const Closing closing{.along_x = pressure_along(stage, bulk, 0) > 0,
                        .along_y = pressure_along(stage, bulk, 1) > 0,
                        .pressure = pressures.largest,
                        .without_friction = stage.friction.value_or(contact.friction) < 0.05};
  count_steps(p, stage, closing_time(stage, closing, bulk), settling);
  return p;
}

}  // namespace

StagePrediction predict_stage(const dem::Engine& engine, const dem::ContactParameters& contact, double steady_drag,
                              const dem::Stage& stage, Bulk& bulk, Pressures& pressures) {
  StagePrediction p = of_stage(engine, contact, steady_drag, stage, bulk, pressures);
  if (engine.domain.boundaries.empty()) p.height = bulk.height;
  return p;
}

template <int D>
ShortestCollision shortest_collision(const PackingIn<D>& packing, const dem::ContactParameters& contact) {
  const dem::CoefficientTable table(packing.materials, packing.grains.material, contact);
  ShortestCollision shortest;
  for (std::size_t k = 0; k < packing.grains.size(); ++k) {
    const std::int32_t material = packing.grains.material[k];
    const dem::GrainRecord<D> grain{
        .radius = packing.grains.radius[k], .mass = mass_of(packing, k), .material = material};
    const double pair = collision_time(0.5 * grain.mass, tangent(contact, table.pair_stiffness(grain, grain)));
    const double wall = collision_time(grain.mass, tangent(contact, table.wall_stiffness(grain)));
    if (const double time = std::min(pair, wall); shortest.time == 0 || time < shortest.time)
      shortest = {time, grain.radius, material, wall < pair};
  }
  return shortest;
}
template ShortestCollision shortest_collision(const Packing&, const dem::ContactParameters&);
template ShortestCollision shortest_collision(const PackingIn<3>&, const dem::ContactParameters&);

template <int D>
StepLimit step_limit(const dem::EngineIn<D>& engine, const dem::IntegrationParameters& integration, double collision) {
  if (integration.time_step) return StepLimit::given;
  if (engine.dt > 0.999 * integration.safety * collision) return StepLimit::collision;
  const dem::StepBounds bounds = step_bounds(engine);
  return bounds.damping < bounds.stiffness ? StepLimit::damping : StepLimit::stiffness;
}
template StepLimit step_limit(const dem::Engine&, const dem::IntegrationParameters&, double);
template StepLimit step_limit(const dem::EngineIn<3>&, const dem::IntegrationParameters&, double);

std::vector<std::string> doubts_about_step(double time_step, StepLimit limit, const ShortestCollision& collision,
                                           const dem::ContactParameters& contact) {
  constexpr double tiny = 0.01;  // of the collision
  if (time_step >= tiny * collision.time) return {};
  return {fmt::format(
      "a collision takes {:.0f} steps; a step of a tenth of its duration would suffice{}", collision.time / time_step,
      limit == StepLimit::damping
          ? fmt::format(", but damping prevents it: raise contact.restitution (now {:g}), or lower drag",
                        contact.restitution)
          : "")};
}

std::vector<std::string> doubts_about(const StagePrediction& p, const dem::Stage& stage) {
  constexpr double most_overlap = 0.01, most_inertial = 0.1;
  std::vector<std::string> doubts;
  if (p.overlap && *p.overlap > most_overlap)
    doubts.push_back(fmt::format(
        "stage {}: grains overlap by about {:.2g} % of their diameter (k/P = {:.3g}); they are hard above 1e4", p.name,
        100 * *p.overlap, *p.stiffness_number));
  const bool closes = std::ranges::count(stage.side, dem::SideDrive::Kind::velocity, &dem::SideDrive::kind) > 0;
  if (p.inertial_number && *p.inertial_number > most_inertial && closes)
    doubts.push_back(
        fmt::format("stage {}: I = {:.2g}: the sample is deformed faster than grains can rearrange; below 1e-3 it "
                    "would be quasi-static",
                    p.name, *p.inertial_number));
  const double each = static_cast<double>(p.steps) / static_cast<double>(dem::increment_count(stage));
  if (!p.exact && each > static_cast<double>(stage.equilibrium.max_steps))
    doubts.push_back(fmt::format("stage {}: an increment may need more than equilibrium.max_steps = {}", p.name,
                                 stage.equilibrium.max_steps));
  return doubts;
}

}  // namespace arenite::fields
