#include "grains/dem/rolling.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "grains/dem/forces.hpp"
#include "grains/dem/kernels/rolling_loop.hpp"

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

/// From j to i, and how long that is, m; at a wall its normal, and 1.
template <int D> std::pair<Vec<D>, double> line_of(const SampleIn<D>& s, std::size_t slot) {
  const std::int32_t j = s.list.j[slot];
  if (j < 0) return {slot_kinematics(s, slot).normal, 1.0};
  const Vec<D> branch = s.record[s.list.i[slot]].place - s.record[j].place;
  return {branch, norm(branch)};
}

/// What a law sees of a slot whose force along the normal is this, N.
template <int D>
RollingGrains<D, double> rolling_grains(const SampleIn<D>& s, std::size_t slot, Vec<D> normal, double normal_force) {
  const auto& a = s.record[s.list.i[slot]];
  const std::int32_t j = s.list.j[slot];
  RollingGrains<D, double> c{normal,
                             normal_force,
                             a.omega,
                             spin_of(s, slot),
                             a.radius,
                             inertia(a),
                             s.list.stiffness[slot],
                             s.list.damping[slot],
                             sense(s, slot)};
  if (j >= 0) {
    const auto& b = s.record[j];
    c.against -= b.omega;
    c.radius = a.radius * b.radius / (a.radius + b.radius);
    c.inertia = inertia(a) * inertia(b) / (inertia(a) + inertia(b));
  } else if (wall_side(j) >= sides_in<D>) {
    c.against -= spin_of_partner(s, j);
  }
  c.against = c.sense * c.against;
  return c;
}

/// Resistance to twisting: what it remembers goes on, and its moment is added. Disks cannot twist.
template <class Law>
void resist_twisting(Sample& /*sample*/, const Law& /*law*/, std::size_t /*slot*/,
                     const RollingGrains<2, double>& /*grains*/) {}
template <class Law>
void resist_twisting(SampleIn<3>& s, const Law& law, std::size_t p, const RollingGrains<3, double>& c) {
  if (s.list.twist_memory.empty()) return;
  double memory = s.list.twist_memory[p];
  const Vec3 moment = twisting_moment(law, c, memory, s.laws.lead, s.laws.lag);
  s.list.force[p].torque_i += moment;
  s.list.force[p].torque_j -= moment;
  s.list.twist_memory[p] = memory;
}
void forget_twist(Sample& /*sample*/, std::size_t /*slot*/) {}
void forget_twist(SampleIn<3>& s, std::size_t p) {
  if (!s.list.twist_memory.empty()) s.list.twist_memory[p] = 0;
}

/// Of one slot, with a wall or with what is neither disk nor wall.
template <int D, class Law> void resist_rolling(SampleIn<D>& s, const Law& law, std::size_t p) {
  SlotForce<D>& force = s.list.force[p];
  const auto [line, length] = acts(force) ? line_of(s, p) : std::pair{Vec<D>{}, 1.0};
  const double normal_force = dot(force.on_i, line) / length;
  if (!(normal_force > 0)) {
    s.list.rolling_memory.put(p, Turning<D>{});
    return forget_twist(s, p);
  }
  const auto c = rolling_grains(s, p, line / length, normal_force);
  Turning<D> memory = s.list.rolling_memory[p];
  const Turning<D> moment = rolling_moment(law, c, memory, s.laws.lead, s.laws.lag);
  force.torque_i += moment;
  force.torque_j -= moment;
  s.list.rolling_memory.put(p, memory);
  resist_twisting(s, law, p, c);
}

double* twist_memory_of(Sample& /*sample*/) { return nullptr; }
double* twist_memory_of(SampleIn<3>& s) {
  return s.list.twist_memory.empty() ? nullptr : s.list.twist_memory.along[0].data();
}

template <int D> RollingTask<D> rolling_task(SampleIn<D>& s) {
  auto& list = s.list;
  return {s.record.data(),     list.i.data(),
          list.j.data(),       list.stiffness.data(),
          list.damping.data(), list.rolling_memory.data(),
          twist_memory_of(s),  list.force.data(),
          s.laws.lead,         s.laws.lag};
}

/// What the spring against twisting holds, J.
template <class Law> double twisting_energy(const Sample& /*sample*/, const Law& /*law*/) { return 0; }
template <class Law> double twisting_energy(const SampleIn<3>& s, const Law& rolling) {
  double sum = 0;
  const Law law = against_twisting(rolling);
  for (std::size_t p = 0; p < s.list.twist_memory.size(); ++p) {
    if (s.list.twist_memory[p] == 0) continue;
    const auto [line, length] = line_of(s, p);
    const auto c = rolling_grains(s, p, line / length, 0.0);
    const double twist = c.sense * dot(c.against, c.normal);
    sum += law.energy(rolling_slip<3>(law, c, twist, s.laws.lead, s.laws.lag), s.list.twist_memory[p]);
  }
  return sum;
}

}  // namespace

template <int D> void add_rolling_moments(SampleIn<D>& s, const ThreadPool& pool) {
  if (s.contact.rolls_freely()) return;
  const RollingTask<D> task = rolling_task(s);
  const auto loop = s.kernel->rolling_loops[s.contact.rolling.index()];
  s.contact.rolling.visit([&](const auto& law) {
    pool.for_ranges(s.list.size(), [&](std::size_t begin, std::size_t end) {
      const std::size_t of_pairs = std::clamp(s.list.pairs, begin, end);
      loop(task, s.contact.rolling, begin, of_pairs);
      for (std::size_t p = of_pairs; p < end; ++p) resist_rolling(s, law, p);
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
      const auto c = rolling_grains(s, p, line / length, 0.0);
      sum += law.energy(rolling_slip<D>(law, c, without_twist(c.against, c.normal), s.laws.lead, s.laws.lag), memory);
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
