#include "report/summary/state.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "grains/dem/run_stage.hpp"

namespace arenite::report {
namespace {

using statistics::described;

Numbers equilibrium(const Equilibrium& now) {
  return {{"unbalanced_ratio",
           described(now.unbalanced_ratio, "", "Mean resultant force on a grain over the mean contact force")},
          {"kinetic_ratio", described(now.kinetic_ratio, "", "Kinetic over elastic energy")},
          {"loose_kinetic_ratio", described(now.loose_kinetic, "", "The same for grains that carry no load")},
          {"falling", described(now.falling, "", "Fraction of grains that are falling")},
          {"mobilisation", described(now.mobilisation, "", "Mean |F_t|/F_n")},
          {"wall_speed_m_s", described(now.wall_speed, "m/s", "Speed of the fastest wall or boundary")}};
}

Numbers components(double along) { return along; }
Numbers components(Vec2 along) { return {along.x, along.y}; }
Numbers components(Vec3 along) { return {along.x, along.y, along.z}; }

template <int D> Numbers walls(const Container<D>& domain) {
  Numbers j = Numbers::tree();
  for (std::size_t side = 0; side < domain.wall.size(); ++side) {
    const WallIn<D>& wall = domain.wall[side];
    if (!wall.present) continue;
    j[any_side_names[side]] = {
        {"position_m", described(wall.position, "m", "Position along the normal of the wall")},
        {"velocity_m_s", described(wall.velocity, "m/s", "Velocity along the normal of the wall")},
        {"force_N", described(wall.force, "N", "Normal force of the grains on the wall")},
        {"shear_force_N", described(components(wall.shear_force), "N", "Force of the grains along the wall")}};
  }
  return j;
}

template <int D> Numbers boundaries(const std::vector<BoundaryIn<D>>& of) {
  Numbers j = Numbers::tree();
  for (const BoundaryIn<D>& b : of)
    j[b.name] = {{"present", described(b.present, "", "Whether it is present")},
                 {"centre_m", described(components(b.centre), "m", "Centre, which moves with the boundary")},
                 {"velocity_m_s", described(components(b.velocity), "m/s", "Velocity of the centre")},
                 {"spin_rad_s", described(components(b.spin), "rad/s", "Counter-clockwise")},
                 {"force_N", described(components(b.force), "N", "Force of the grains on it, along each axis")},
                 {"torque_N_m", described(components(b.torque), "N m", "Torque of the grains about the centre")}};
  return j;
}

/// Without the terms that are added up on the way where nobody asked for that; broken bonds always are.
Numbers energies_of(const Energies& e) {
  const bool tracked =
      std::ranges::any_of(energy_terms, [&](const EnergyTerm& t) { return t.tracked && e.*t.value != 0; });
  Numbers energies = Numbers::tree();
  for (const EnergyTerm& term : energy_terms)
    if (tracked || !term.tracked) energies[term.name] = described(e.*term.value, "J", term.phrase);
  if (e.exchanged != 0) energies[exchange_term.name] = described(e.exchanged, "J", exchange_term.phrase);
  return energies;
}

template <int D> std::string grains_of(const PackingIn<D>& packing) {
  const std::size_t all = packing.grains.size();
  if (packing.materials.size() < 2) return std::to_string(all);
  std::string parts;
  for (std::size_t m = 0; m < packing.materials.size(); ++m) {
    const auto count =
        std::count(packing.grains.material.begin(), packing.grains.material.end(), static_cast<std::int32_t>(m));
    parts += fmt::format("{}{} {}", m > 0 ? ", " : "", count, packing.materials[m].name);
  }
  return fmt::format("{}: {}", all, parts);
}

template <int D> std::string forces_on_sides(const Container<D>& domain) {
  std::string text;
  for (std::size_t side = 0; side < domain.wall.size(); ++side)
    if (const double f = domain.wall[side].force; domain.wall[side].present)
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", any_side_names[side],
                          std::abs(f) < 1e4 ? fmt::format("{:.4g} N", f) : fmt::format("{:.4g} kN", 1e-3 * f));
  return text;
}

template <int D> std::string rest_of(const StageResultIn<D>& last) {
  const Equilibrium& now = last.snapshots.back().equilibrium;
  const bool rests = last.asked.known ? last.asked.in_equilibrium
                                      : last.converged && dem::is_at_rest(now, dem::EquilibriumCriterion{});
  return fmt::format("{}: {}", rests ? "in equilibrium" : "NOT IN EQUILIBRIUM", dem::describe(now));
}

}  // namespace

template <int D> Numbers state_of(const SnapshotIn<D>& snapshot) {
  Numbers j{{"label", snapshot.label},
            {"time_s", described(snapshot.time, "s", "Time since the run began")},
            {"step", described(snapshot.step, "", "Steps since the run began")},
            {"walls", walls<D>(snapshot.packing.domain)},
            {"equilibrium", equilibrium(snapshot.equilibrium)},
            {"energies_J", energies_of(snapshot.energies)}};
  if (const Numbers inside = boundaries(snapshot.packing.domain.boundaries); !inside.empty()) j["boundaries"] = inside;
  return j;
}

template <int D> std::string state_text(const StageResultIn<D>& last) {
  const SnapshotIn<D>& snapshot = last.snapshots.back();
  std::string text = fmt::format("\nLast state: {} of {}\n", snapshot.label, last.name);
  const auto add = [&](const char* name, const std::string& value) {
    if (!value.empty()) text += fmt::format("  {:<32} {}\n", name, value);
  };
  if (!last.provenance.kernel.empty()) add("state", rest_of(last));
  add("grains", grains_of(snapshot.packing));
  const bool bears =
      std::ranges::any_of(snapshot.packing.domain.wall, [](const auto& wall) { return wall.force != 0; });
  if (bears || last.asked.known) add("forces on the walls", forces_on_sides<D>(snapshot.packing.domain));
  return text;
}

template Numbers state_of(const Snapshot&);
template Numbers state_of(const SnapshotIn<3>&);
template std::string state_text(const StageResult&);
template std::string state_text(const SphereResult&);

}  // namespace arenite::report
