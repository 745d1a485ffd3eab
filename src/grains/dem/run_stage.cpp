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
       wanted.loose_kinetic.value_or(EquilibriumCriterion::loose_over_kinetic * wanted.kinetic)},
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

/// Within which forces on sides are at their aims at rest, relative: hangs on how well grains are to be balanced, but a
/// load is never left half a per cent off.
double load_tolerance(const EquilibriumCriterion& wanted) { return std::min(10 * wanted.unbalanced, 0.005); }

/// Largest departure of a force-driven wall from its aim, relative to the aim.
template <int D> double load_error(const WallDrivesIn<D>& drives, const DomainIn<D>& domain) {
  double worst = 0;
  for (int side = 0; side < sides_in<D>; ++side)
    if (drives[side].kind == DriveKind::force && drives[side].value > 0)
      worst = std::max(worst, std::abs(domain.wall[side].force - drives[side].value) / drives[side].value);
  return worst;
}

/// Adds a row to the history, where one is due or wanted. It stays short however long the stage: when it is full, every
/// second row goes and sampling halves.
template <int D> void note(const EngineIn<D>& engine, const Stage& stage, bool wanted, StageRunIn<D>& run) {
  auto& columns = run.result.history.columns;
  if (run.checks++ % run.sample_every == 0 || wanted)
    add_row<D>(run.result.history, {engine, stage, run.latest, run.increment});
  if (columns.empty() || columns.front().values.size() < history_rows) return;
  for (auto& column : columns) {
    for (std::size_t k = 0; 2 * k < column.values.size(); ++k) column.values[k] = column.values[2 * k];
    column.values.resize((column.values.size() + 1) / 2);
  }
  run.sample_every *= 2;
}

template <int D>
void store_snapshot(const EngineIn<D>& engine, const Equilibrium& now, std::string label, StageResultIn<D>& result) {
  result.snapshots.push_back(
      {time_of<D>(engine), engine.step, std::move(label), packing_of<D>(engine), energies_of<D>(engine), now});
}

/// The same with what the pressing sides still lack, relative to their aim; nothing on that where none presses.
template <int D>
std::string describe_pressed(const Equilibrium& now, const WallDrivesIn<D>& drives, const DomainIn<D>& domain) {
  const bool presses = std::ranges::any_of(drives, [](const WallDriveIn<D>& d) { return d.kind == DriveKind::force; });
  return describe(now) +
         (presses ? fmt::format(", forces on the sides within {:.1e} of their targets", load_error<D>(drives, domain))
                  : "");
}

/// How the stage came to its end by itself.
template <int D>
std::string ending_of(const EngineIn<D>& engine, const Stage& stage, const Equilibrium& now,
                      const WallDrivesIn<D>& drives) {
  const std::string missed = stage.until.empty() ? "" : fmt::format(" before {}", stage.until);
  if (stage.strain_cycles)
    return fmt::format("{} strain cycles completed{}; {}", stage.strain_cycles->count, missed, describe(now));
  if (stage.duration) return fmt::format("{:g} s passed{}; {}", *stage.duration, missed, describe(now));
  return fmt::format("equilibrium{}: {}", missed, describe_pressed<D>(now, drives, engine.domain));
}

/// With how many of the bonds have broken, and how many pairs cohesion joins; nothing on these where there are none.
std::string told_of_bonds(const BondCount& bonds) {
  if (bonds.made() == 0) return "";
  return fmt::format("; {} of {} bonds broken", bonds.made() - bonds.intact, bonds.made());
}
template <int D> std::string told_of_pairs(const EngineIn<D>& engine) {
  if (!engine.contact.is_cohesive()) return "";
  const CohesionCount pairs = count_cohesion<D>(engine);
  return fmt::format("; {} cohesive pairs, {} of them not touching", pairs.joined, pairs.apart);
}
std::string outcome_of(const EngineIn<3>& engine, const std::string& text) {
  return text + told_of_bonds(count_bonds<3>(engine)) + told_of_pairs(engine);
}
std::string outcome_of(const Engine& engine, std::string text) {
  text += told_of_bonds(count_bonds<2>(engine));
  if (const ExchangeAccount& account = engine.exchanged; !account.through.empty() || account.removed.grains > 0) {
    text += fmt::format("; {} grains came in, {} left", account.inserted.grains, account.removed.grains);
    if (account.waiting > 0) text += fmt::format(", {} wait, for there is no room for them", account.waiting);
  }
  for (const Membrane& m : the<Membranes>(engine).list)
    if (m.stretched > m.may_stretch)
      text += fmt::format("; the membrane at the {} was stretched by {:.0f} %, beyond its largest strain of {:.0f} %",
                          side_names[m.side], 100 * m.stretched, 100 * m.may_stretch);
  return text + told_of_pairs(engine);
}

/// The end of a leg: a row for the curves against cycles, and a state.
template <int D> void end_leg(const EngineIn<D>& engine, const Stage& stage, const Leg& leg, StageRunIn<D>& run) {
  if (leg.ends_half) {
    append(run.result.cycles, "cycle", "1", static_cast<double>(leg.cycle));
    append(run.result.cycles, "at_maximum", "1", leg.at_maximum ? 1.0 : 0.0);
    add_row<D>(run.result.cycles, {engine, stage, run.latest, run.increment});
  }
  if (leg.stored) store_snapshot(engine, run.latest, leg.label, run.result);
  if (!leg.is_whole) return;
  run.steps_in_increment = 0;
  ++run.increment;
}

template <int D>
void give_up(const EngineIn<D>& engine, const Stage& stage, const Leg& leg, const WallDrivesIn<D>& drives,
             StageRunIn<D>& run) {
  store_snapshot(engine, run.latest, leg.label, run.result);
  run.result.converged = false;
  run.result.outcome = fmt::format("no equilibrium within {} steps{} (equilibrium.max_steps): {}",
                                   run.steps_in_increment, increment_count(stage) > 1 ? " of " + leg.label : "",
                                   describe_pressed<D>(run.latest, drives, engine.domain));
}

/// What comes next in the stage.
template <int D> Leg leg_of(const EngineIn<D>& engine, const Stage& stage, const StageRunIn<D>& run) {
  const auto states = static_cast<std::int64_t>(run.result.snapshots.size()) - run.extra_states;
  return leg_at(stage, run.start, run.increment, states, engine.dt);
}

}  // namespace

template <int D> StageRunIn<D> begin_stage(EngineIn<D>& engine, const Stage& stage) {
  engine.begin(stage);
  StageRunIn<D> run;
  run.result.name = stage.name;
  run.start.time = time_of<D>(engine);
  run.start.size = engine.domain.extents();
  for (int side = 0; side < sides_in<D>; ++side) run.start.force[side] = engine.domain.wall[side].force;
  return run;
}

template <int D> void continue_stage(EngineIn<D>& engine, const Stage& stage, StageRunIn<D>& run) {
  const Leg leg = leg_of(engine, stage, run);
  if (leg.shear_rate) set_shear_rate<D>(engine, *leg.shear_rate);
  const WallDrivesIn<D> drives = drives_for<D>(stage, leg, engine.domain);
  set_drives<D>(engine, drives);
  const std::int64_t steps = leg.until ? std::min(check_interval, *leg.until - run.steps_in_increment) : check_interval;
  advance<D>(engine, engine.pool(), steps);
  run.steps_in_increment += steps;
  engine.exchange(stage.exchange, time_of<D>(engine) - run.start.time);
  run.latest = equilibrium_of<D>(engine);
  const bool at_rest = is_at_rest(run.latest, stage.equilibrium) &&
                       load_error<D>(drives, engine.domain) < load_tolerance(stage.equilibrium);
  const bool is_over = leg.until ? run.steps_in_increment >= *leg.until : at_rest;
  const bool given_up = !leg.until && !at_rest && run.steps_in_increment >= stage.equilibrium.max_steps;
  note(engine, stage, is_over && leg.is_whole, run);
  if (is_over) end_leg(engine, stage, leg, run);
  if (given_up) give_up(engine, stage, leg, drives, run);
  run.finished = given_up || (is_over && leg.is_last);
  if (run.finished && !given_up) run.result.outcome = outcome_of(engine, ending_of(engine, stage, run.latest, drives));
}

template <int D> void store_state(const EngineIn<D>& engine, std::string label, StageRunIn<D>& run) {
  store_snapshot(engine, run.latest, std::move(label), run.result);
  ++run.extra_states;
}

template <int D>
void end_early(const EngineIn<D>& engine, const Stage& stage, const std::string& why, StageRunIn<D>& run) {
  const std::vector<double>* time = run.result.history.find("time");
  if (!time || time->back() != time_of<D>(engine))
    add_row<D>(run.result.history, {engine, stage, run.latest, run.increment});
  const auto& states = run.result.snapshots;
  if (states.empty() || states.back().step != engine.step) store_state(engine, "end", run);
  run.finished = true;
  run.result.began = run.start.time;
  run.result.outcome = outcome_of(engine, fmt::format("{}; {}", why, describe(run.latest)));
}

template <int D> std::string unrest(const EngineIn<D>& engine, const Stage& stage, const StageRunIn<D>& run) {
  std::vector<Demand> demands = demands_on(run.latest, stage.equilibrium);
  const WallDrivesIn<D> drives = drives_for<D>(stage, leg_of(engine, stage, run), engine.domain);
  demands.push_back({"forces on the sides, off their targets by", "equilibrium.unbalanced",
                     load_error<D>(drives, engine.domain), load_tolerance(stage.equilibrium)});
  std::vector<std::string> lacks, keys;
  for (const Demand& demand : demands) {
    if (demand.is_met()) continue;
    lacks.push_back(fmt::format("{} {:.1e} (wanted: {:.1e})", demand.what, demand.now, demand.most));
    if (std::ranges::count(keys, demand.key) == 0) keys.emplace_back(demand.key);
  }
  const char* const brake = engine.drag > 0 ? "drag brakes no spins, rolling friction does (rolling in [contact])"
                                            : "brake it with critical_drag = 0.2 or drag";
  return fmt::format("{}; {}, or ask for less with {}", list_of(lacks), brake, list_of(keys));
}

template <int D> double share_done(const Stage& stage, const StageRunIn<D>& run) {
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

#define ARENITE_OF(D)                                                                            \
  template StageRunIn<D> begin_stage(EngineIn<D>&, const Stage&);                                \
  template void continue_stage(EngineIn<D>&, const Stage&, StageRunIn<D>&);                      \
  template void store_state(const EngineIn<D>&, std::string, StageRunIn<D>&);                    \
  template void end_early(const EngineIn<D>&, const Stage&, const std::string&, StageRunIn<D>&); \
  template std::string unrest(const EngineIn<D>&, const Stage&, const StageRunIn<D>&);           \
  template double share_done(const Stage&, const StageRunIn<D>&);
ARENITE_OF(2)
ARENITE_OF(3)
#undef ARENITE_OF

}  // namespace arenite::dem
