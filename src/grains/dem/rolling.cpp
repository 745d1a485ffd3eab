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

/// How the grains of a slot turn against each other, rad/s, and what a law needs of them.
template <int D> struct Turn {
  Turning<D> against{};
  double radius = 0, inertia = 0;
};
template <int D> Turn<D> turn_of(const SampleIn<D>& s, std::size_t slot) {
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
  return {sense(s, slot) * turning, radius, inertia_of_both};
}

/// What a law sees of a slot that turns so.
template <int D, class Law, class T>
Slip<double, T> slip_of(const SampleIn<D>& s, const Law& law, std::size_t slot, const Turn<D>& turn, T turning,
                        double normal_force) {
  const double stiffness = law.stiffness(s.list.stiffness[slot], turn.radius);
  return {turning,
          law.damping(s.list.damping[slot], turn.radius, stiffness, turn.inertia),
          std::max(law.coefficient * turn.radius * normal_force, 0.0),
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

/// Of that the part about the line between them, the same however the two grains are listed.
double twist_of(const SampleIn<3>& s, std::size_t slot, const Turn<3>& turn, Vec3 normal) {
  return sense(s, slot) * dot(turn.against, normal);
}

/// Resistance to twisting: what it remembers goes on, and its moment is added. Disks cannot twist.
template <class Law>
void resist_twisting(Sample& /*sample*/, const Law& /*law*/, std::size_t /*slot*/, Vec2 /*normal*/,
                     double /*normal_force*/) {}
template <class Law>
void resist_twisting(SampleIn<3>& s, const Law& rolling, std::size_t p, Vec3 normal, double normal_force) {
  if (s.list.twist_memory.empty()) return;
  double memory = 0;
  if (normal_force > 0) {
    const Law law = against_twisting(rolling);
    const Turn<3> turn = turn_of(s, p);
    memory = s.list.twist_memory[p];
    const Slip<double> slip = slip_of(s, law, p, turn, twist_of(s, p, turn, normal), normal_force);
    const Vec3 moment = law.moment(slip, memory) * normal;
    s.list.force[p].torque_i += moment;
    s.list.force[p].torque_j -= moment;
  }
  s.list.twist_memory[p] = memory;
}

/// What the spring against twisting holds, J.
template <class Law> double twisting_energy(const Sample& /*sample*/, const Law& /*law*/) { return 0; }
template <class Law> double twisting_energy(const SampleIn<3>& s, const Law& rolling) {
  double sum = 0;
  const Law law = against_twisting(rolling);
  for (std::size_t p = 0; p < s.list.twist_memory.size(); ++p) {
    if (s.list.twist_memory[p] == 0) continue;
    const auto [line, length] = line_of(s, p);
    const Turn<3> turn = turn_of(s, p);
    sum += law.energy(slip_of(s, law, p, turn, twist_of(s, p, turn, line / length), 0), s.list.twist_memory[p]);
  }
  return sum;
}

}  // namespace

template <int D> void add_rolling_moments(SampleIn<D>& s, const ThreadPool& pool) {
  if (s.contact.rolls_freely()) return;
  s.contact.rolling.visit([&](const auto& law) {
    pool.for_ranges(s.list.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t p = begin; p < end; ++p) {
        SlotForce<D>& force = s.list.force[p];
        Turning<D> memory{};
        Vec<D> normal;
        double normal_force = 0;
        if (acts(force)) {
          const auto [line, length] = line_of(s, p);
          normal = line / length;
          normal_force = dot(force.on_i, line) / length;
        }
        if (normal_force > 0) {
          const Turning<D> spin = spin_of(s, p);
          const Turn<D> turn = turn_of(s, p);
          memory = turned_along(s.list.rolling_memory[p], normal, spin, s.laws.lead);
          const auto slip = slip_of(s, law, p, turn, without_twist(turn.against, normal), normal_force);
          const Turning<D> moment = sense(s, p) * law.moment(slip, memory);
          memory = turned_along(memory, normal, spin, s.laws.lag);
          force.torque_i += moment;
          force.torque_j -= moment;
        }
        resist_twisting(s, law, p, normal, normal_force);
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
      const Turn<D> turn = turn_of(s, p);
      sum += law.energy(slip_of(s, law, p, turn, without_twist(turn.against, line / length), 0), memory);
    }
    sum += twisting_energy(s, law);
  });
  return sum;
}

template void add_rolling_moments(SampleIn<2>&, const ThreadPool&);
template void add_rolling_moments(SampleIn<3>&, const ThreadPool&);
template double rolling_energy(const SampleIn<2>&);
template double rolling_energy(const SampleIn<3>&);

}  // namespace arenite::dem
