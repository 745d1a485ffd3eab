#include "grains/lammps/carried.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "grains/dem/advance.hpp"
#include "grains/dem/conditions.hpp"
#include "grains/dem/forces.hpp"
#include "grains/dem/integrators/time_step.hpp"
#include "grains/dem/measure.hpp"
#include "grains/dem/neighbours.hpp"

namespace arenite::lammps {
namespace {

using Key = std::pair<std::int32_t, std::int32_t>;

template <int D> auto sorted(const CarriedIn<D>& carried) {
  auto list = carried.contacts;
  std::ranges::sort(list, {}, [](const auto& c) { return Key(c.i, c.j); });
  return list;
}

/// Which of the sorted contacts joins these two; null for none.
template <class List> auto* joining(const List& list, std::int32_t i, std::int32_t j) {
  const auto key = [](const auto& c) { return Key(c.i, c.j); };
  const auto found = std::ranges::lower_bound(list, Key(i, j), {}, key);
  return found != list.end() && key(*found) == Key(i, j) ? &*found : nullptr;
}

/// Grains and sides where they came to. Sides that a load drives are at rest then.
template <int D> void move_there(dem::SampleIn<D>& s, const CarriedIn<D>& carried) {
  dem::synchronise(s);
  for (int side = 0; side < sides_in<D>; ++side) {
    s.domain.wall[side].position = carried.domain.wall[side].position;
    if (s.wall[side].drive.kind != dem::DriveKind::force) continue;
    s.domain.wall[side].velocity = s.wall[side].rate = s.wall[side].drift = 0;
  }
  const auto cell = dem::cell_motion(s.domain);
  for (std::size_t k = 0; k < s.count; ++k) {
    dem::GrainRecord<D>& record = s.record[k];
    const auto grain = static_cast<std::size_t>(record.grain);
    record.place = carried.position[grain];
    record.velocity = carried.velocity[grain] + cell.at(record.place);
    record.omega = carried.omega[grain];
    s.velocity.put(k, carried.velocity[grain]);
    s.omega.put(k, carried.omega[grain]);
  }
  s.step += carried.steps;
  dem::rebuild_list(s);
}

/// Forces of now, with the springs as the list remembers them.
template <int D> void compute_now(dem::SampleIn<D>& s) {
  s.laws.lead = -s.laws.lag;
  dem::compute_forces(s);
  dem::sum_edge_forces(s);
  s.laws = dem::laws_between_steps(s);
}

/// Sets the springs of friction of contacts that touch to what `spring(slot, kinematics)` gives, m.
template <int D, class Spring> void set_springs(dem::SampleIn<D>& s, const Spring& spring) {
  for (std::size_t p = 0; p < s.list.size(); ++p)
    if (const dem::Kinematics<D> at = dem::slot_kinematics(s, p); at.overlap > 0)
      s.list.memory.put(p, spring(p, at) + s.laws.lag * at.sliding);
}

/// The force of LAMMPS on the first grain of a slot; nothing where the two do not touch there.
template <int D, class List>
std::optional<Vec<D>> their_force(const dem::SampleIn<D>& s, const List& list, std::size_t slot) {
  const std::int32_t i = s.record[s.list.i[slot]].grain;
  const std::int32_t j = s.list.j[slot] < 0 ? s.list.j[slot] : s.record[s.list.owner[slot]].grain;
  const bool swapped = j >= 0 && j < i;
  const auto* const known = swapped ? joining(list, j, i) : joining(list, i, j);
  if (!known) return std::nullopt;
  return swapped ? -known->on_i : known->on_i;
}

/// Lays the springs that give LAMMPS's forces: what its force along a contact is more than our dashpot's at the same
/// speeds without any spring. How many contacts one of the two lacks comes with them.
template <int D> std::size_t lay_springs(dem::SampleIn<D>& s, const CarriedIn<D>& carried) {
  set_springs(s, [](std::size_t, const auto&) { return Turning<D>{}; });
  compute_now(s);
  const auto list = sorted(carried);
  std::size_t common = 0, ours = 0;
  s.laws.visit([&](const auto& normal, const auto&, const auto& friction) {
    set_springs(s, [&](std::size_t p, const dem::Kinematics<D>& at) {
      ++ours;
      const auto theirs = their_force(s, list, p);
      common += theirs ? 1 : 0;
      const double kt = dem::sliding_stiffness(s, normal, p, at);
      if (!friction.remembers || !theirs || kt <= 0) return Turning<D>{};
      return Turning<D>((-1 / kt) * cross(at.normal, *theirs - s.list.force[p].on_i));
    });
  });
  compute_now(s);
  return ours + list.size() - 2 * common;
}

/// The resultants on the grains by our own law, N.
template <int D> std::vector<Vec<D>> resultants(const dem::SampleIn<D>& s, const PackingIn<D>& now) {
  std::vector<Vec<D>> force(now.grains.size());
  for (std::size_t k = 0; k < s.count; ++k)
    force[s.record[k].grain] = s.record[k].mass * (s.gravity - s.drag * s.record[k].velocity);
  const ContactsIn<D>& c = now.contacts;
  for (std::size_t k = 0; k < c.size(); ++k) {
    const Vec<D> f = c.force_on_i(k);
    force[c.i[k]] += f;
    if (!c.is_wall(k)) force[c.j[k]] -= f;
  }
  return force;
}

template <int D> double mean_force(const ContactsIn<D>& contacts) {
  double sum = 0;
  for (const double fn : contacts.fn) sum += std::abs(fn);
  return contacts.size() > 0 ? sum / static_cast<double>(contacts.size()) : 0;
}

}  // namespace

template <int D> Agreement take_over(dem::EngineIn<D>& engine, const CarriedIn<D>& carried) {
  move_there<D>(engine, carried);
  Agreement agreement;
  agreement.not_there = lay_springs<D>(engine, carried);
  const PackingIn<D> now = dem::packing_of<D>(engine);
  agreement.contacts = now.contacts.size();
  const auto own = resultants<D>(engine, now);
  const double mean = mean_force<D>(now.contacts);
  for (std::size_t k = 0; k < own.size() && mean > 0; ++k)
    agreement.largest = std::max(agreement.largest, norm(own[k] - carried.force[k]) / mean);
  agreement.unbalanced = dem::equilibrium_of<D>(engine).unbalanced_ratio;
  return agreement;
}

#define ARENITE_OF(D) template Agreement take_over(dem::EngineIn<D>&, const CarriedIn<D>&);
ARENITE_OF(2)
ARENITE_OF(3)
#undef ARENITE_OF

}  // namespace arenite::lammps
