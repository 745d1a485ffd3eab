#include "grains/dem/boundaries/boundaries.hpp"
#include "grains/dem/forces.hpp"

namespace arenite::dem {
namespace {

/// +1 or -1, so that a contact turns in one sense however its two grains are listed.
double sense(const Sample& s, std::size_t slot) {
  const std::int32_t j = s.list.j[slot];
  if (j < 0) return 1;
  return s.record[s.list.i[slot]].grain < s.record[j].grain ? 1 : -1;
}

/// What a rolling law sees of a slot.
template <class Law> Slip<double> slip_of(const Sample& s, const Law& law, std::size_t slot, double normal_force) {
  const auto& a = s.record[s.list.i[slot]];
  const std::int32_t j = s.list.j[slot];
  double turning = a.omega, radius = a.radius, inertia_of_both = inertia(a);
  if (j >= 0) {
    const auto& b = s.record[j];
    turning -= b.omega;
    radius = a.radius * b.radius / (a.radius + b.radius);
    inertia_of_both = inertia(a) * inertia(b) / (inertia(a) + inertia(b));
  } else if (is_boundary(j)) {
    turning -= boundary_of(s, j).spin;
  }
  const double stiffness = law.stiffness(s.list.stiffness[slot], radius);
  return {sense(s, slot) * turning,
          law.damping(s.list.damping[slot], radius, stiffness, inertia_of_both),
          std::max(law.coefficient * radius * normal_force, 0.0),
          stiffness,
          s.laws.lead,
          s.laws.lag};
}

/// Force of a slot along its normal; 0 where apart.
double normal_force_of(const Sample& s, std::size_t slot) {
  const SlotForce<2>& force = s.list.force[slot];
  if (!acts(force)) return 0;
  const std::int32_t j = s.list.j[slot];
  if (j < 0) return dot(force.on_i, slot_kinematics(s, slot).normal);
  const Vec2 branch = s.record[s.list.i[slot]].place - s.record[j].place;
  return dot(force.on_i, branch) / norm(branch);
}

}  // namespace

void add_rolling_moments(Sample& s, const ThreadPool& pool) {
  if (s.contact.rolls_freely()) return;
  s.contact.rolling.visit([&](const auto& law) {
    pool.for_ranges(s.list.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t p = begin; p < end; ++p) {
        double& memory = s.list.rolling_memory[p];
        const double normal_force = normal_force_of(s, p);
        if (!(normal_force > 0)) {
          memory = 0;
          continue;
        }
        const double moment = sense(s, p) * law.moment(slip_of(s, law, p, normal_force), memory);
        s.list.force[p].torque_i += moment;
        s.list.force[p].torque_j -= moment;
      }
    });
  });
}

double rolling_energy(const Sample& s) {
  if (s.list.rolling_memory.empty()) return 0;
  double sum = 0;
  s.contact.rolling.visit([&](const auto& law) {
    for (std::size_t p = 0; p < s.list.size(); ++p)
      if (s.list.rolling_memory[p] != 0) sum += law.energy(slip_of(s, law, p, 0), s.list.rolling_memory[p]);
  });
  return sum;
}

}  // namespace arenite::dem
