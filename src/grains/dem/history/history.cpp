#include "grains/dem/history/history.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <optional>

namespace arenite::dem {
namespace {

bool shears_cell(const Stage& stage) {
  return stage.shear_rate != 0 || (stage.strain_cycles && stage.strain_cycles->of == StrainCycles::shear) ||
         std::any_of(stage.programmes.begin(), stage.programmes.end(),
                     [](const Programme& p) { return p.of.is(Programme::What::shear_rate); });
}

/// What one row tells of parts.
struct JointsRow {
  std::optional<BondCount> bonds = {};      ///< where there are any
  std::optional<CohesionCount> pairs = {};  ///< where grains cohere
};
template <int D> struct PartsRow : JointsRow {};
template <> struct PartsRow<2> : JointsRow {
  Vec2 mean_forces = {};                         ///< where there are membranes
  BySide<std::optional<double>> stretched = {};  ///< their strains
};

/// What one row tells.
template <int D> struct HistoryRow {
  const DomainIn<D>& domain;
  double time = 0, increment = 0, sheared = 0;
  PartsRow<D> parts = {};
  Amount passed = {};
  ExchangeAccount exchanged = {};  ///< where grains come in and leave
  std::size_t grains = 0;          ///< and how many there are
  Energies energies = {};
  Equilibrium now = {};
};

/// Beams of the plane do not twist.
void append_twisted(History& /*history*/, const PartsRow<2>& /*row*/) {}
void append_twisted(History& history, const PartsRow<3>& row) {
  append(history, "broken_in_twisting", "1", static_cast<double>(row.bonds->in_twisting));
}

template <int D> void append_counts(History& history, const PartsRow<D>& row) {
  if (row.bonds) {
    append(history, "bonds", "1", static_cast<double>(row.bonds->intact));
    append(history, "broken_in_tension", "1", static_cast<double>(row.bonds->in_tension));
    append(history, "broken_in_bending", "1", static_cast<double>(row.bonds->in_bending));
    append(history, "broken_in_shear", "1", static_cast<double>(row.bonds->in_shear));
    append_twisted(history, row);
    append(history, "bond_energy", "J", row.bonds->energy);
  }
  if (row.pairs) {
    append(history, "cohesive_pairs", "1", static_cast<double>(row.pairs->joined));
    append(history, "cohesive_pairs_apart", "1", static_cast<double>(row.pairs->apart));
  }
}

void append_membranes(History& /*history*/, const PartsRow<3>& /*row*/) {}
void append_membranes(History& history, const PartsRow<2>& row) {
  bool is_any = false;
  for (int side = 0; side < sides; ++side) {
    if (!row.stretched[side]) continue;
    append(history, (membrane_name(side) + "_strain").c_str(), "1", *row.stretched[side]);
    is_any = true;
  }
  if (!is_any) return;
  append(history, "mean_force_x", "N", row.mean_forces.x);
  append(history, "mean_force_y", "N", row.mean_forces.y);
}

template <int D> void append_exchange(History& history, const HistoryRow<D>& row) {
  const Batch &inserted = row.exchanged.inserted, &removed = row.exchanged.removed;
  append(history, "grains", "1", static_cast<double>(row.grains));
  append(history, "inserted", "1", static_cast<double>(inserted.grains));
  append(history, "inserted_mass", "kg", inserted.mass);
  append(history, "removed", "1", static_cast<double>(removed.grains));
  append(history, "removed_mass", "kg", removed.mass);
  append(history, "waiting", "1", static_cast<double>(row.exchanged.waiting));
}

void append_shear_force(History& history, int side, double force) {
  append(history, fmt::format("{}_shear_force", side_names[side]).c_str(), "N", force);
}
/// Along the two other axes.
void append_shear_force(History& history, int side, Vec3 force) {
  constexpr const char* axes = "xyz";
  for (int axis = 0; axis < 3; ++axis)
    if (axis != axis_of(side))
      append(history, fmt::format("{}_shear_force_{}", any_side_names[side], axes[axis]).c_str(), "N", force[axis]);
}

void append_boundaries(History& history, const DomainIn<3>& domain) {
  constexpr const char* axes = "xyz";
  for (const BoundaryIn<3>& boundary : domain.boundaries)
    for (int axis = 0; axis < 3; ++axis) {
      append(history, fmt::format("{}_{}", boundary.name, axes[axis]).c_str(), "m", boundary.centre[axis]);
      append(history, fmt::format("{}_force_{}", boundary.name, axes[axis]).c_str(), "N", boundary.force[axis]);
      append(history, fmt::format("{}_torque_{}", boundary.name, axes[axis]).c_str(), "N m", boundary.torque[axis]);
    }
}
void append_boundaries(History& history, const Domain& domain) {
  for (const Boundary& boundary : domain.boundaries) {
    append(history, (boundary.name + "_force_x").c_str(), "N", boundary.force.x);
    append(history, (boundary.name + "_force_y").c_str(), "N", boundary.force.y);
    append(history, (boundary.name + "_torque").c_str(), "N m", boundary.torque);
  }
}

template <int D> void append_row(History& history, const Stage& stage, const HistoryRow<D>& row) {
  append(history, "time", "s", row.time);
  append(history, "increment", "1", row.increment);
  for (int side = 0; side < sides_in<D>; ++side) {
    const auto& wall = row.domain.wall[side];
    append(history, fmt::format("{}_position", any_side_names[side]).c_str(), "m", wall.position);
    append(history, fmt::format("{}_force", any_side_names[side]).c_str(), "N", wall.force);
    append_shear_force(history, side, wall.shear_force);
  }
  if (shears_cell(stage)) append(history, "shear_strain", "1", row.sheared);
  append_boundaries(history, row.domain);
  append_membranes(history, row.parts);
  if (stage.count_below) {
    append(history, "passed", "1", static_cast<double>(row.passed.grains));
    append(history, "passed_mass", "kg", row.passed.mass);
  }
  append_counts(history, row.parts);
  if (!stage.exchange.is_none()) append_exchange(history, row);
  for (const EnergyTerm& term : energy_terms) append(history, term.name, "J", row.energies.*term.value);
  if (!stage.exchange.is_none()) append(history, exchange_term.name, "J", row.energies.*exchange_term.value);
  append(history, "unbalanced_ratio", "1", row.now.unbalanced_ratio);
  append(history, "kinetic_ratio", "1", row.now.kinetic_ratio);
  append(history, "mobilisation", "1", row.now.mobilisation);
  append(history, "wall_speed", "m/s", row.now.wall_speed);
  append(history, "falling", "1", row.now.falling);
  append(history, "loose_kinetic_ratio", "1", row.now.loose_kinetic);
}

template <int D> JointsRow joints_row(const SampleIn<D>& s) {
  JointsRow row;
  if (const BondCount bonds = count_bonds(s); bonds.made() > 0) row.bonds = bonds;
  if (s.contact.is_cohesive()) row.pairs = count_cohesion(s);
  return row;
}
PartsRow<3> parts_row(const SampleIn<3>& s) { return {joints_row(s)}; }
PartsRow<2> parts_row(const Sample& s) {
  PartsRow<2> row{joints_row(s)};
  row.mean_forces = mean_forces(s);
  for (const Membrane& m : the<Membranes>(s).list)
    row.stretched[m.side] = mean_strain(m.skin, s.domain.boundaries[m.boundary].points);
  return row;
}

/// Room for what membranes will tell.
void expect_membranes(const Stage& /*stage*/, PartsRow<3>& /*row*/) {}
void expect_membranes(const Stage& stage, PartsRow<2>& row) {
  for (int side = 0; side < sides; ++side)
    if (stage.side[side].is_skin()) row.stretched[side] = 0;
}

}  // namespace

void append(History& history, const char* name, const char* unit, double value) {
  auto it = std::find_if(history.columns.begin(), history.columns.end(), [&](const auto& c) { return c.name == name; });
  if (it == history.columns.end()) it = history.columns.insert(it, {name, unit, {}});
  it->values.push_back(value);
}

template <int D> void add_row(History& history, const LookIn<D>& look) {
  const auto& [engine, stage, now, increment] = look;
  HistoryRow<D> row{engine.domain, time_of<D>(engine), static_cast<double>(increment + 1), engine.sheared};
  row.parts = parts_row(engine);
  if (stage.count_below) row.passed = amount_below<D>(engine, *stage.count_below);
  row.exchanged = engine.exchanged;
  row.grains = grain_count<D>(engine);
  row.energies = energies_of<D>(engine);
  row.now = now;
  append_row(history, stage, row);
}

template void add_row(History&, const LookIn<2>&);
template void add_row(History&, const LookIn<3>&);

template <int D> History history_columns(const Stage& stage, const DomainIn<D>& domain, bool bonded, bool cohesive) {
  HistoryRow<D> row{domain};
  if (bonded) row.parts.bonds.emplace();
  if (cohesive) row.parts.pairs.emplace();
  expect_membranes(stage, row.parts);
  History history;
  append_row(history, stage, row);
  return history;
}

template History history_columns<2>(const Stage&, const Domain&, bool, bool);
template History history_columns<3>(const Stage&, const DomainIn<3>&, bool, bool);

}  // namespace arenite::dem
