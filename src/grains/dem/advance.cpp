#include "grains/dem/advance.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include "grains/dem/forces.hpp"
#include "grains/dem/glue.hpp"
#include "grains/dem/movers.hpp"
#include "grains/dem/neighbours.hpp"
#include "grains/dem/rolling.hpp"

namespace arenite::dem {
namespace {

template <int D> double lowest_force(const SampleIn<D>& s) {
  return s.contact.attractive_dashpot ? -std::numeric_limits<double>::infinity() : 0.0;
}

template <int D> PairTask<D> pair_task(SampleIn<D>& s) {
  ContactListIn<D>& list = s.list;
  return {s.record.data(),       list.i.data(),
          list.j.data(),         list.stiffness.data(),
          list.damping.data(),   list.viscosity.data(),
          list.strength.data(),  list.shear.data(),
          list.memory.data(),    list.normal_memory.data()[0],
          list.force.data(),     s.friction,
          lowest_force(s),       s.contact.arms == Arms::contact_point ? 0.5 : 0.0,
          list.outgrows_caches()};
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
  for (std::size_t p = list.pairs; p < list.size(); ++p)
    if (const int side = wall_side(list.j[p]); side < sides_in<D>) push_wall(s, side, list.force[p].on_i);
  each_part(s, [&](const auto& part) { part.add_to_walls(s); });
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
  each_part(s, [&](const auto& part) { part.add_moments(s, sum); });
  return sum;
}

}  // namespace

template <int D> void compute_forces(SampleIn<D>& s, const ThreadPool& pool) {
  each_part(s, [&](auto& part) { part.before_forces(s); });
  end_opened_glue(s);
  s.laws.visit([&](const auto& normal, const auto& adhesion, const auto& friction) {
    evaluate(s, pool, normal, adhesion, friction);
  });
  add_rolling_moments(s, pool);
  each_part(s, [&](auto& part) { part.add_forces(s, pool); });
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
  each_part(s, [&](auto& part) { part.prepare(s); });
  if (const auto start = std::get<OwnSteps<D>>(integrator_of(s).own).start) start(s);
  bool edges = s.integration.track_energy;
  for (int side = 0; side < sides_in<D>; ++side)
    edges |= !s.domain.wall[side].present && s.wall[side].drive.kind == DriveKind::force;
  each_part(s, [&](auto& part) { part.begin(s); });
  for (std::int64_t n = 0; n < steps; ++n) {
    each_part(s, [&](auto& part) { part.before_step(s); });
    const bool near = make_step(s, pool);
    each_part(s, [&](auto& part) { part.after_step(s); });
    follow_drift(s);
    if (near) refresh_ghosts(s);
    else rebuild_list(s, pool);
    compute_forces(s, pool);
    if (edges) sum_edge_forces(s, pool);
    each_part(s, [&](auto& part) { part.after_forces(s); });
  }
  sum_edge_forces(s, pool);
}

template void advance(SampleIn<2>&, const ThreadPool&, std::int64_t);
template void advance(SampleIn<3>&, const ThreadPool&, std::int64_t);
template void compute_forces(SampleIn<2>&, const ThreadPool&);
template void compute_forces(SampleIn<3>&, const ThreadPool&);
template void sum_edge_forces(SampleIn<2>&, const ThreadPool&);
template void sum_edge_forces(SampleIn<3>&, const ThreadPool&);

}  // namespace arenite::dem
