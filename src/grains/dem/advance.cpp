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
template <class N, class F> void end_open_bonds(Sample& s, const N& normal, const F& friction) {
  for (std::size_t p = 0; p < s.list.pairs; ++p) {
    if (!(s.list.strength[p] > 0)) continue;
    auto& bond = s.list.bond[p];
    if (slot_kinematics(s, p).overlap > 0) {
      bond = touching;
    } else if (bond == touching) {
      bond = never_touched;
      s.list.strength[p] = 0;
      s.live_bonds.erase(std::lower_bound(s.live_bonds.begin(), s.live_bonds.end(), slot_key(s, p)));
      const double lost = friction.energy(s.laws.slip(0, sliding_stiffness(s, normal, p, {})), s.list.memory[p]);
      s.tally.dissipated_breakage += lost;
      s.tally.dissipated_friction -= lost;
    }
  }
}

double lowest_force(const Sample& s) { return s.contact.attractive_dashpot ? -std::numeric_limits<double>::infinity() : 0.0; }

PairTask<2> pair_task(Sample& s) {
  ContactList& list = s.list;
  return {s.record.data(),      list.i.data(),
          list.j.data(),        list.stiffness.data(),
          list.damping.data(),  list.viscosity.data(),
          list.strength.data(), list.shear.data(),
          {list.memory.data()}, list.normal_memory.data(),
          list.force.data(),    s.friction,
          lowest_force(s),      s.contact.arms == Arms::contact_point ? 0.5 : 0.0};
}

/// Wall slots begin .. end-1, counted from the first.
template <class N, class A, class F> void evaluate_walls(Sample& s, const N& normal, const A& adhesion, const F& friction, std::size_t begin, std::size_t end) {
  ContactList& list = s.list;
  const double floor = lowest_force(s);
  for (std::size_t p = list.pairs + begin; p < list.pairs + end; ++p) {
    const Kinematics<2> c = slot_kinematics(s, p);
    SlotForce<2> force;
    ContactMemory<double> memory;
    if (c.overlap > 0) {
      memory = {N::remembers ? list.normal_memory[p] : 0.0, list.memory[p]};
      const ContactState<double> state{c.overlap,         c.approach,       c.sliding,       c.curvature, list.stiffness[p], list.damping[p],
                                       list.viscosity[p], list.strength[p], s.wall_friction, floor,       list.shear[p]};
      force = c.force(contact_force(s.laws, normal, adhesion, friction, state, memory));
    }
    list.force[p] = force;
    list.memory[p] = memory.slip;
    if constexpr (N::remembers) list.normal_memory[p] = memory.normal;
  }
}

/// A wall slot, computed alone, takes as long as this many pairs.
constexpr std::size_t pairs_of_a_wall = 4;

/// All slots in one go of the pool: pairs, then walls.
template <class N, class A, class F> void evaluate(Sample& s, const ThreadPool& pool, const N& normal, const A& adhesion, const F& friction) {
  const PairTask<2> task = pair_task(s);
  const auto loop = s.kernel->pair_loops[loop_index(s.laws)];
  const std::size_t pairs = s.list.pairs, walls = s.list.size() - pairs;
  pool.for_ranges(pairs + pairs_of_a_wall * walls, [&](std::size_t begin, std::size_t end) {
    if (begin < pairs) loop(task, s.laws, begin, std::min(end, pairs));
    if (end > pairs) evaluate_walls(s, normal, adhesion, friction, (std::max(begin, pairs) - pairs) / pairs_of_a_wall, (end - pairs) / pairs_of_a_wall);
  });
}

/// The force that the grains exert on a wall is the opposite of the wall's on them.
void sum_wall_forces(Sample& s) {
  const ContactList& list = s.list;
  for (auto& wall : s.domain.wall)
    if (wall.present) wall.force = wall.shear_force = 0;
  for (std::size_t p = list.pairs; p < list.size(); ++p) {
    const int side = wall_side(list.j[p]);
    if (side > top) continue;
    s.domain.wall[side].force += dot(list.force[p].on_i, inward_normal(side));
    s.domain.wall[side].shear_force -= along(side, list.force[p].on_i);
  }
  for (std::size_t h = 0; h < s.held.size(); ++h) {
    const int side = s.held[h].side;
    const Vec2 force = contact_load(slot_forces(list), s.held_disk[h]).force;
    s.domain.wall[side].force -= dot(force, inward_normal(side));
    s.domain.wall[side].shear_force += along(side, force);
  }
}

/// Vector from j (or the plane of the wall) to i.
Vec2 branch_of(const Sample& s, std::size_t slot) {
  const std::int32_t j = s.list.j[slot];
  return between_centres(s, slot, j < 0 ? slot_kinematics(s, slot).branch : s.record[s.list.i[slot]].place - s.record[j].place);
}

/// Sum over all contacts and bonds of force times branch; by blocks of slots, so that it does not depend on the number of threads.
Tensor2 sum_of_moments(const Sample& s, const ThreadPool& pool) {
  constexpr std::size_t slots_of_block = 512;
  const ContactList& list = s.list;
  const auto blocks = pool.by_blocks<Tensor2>(list.size(), slots_of_block, [&](std::size_t p, Tensor2& sum) {
    if (acts(list.force[p])) sum += outer(list.force[p].on_i, branch_of(s, p));
  });
  Tensor2 sum;
  for (const Tensor2& block : blocks) sum += block;
  for (std::size_t b = 0; b < s.bond_slots.size(); ++b)
    if (const SlotForce<2>& f = list.force[bond_force_place(list, b)]; acts(f)) sum += outer(f.on_i, beam_motion(s, s.bond_slots[b]).branch);
  return sum;
}

}  // namespace

void compute_forces(Sample& s, const ThreadPool& pool) {
  hand_over_memories(s);
  s.laws.visit([&](const auto& normal, const auto& adhesion, const auto& friction) {
    if (!s.live_bonds.empty()) end_open_bonds(s, normal, friction);
    evaluate(s, pool, normal, adhesion, friction);
  });
  add_rolling_moments(s, pool);
  take_torques_to_owners(s, pool);
  add_cohesion(s, pool);
  add_bond_forces(s, pool);
  sum_wall_forces(s);
  sum_boundary_forces(s);
}

void sum_edge_forces(Sample& s, const ThreadPool& pool) {
  if (!s.domain.is_cell()) return;
  const Tensor2 sum = sum_of_moments(s, pool);
  const auto give = [](Wall& low, Wall& high, double normal, double tangential) {
    low.force = high.force = normal;
    high.shear_force = tangential;
    low.shear_force = -tangential;
  };
  auto& w = s.domain.wall;
  if (s.domain.periodic[0]) give(w[left], w[right], sum.xx / s.domain.width(), sum.yx / s.domain.width());
  if (s.domain.periodic[1]) give(w[bottom], w[top], sum.yy / s.domain.height(), sum.xy / s.domain.height());
}

void Engine::advance(std::int64_t steps) {
  Sample& s = machine_->sample;
  const ThreadPool& pool = machine_->pool;
  if (steps <= 0) return;
  if (const auto start = integrator_of(s).start) start(s);
  const bool tracked = s.integration.track_energy, programmed = !s.programmes.list.empty();
  bool edges = tracked;
  for (int side = 0; side < sides; ++side) edges |= !s.domain.wall[side].present && s.wall[side].drive.kind == WallDrive::Kind::force;
  if (tracked && !s.balance.open) open_balance(s);
  for (std::int64_t n = 0; n < steps; ++n) {
    if (programmed) follow_velocities(s);
    const bool near = make_step(s, pool);
    if (programmed) follow_loads(s);
    follow_drift(s);
    if (near) refresh_ghosts(s);
    else rebuild_list(s, pool);
    compute_forces(s, pool);
    if (edges) sum_edge_forces(s, pool);
    if (tracked) book_step(s);
  }
  sum_edge_forces(s, pool);
}

}  // namespace arenite::dem
