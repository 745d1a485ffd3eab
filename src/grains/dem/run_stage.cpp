#include "grains/dem/run_stage.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/text.hpp"
#include "grains/dem/history/history.hpp"

namespace arenite::dem {

std::string describe(const Equilibrium& now) {
  std::string text = fmt::format("unbalanced force ratio {:.1e}, kinetic over elastic energy {:.1e}",
                                 now.unbalanced_ratio, now.kinetic_ratio);
  if (now.loose_kinetic > 0) text += fmt::format(", of grains that carry no load {:.1e}", now.loose_kinetic);
  return now.falling > 0 ? text + fmt::format(", {:.2g} % of the grains are falling", 100 * now.falling) : text;
}

namespace {

/// One of the bounds below which a sample counts as at rest.
struct Demand {
  const char *what, *key;
  double now, most;
  bool may_equal = false;
  bool is_met() const { return may_equal ? now <= most : now < most; }
};

std::vector<Demand> demands_on(const Equilibrium& now, const EquilibriumCriterion& wanted) {
  std::vector<Demand> demands{
      {"unbalanced force ratio", "equilibrium.unbalanced", now.unbalanced_ratio, wanted.unbalanced},
      {"kinetic over elastic energy", "equilibrium.kinetic", now.kinetic_ratio, wanted.kinetic},
      {"that of grains that carry no load", "equilibrium.loose_kinetic", now.loose_kinetic,
       wanted.loose_kinetic.value_or(1e5 * wanted.kinetic)},
      {"share of grains that fall", "equilibrium.falling", now.falling, wanted.falling, true}};
  if (wanted.mobilisation)
    demands.push_back({"mobilised friction", "equilibrium.mobilisation", now.mobilisation, *wanted.mobilisation});
  return demands;
}

}  // namespace

bool is_at_rest(const Equilibrium& now, const EquilibriumCriterion& wanted) {
  return std::ranges::all_of(demands_on(now, wanted), &Demand::is_met);
}

namespace {

constexpr std::int64_t check_interval = 200;  // steps between two looks at equilibrium
constexpr std::size_t history_rows = 4096;    // beyond this every second row is dropped

/// Largest departure of a force-driven wall from its aim, relative to the aim.
double load_error(const WallDrives& drives, const Domain& domain) {
  double worst = 0;
  for (int side = 0; side < sides; ++side)
    if (drives[side].kind == WallDrive::Kind::force && drives[side].value > 0)
      worst = std::max(worst, std::abs(domain.wall[side].force - drives[side].value) / drives[side].value);
  return worst;
}

/// Adds a row to the history, where one is due or wanted. It stays short however long the stage: when it is full, every
/// second row goes and sampling halves.
void note(const Engine& engine, const Stage& stage, bool wanted, StageRun& run) {
  auto& columns = run.result.history.columns;
  if (run.checks++ % run.sample_every == 0 || wanted)
    add_row(run.result.history, {engine, stage, run.latest, run.increment});
  if (columns.empty() || columns.front().values.size() < history_rows) return;
  for (auto& column : columns) {
    for (std::size_t k = 0; 2 * k < column.values.size(); ++k) column.values[k] = column.values[2 * k];
    column.values.resize((column.values.size() + 1) / 2);
  }
  run.sample_every *= 2;
}

void store_snapshot(const Engine& engine, const Equilibrium& now, std::string label, StageResult& result) {
  result.snapshots.push_back(
      {time_of(engine), engine.step, std::move(label), packing_of(engine), energies_of(engine), now});
}

/// The same with what the pressing sides still lack, relative to their aim; nothing on that where none presses.
std::string describe_pressed(const Equilibrium& now, const WallDrives& drives, const Domain& domain) {
  const bool presses =
      std::any_of(drives.begin(), drives.end(), [](const WallDrive& d) { return d.kind == WallDrive::Kind::force; });
  return describe(now) +
         (presses ? fmt::format(", forces on the sides within {:.1e} of their targets", load_error(drives, domain))
                  : "");
}

/// How the stage came to its end by itself.
std::string ending_of(const Engine& engine, const Stage& stage, const Equilibrium& now, const WallDrives& drives) {
  const std::string missed = stage.until.empty() ? "" : fmt::format(" before {}", stage.until);
  if (stage.strain_cycles)
    return fmt::format("{} strain cycles completed{}; {}", stage.strain_cycles->count, missed, describe(now));
  if (stage.duration) return fmt::format("{:g} s passed{}; {}", *stage.duration, missed, describe(now));
  return fmt::format("equilibrium{}: {}", missed, describe_pressed(now, drives, engine.domain));
}

/// With how many of the bonds have broken, and how many pairs cohesion joins; nothing on these where there are none.
std::string outcome_of(const Engine& engine, std::string text) {
  if (const BondCount bonds = count_bonds(engine); bonds.made() > 0)
    text += fmt::format("; {} of {} bonds broken", bonds.made() - bonds.intact, bonds.made());
  if (const ExchangeAccount& account = engine.exchanged; !account.through.empty() || account.removed.grains > 0) {
    text += fmt::format("; {} grains came in, {} left", account.inserted.grains, account.removed.grains);
    if (account.waiting > 0) text += fmt::format(", {} wait, for there is no room for them", account.waiting);
  }
  for (const Membrane& m : the<Membranes>(engine).list)
    if (m.stretched > m.may_stretch)
      text += fmt::format("; the membrane at the {} was stretched by {:.0f} %, beyond its largest strain of {:.0f} %",
                          side_names[m.side], 100 * m.stretched, 100 * m.may_stretch);
  if (!engine.contact.is_cohesive()) return text;
  const CohesionCount pairs = count_cohesion(engine);
  return text + fmt::format("; {} cohesive pairs, {} of them not touching", pairs.joined, pairs.apart);
}

/// The end of a leg: a row for the curves against cycles, and a state.
void end_leg(const Engine& engine, const Stage& stage, const Leg& leg, StageRun& run) {
  if (leg.ends_half) {
    append(run.result.cycles, "cycle", "1", static_cast<double>(leg.cycle));
    append(run.result.cycles, "at_maximum", "1", leg.at_maximum ? 1.0 : 0.0);
    add_row(run.result.cycles, {engine, stage, run.latest, run.increment});
  }
  if (leg.stored) store_snapshot(engine, run.latest, leg.label, run.result);
  if (!leg.is_whole) return;
  run.steps_in_increment = 0;
  ++run.increment;
}

void give_up(const Engine& engine, const Stage& stage, const Leg& leg, const WallDrives& drives, StageRun& run) {
  store_snapshot(engine, run.latest, leg.label, run.result);
  run.result.converged = false;
  run.result.outcome = fmt::format("no equilibrium within {} steps{} (equilibrium.max_steps): {}",
                                   run.steps_in_increment, increment_count(stage) > 1 ? " of " + leg.label : "",
                                   describe_pressed(run.latest, drives, engine.domain));
}

/// What comes next in the stage.
Leg leg_of(const Engine& engine, const Stage& stage, const StageRun& run) {
  const auto states = static_cast<std::int64_t>(run.result.snapshots.size()) - run.extra_states;
  return leg_at(stage, run.start, run.increment, states, engine.dt);
}

}  // namespace

StageRun begin_stage(Engine& engine, const Stage& stage) {
  engine.begin(stage);
  StageRun run;
  run.result.name = stage.name;
  run.start.time = time_of(engine);
  run.start.size = {engine.domain.width(), engine.domain.height()};
  for (int side = 0; side < sides; ++side) run.start.force[side] = engine.domain.wall[side].force;
  return run;
}

void continue_stage(Engine& engine, const Stage& stage, StageRun& run) {
  const Leg leg = leg_of(engine, stage, run);
  if (leg.shear_rate) set_shear_rate(engine, *leg.shear_rate);
  const WallDrives drives = drives_for(stage, leg, engine.domain);
  set_drives(engine, drives);
  const std::int64_t steps = leg.until ? std::min(check_interval, *leg.until - run.steps_in_increment) : check_interval;
  engine.advance(steps);
  run.steps_in_increment += steps;
  engine.exchange(stage.exchange, time_of(engine) - run.start.time);
  run.latest = equilibrium_of(engine);
  const bool at_rest = is_at_rest(run.latest, stage.equilibrium) &&
                       load_error(drives, engine.domain) < 10 * stage.equilibrium.unbalanced;
  const bool is_over = leg.until ? run.steps_in_increment >= *leg.until : at_rest;
  const bool given_up = !leg.until && !at_rest && run.steps_in_increment >= stage.equilibrium.max_steps;
  note(engine, stage, is_over && leg.is_whole, run);
  if (is_over) end_leg(engine, stage, leg, run);
  if (given_up) give_up(engine, stage, leg, drives, run);
  run.finished = given_up || (is_over && leg.is_last);
  if (run.finished && !given_up) run.result.outcome = outcome_of(engine, ending_of(engine, stage, run.latest, drives));
}

void store_state(const Engine& engine, std::string label, StageRun& run) {
  store_snapshot(engine, run.latest, std::move(label), run.result);
  ++run.extra_states;
}

void end_early(const Engine& engine, const Stage& stage, const std::string& why, StageRun& run) {
  const std::vector<double>* time = run.result.history.find("time");
  if (!time || time->back() != time_of(engine)) add_row(run.result.history, {engine, stage, run.latest, run.increment});
  const auto& states = run.result.snapshots;
  if (states.empty() || states.back().step != engine.step) store_state(engine, "end", run);
  run.finished = true;
  run.result.began = run.start.time;
  run.result.outcome = outcome_of(engine, fmt::format("{}; {}", why, describe(run.latest)));
}

std::string unrest(const Engine& engine, const Stage& stage, const StageRun& run) {
  std::vector<Demand> demands = demands_on(run.latest, stage.equilibrium);
  const WallDrives drives = drives_for(stage, leg_of(engine, stage, run), engine.domain);
  demands.push_back({"forces on the sides, off their targets by", "equilibrium.unbalanced",
                     load_error(drives, engine.domain), 10 * stage.equilibrium.unbalanced});
  std::vector<std::string> lacks, keys;
  for (const Demand& demand : demands) {
    if (demand.is_met()) continue;
    lacks.push_back(fmt::format("{} {:.1e} (wanted: {:.1e})", demand.what, demand.now, demand.most));
    if (std::ranges::count(keys, demand.key) == 0) keys.emplace_back(demand.key);
  }
  return fmt::format("{}; brake it with critical_drag = 0.2 or drag, or ask for less with {}", list_of(lacks),
                     list_of(keys));
}

double share_done(const Stage& stage, const StageRun& run) {
  if (run.finished) return 1;
  if (stage.duration) {
    const double snapshots = static_cast<double>(std::max<std::int64_t>(1, stage.snapshots));
    const auto stored = static_cast<double>(run.result.snapshots.size()) - static_cast<double>(run.extra_states);
    return std::min(1.0, stored / snapshots);
  }
  const auto total = static_cast<double>(increment_count(stage));
  if (stage.strain_cycles) return static_cast<double>(run.increment) / total;
  const double within =
      std::clamp(std::log(run.latest.unbalanced_ratio) / std::log(stage.equilibrium.unbalanced), 0.0, 0.95);
  return (static_cast<double>(run.increment) + within) / total;
}

}  // namespace arenite::dem
