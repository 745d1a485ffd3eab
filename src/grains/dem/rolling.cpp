#include "grains/dem/rolling.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "grains/dem/forces.hpp"

namespace arenite::dem {
namespace {

/// +1 or -1, so that a contact turns in one sense however its two grains are listed.
template <int D> double sense(const SampleIn<D>& s, std::size_t slot) {
  const std::int32_t j = s.list.j[slot];
  if (j < 0) return 1;
  return s.record[s.list.i[slot]].grain < s.record[j].grain ? 1 : -1;
}

/// Of what is neither disk nor wall, rad/s.
template <int D> [[gnu::noinline]] Turning<D> spin_of_partner(const SampleIn<D>& s, std::int32_t partner) {
  Turning<D> spin{};
  each_part(s, [&](const auto& part) { spin += part.spin_of(s, partner); });
  return spin;
}

/// What a rolling law sees of a slot.
template <int D, class Law>
Slip<double, Turning<D>> slip_of(const SampleIn<D>& s, const Law& law, std::size_t slot, Vec<D> normal,
                                 double normal_force) {
  const auto& a = s.record[s.list.i[slot]];
  const std::int32_t j = s.list.j[slot];
  Turning<D> turning = a.omega;
  double radius = a.radius, inertia_of_both = inertia(a);
  if (j >= 0) {
    const auto& b = s.record[j];
    turning -= b.omega;
    radius = a.radius * b.radius / (a.radius + b.radius);
    inertia_of_both = inertia(a) * inertia(b) / (inertia(a) + inertia(b));
  } else if (wall_side(j) >= sides_in<D>) {
    turning -= spin_of_partner(s, j);
  }
  const double stiffness = law.stiffness(s.list.stiffness[slot], radius);
  return {sense(s, slot) * without_twist(turning, normal),
          law.damping(s.list.damping[slot], radius, stiffness, inertia_of_both),
          std::max(law.coefficient * radius * normal_force, 0.0),
          stiffness,
          s.laws.lead,
          s.laws.lag};
}

/// From j to i, and how long that is, m; at a wall its normal, and 1.
template <int D> std::pair<Vec<D>, double> line_of(const SampleIn<D>& s, std::size_t slot) {
  const std::int32_t j = s.list.j[slot];
  if (j < 0) return {slot_kinematics(s, slot).normal, 1.0};
  const Vec<D> branch = s.record[s.list.i[slot]].place - s.record[j].place;
  return {branch, norm(branch)};
}

}  // namespace

template <int D> void add_rolling_moments(SampleIn<D>& s, const ThreadPool& pool) {
  if (s.contact.rolls_freely()) return;
  s.contact.rolling.visit([&](const auto& law) {
    pool.for_ranges(s.list.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t p = begin; p < end; ++p) {
        SlotForce<D>& force = s.list.force[p];
        Turning<D> memory{};
        if (acts(force)) {
          const auto [line, length] = line_of(s, p);
          const Vec<D> normal = line / length;
          if (const double normal_force = dot(force.on_i, line) / length; normal_force > 0) {
            const Turning<D> spin = spin_of(s, p);
            memory = turned_along(s.list.rolling_memory[p], normal, spin, s.laws.lead);
            const Turning<D> moment = sense(s, p) * law.moment(slip_of(s, law, p, normal, normal_force), memory);
            memory = turned_along(memory, normal, spin, s.laws.lag);
            force.torque_i += moment;
            force.torque_j -= moment;
          }
        }
        s.list.rolling_memory.put(p, memory);
      }
    });
  });
}

template <int D> double rolling_energy(const SampleIn<D>& s) {
  double sum = 0;
  s.contact.rolling.visit([&](const auto& law) {
    for (std::size_t p = 0; p < s.list.rolling_memory.size(); ++p) {
      const Turning<D> memory = s.list.rolling_memory[p];
      if (memory == Turning<D>{}) continue;
      const auto [line, length] = line_of(s, p);
      sum += law.energy(slip_of(s, law, p, line / length, 0), memory);
    }
  });
  return sum;
}

template void add_rolling_moments(SampleIn<2>&, const ThreadPool&);
template void add_rolling_moments(SampleIn<3>&, const ThreadPool&);
template double rolling_energy(const SampleIn<2>&);
template double rolling_energy(const SampleIn<3>&);

}  // namespace arenite::dem
