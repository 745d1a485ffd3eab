#include "grains/dem/forces.hpp"

#include <algorithm>
#include <limits>

#include "grains/dem/bodies/bodies.hpp"
#include "grains/dem/bonds.hpp"
#include "grains/dem/boundaries/boundaries.hpp"
#include "grains/dem/neighbours.hpp"
#include "grains/dem/setup.hpp"
#include "grains/dem/walls.hpp"

namespace arenite::dem {
namespace {

/// Ends the bonds that break for good where their contact has opened; the energy of the tangential spring is lost.
template <int D, class N, class F> void end_open_bonds(SampleIn<D>& s, const N& normal, const F& friction) {
  for (std::size_t p = 0; p < s.list.pairs; ++p) {
    if (!(s.list.strength[p] > 0)) continue;
    auto& bond = s.list.bond[p];
    if (slot_kinematics(s, p).overlap > 0) {
      bond = touching;
    } else if (bond == touching) {
      bond = never_touched;
      s.list.strength[p] = 0;
      s.live_bonds.erase(std::lower_bound(s.live_bonds.begin(), s.live_bonds.end(), slot_key(s, p)));
      const double lost = friction.energy(s.laws.slip(Turning<D>{}, sliding_stiffness(s, normal, p, Kinematics<D>{})),
                                          s.list.memory[p]);
      s.tally.dissipated_breakage += lost;
      s.tally.dissipated_friction -= lost;
    }
  }
}

template <int D> double lowest_force(const SampleIn<D>& s) {
  return s.contact.attractive_dashpot ? -std::numeric_limits<double>::infinity() : 0.0;
}

template <int D> PairTask<D> pair_task(SampleIn<D>& s) {
  ContactListIn<D>& list = s.list;
  return {s.record.data(),      list.i.data(),
          list.j.data(),        list.stiffness.data(),
          list.damping.data(),  list.viscosity.data(),
          list.strength.data(), list.shear.data(),
          list.memory.data(),   list.normal_memory.data()[0],
          list.force.data(),    s.friction,
          lowest_force(s),      s.contact.arms == Arms::contact_point ? 0.5 : 0.0};
}

/// Wall slots begin .. end-1, counted from the first.
template <int D, class N, class A, class F>
void evaluate_walls(SampleIn<D>& s, const N& normal, const A& adhesion, const F& friction, std::size_t begin,
                    std::size_t end) {
  using T = Turning<D>;
  ContactListIn<D>& list = s.list;
  const double floor = lowest_force(s);
  for (std::size_t p = list.pairs + begin; p < list.pairs + end; ++p) {
    const Kinematics<D> c = slot_kinematics(s, p);
    SlotForce<D> force;
    ContactMemory<double, T> memory;
    if (c.overlap > 0) {
      const T spin = spin_of(s, p);
      memory = {N::remembers ? list.normal_memory[p] : 0.0, turned_along(list.memory[p], c.normal, spin, s.laws.lead)};
      const ContactState<double, T> state{c.overlap,         c.approach,      c.sliding,         c.curvature,
                                          list.stiffness[p], list.damping[p], list.viscosity[p], list.strength[p],
                                          s.wall_friction,   floor,           list.shear[p]};
      force = c.force(contact_force(s.laws, normal, adhesion, friction, state, memory));
      memory.slip = turned_along(memory.slip, c.normal, spin, s.laws.lag);
    }
    list.force[p] = force;
    list.memory.put(p, memory.slip);
    if constexpr (N::remembers) list.normal_memory[p] = memory.normal;
  }
}

/// A wall slot, computed alone, takes as long as this many pairs.
constexpr std::size_t pairs_of_a_wall = 4;

/// All slots in one go of the pool: pairs, then walls.
template <int D, class N, class A, class F>
void evaluate(SampleIn<D>& s, const ThreadPool& pool, const N& normal, const A& adhesion, const F& friction) {
  const PairTask<D> task = pair_task(s);
  const auto loop = s.kernel->pair_loops[loop_index(s.laws)];
  const std::size_t pairs = s.list.pairs, walls = s.list.size() - pairs;
  pool.for_ranges(pairs + pairs_of_a_wall * walls, [&](std::size_t begin, std::size_t end) {
    if (begin < pairs) loop(task, s.laws, begin, std::min(end, pairs));
    if (end > pairs)
      evaluate_walls(s, normal, adhesion, friction, (std::max(begin, pairs) - pairs) / pairs_of_a_wall,
                     (end - pairs) / pairs_of_a_wall);
  });
}

/// The force that the grains exert on a wall is the opposite of the wall's on them.
template <int D> void sum_wall_forces(SampleIn<D>& s) {
  const ContactListIn<D>& list = s.list;
  for (auto& wall : s.domain.wall)
    if (wall.present) wall.force = 0, wall.shear_force = {};
  const auto add = [&](int side, Vec<D> on_grain) {
    s.domain.wall[side].force += dot(on_grain, inward_normal<D>(side));
    s.domain.wall[side].shear_force -= along(side, on_grain);
  };
  for (std::size_t p = list.pairs; p < list.size(); ++p)
    if (const int side = wall_side(list.j[p]); side < sides_in<D>) add(side, list.force[p].on_i);
  if constexpr (D == 2)
    for (std::size_t h = 0; h < s.held.size(); ++h)
      add(s.held[h].side, -contact_load(slot_forces(list), s.held_disk[h]).force);
}

/// Sums over all contacts and bonds of force times branch, by the branch's axis; by blocks of slots, so that they do
/// not depend on the number of threads.
template <int D> std::array<Vec<D>, D> sum_of_moments(const SampleIn<D>& s, const ThreadPool& pool) {
  using Moments = std::array<Vec<D>, D>;
  constexpr std::size_t slots_of_block = 512;
  const ContactListIn<D>& list = s.list;
  const auto add = [](Moments& sum, Vec<D> force, Vec<D> branch) {
    for (int axis = 0; axis < D; ++axis) sum[axis] += branch[axis] * force;
  };
  const auto blocks = pool.by_blocks<Moments>(list.size(), slots_of_block, [&](std::size_t p, Moments& sum) {
    if (!acts(list.force[p])) return;
    const std::int32_t j = list.j[p];
    const Vec<D> branch = j < 0 ? slot_kinematics(s, p).branch : s.record[list.i[p]].place - s.record[j].place;
    add(sum, list.force[p].on_i, between_centres(s, p, branch));
  });
  Moments sum{};
  for (const Moments& block : blocks)
    for (int axis = 0; axis < D; ++axis) sum[axis] += block[axis];
  if constexpr (D == 2)
    for (std::size_t b = 0; b < s.bond_slots.size(); ++b)
      if (const SlotForce<2>& f = list.force[bond_force_place(list, b)]; acts(f))
        add(sum, f.on_i, beam_motion(s, s.bond_slots[b]).branch);
  return sum;
}

}  // namespace

template <int D> void compute_forces(SampleIn<D>& s, const ThreadPool& pool) {
  if constexpr (D == 2) hand_over_memories(s);
  s.laws.visit([&](const auto& normal, const auto& adhesion, const auto& friction) {
    if (!s.live_bonds.empty()) end_open_bonds(s, normal, friction);
    evaluate(s, pool, normal, adhesion, friction);
  });
  add_rolling_moments(s, pool);
  if constexpr (D == 2) {
    take_torques_to_owners(s, pool);
    add_cohesion(s, pool);
    add_bond_forces(s, pool);
    sum_boundary_forces(s);
  }
  sum_wall_forces(s);
}

template <int D> void sum_edge_forces(SampleIn<D>& s, const ThreadPool& pool) {
  if (!s.domain.is_cell()) return;
  const auto sum = sum_of_moments(s, pool);
  for (int axis = 0; axis < D; ++axis) {
    if (!s.domain.periodic[axis]) continue;
    const Vec<D> force = sum[axis] / s.domain.extent(axis);
    for (int side = 2 * axis; side < 2 * axis + 2; ++side) {
      s.domain.wall[side].force = across(side, force);
      s.domain.wall[side].shear_force = -inward_sign(side) * along(side, force);
    }
  }
}

template <int D> void advance(SampleIn<D>& s, const ThreadPool& pool, std::int64_t steps) {
  if (steps <= 0) return;
  if constexpr (D == 2) follow_driving(s);
  if (const auto start = std::get<OwnSteps<D>>(integrator_of(s).own).start) start(s);
  const bool tracked = s.integration.track_energy;
  bool edges = tracked;
  for (int side = 0; side < sides_in<D>; ++side)
    edges |= !s.domain.wall[side].present && s.wall[side].drive.kind == DriveKind::force;
  if constexpr (D == 2)
    if (tracked && !s.balance.open) open_balance(s);
  for (std::int64_t n = 0; n < steps; ++n) {
    if constexpr (D == 2) follow_velocities(s);
    const bool near = make_step(s, pool);
    if constexpr (D == 2) follow_loads(s);
    follow_drift(s);
    if (near) refresh_ghosts(s);
    else rebuild_list(s, pool);
    compute_forces(s, pool);
    if (edges) sum_edge_forces(s, pool);
    if constexpr (D == 2)
      if (tracked) book_step(s);
  }
  sum_edge_forces(s, pool);
}

template void compute_forces(SampleIn<2>&, const ThreadPool&);
template void compute_forces(SampleIn<3>&, const ThreadPool&);
template void sum_edge_forces(SampleIn<2>&, const ThreadPool&);
template void sum_edge_forces(SampleIn<3>&, const ThreadPool&);
template void advance(SampleIn<3>&, const ThreadPool&, std::int64_t);

void Engine::advance(std::int64_t steps) { dem::advance(machine_->sample, machine_->pool, steps); }

}  // namespace arenite::dem
