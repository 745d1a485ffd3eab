#include "grains/dem/exchange/change_grains.hpp"

#include <algorithm>
#include <numeric>

#include "grains/dem/advance.hpp"
#include "grains/dem/conditions.hpp"
#include "grains/dem/integrators/time_step.hpp"
#include "grains/dem/measure.hpp"
#include "grains/dem/neighbours.hpp"

namespace arenite::dem {
namespace {

using Numbers = std::vector<std::int32_t>;

/// Calls `see` with each array over the inner disks beside the records.
template <class See> void each_array(Sample& s, const See& see) {
  each_motion_array(s, see);
  for (auto& derivatives : s.higher)
    for (auto& values : derivatives.along)
      if (!values.empty()) see(values);
}

void put_at_rest(Sample& s, std::size_t k, Vec2 place, Vec2 velocity) {
  DiskRecord& d = s.record[k];
  each_array(s, [&](std::vector<double>& values) { values[k] = 0; });
  d.place = place;
  d.velocity = velocity;
  d.omega = 0;
  s.velocity.put(k, velocity - cell_motion(s.domain).at(place));
}

void move(Sample& s, const MovedGrain& moved) {
  const std::int32_t grain = s.record[moved.disk].grain;
  s.start.grains.id[grain] = s.exchanged.next_id++;
  s.start.grains.position[grain] = moved.place;
  put_at_rest(s, static_cast<std::size_t>(moved.disk), moved.place, moved.velocity);
}

/// Those of so many that are not named, in order.
Numbers others(std::size_t count, const Numbers& named) {
  std::vector<bool> gone(count, false);
  for (const std::int32_t k : named) gone[k] = true;
  Numbers kept;
  for (std::size_t k = 0; k < count; ++k)
    if (!gone[k]) kept.push_back(static_cast<std::int32_t>(k));
  return kept;
}

template <class T> void keep(std::vector<T>& values, const Numbers& kept) {
  for (std::size_t k = 0; k < kept.size(); ++k) values[k] = values[kept[k]];
  values.resize(kept.size());
}

/// Returns the former inner numbers of the disks that stay.
Numbers remove(Sample& s, const Numbers& disks) {
  s.record.resize(s.count);
  const Numbers kept = others(s.count, disks);
  Numbers grains;
  for (const std::int32_t k : disks) grains.push_back(s.record[k].grain);
  const Numbers kept_grains = others(s.start.grains.size(), grains);
  Numbers place(s.start.grains.size(), 0);
  for (std::size_t g = 0; g < kept_grains.size(); ++g) place[kept_grains[g]] = static_cast<std::int32_t>(g);
  s.start.grains = picked(s.start.grains, kept_grains);
  keep(s.record, kept);
  each_array(s, [&](std::vector<double>& values) { keep(values, kept); });
  for (DiskRecord& d : s.record) d.grain = place[d.grain];
  s.count = kept.size();
  return kept;
}

void add(Sample& s, const NewGrain& added) {
  Grains& g = s.start.grains;
  const std::size_t grain = g.size(), k = s.count++;
  g.resize(grain + 1);
  g.id[grain] = s.exchanged.next_id++;
  g.position[grain] = added.place;
  g.radius[grain] = added.radius;
  g.material[grain] = added.material;
  s.largest_radius = std::max(s.largest_radius, added.radius);
  s.record.resize(s.count);
  s.record[k] = {added.place, added.velocity, 0, added.radius, 0, added.material, static_cast<std::int32_t>(grain)};
  s.record[k].mass = own_mass(s, s.record[k].grain);
  each_array(s, [&](std::vector<double>& values) { values.resize(s.count); });
  put_at_rest(s, k, added.place, added.velocity);
}

double stored_energy(const Sample& s) {
  const Energies e = energies_of(s);
  return e.kinetic + e.elastic + e.adhesive;
}

}  // namespace

void change_grains(Sample& s, const GrainChanges& changes, const ThreadPool& pool) {
  if (changes.is_none()) return;
  synchronise(s);
  book_change(s, &Energies::exchanged, stored_energy, [&] {
    end_list(s);
    for (const MovedGrain& moved : changes.moved) move(s, moved);
    Numbers was(s.count);
    std::iota(was.begin(), was.end(), 0);
    for (const MovedGrain& moved : changes.moved) was[moved.disk] = new_disk;
    if (!changes.removed.empty()) keep(was, remove(s, changes.removed));
    for (const NewGrain& added : changes.added) add(s, added);
    was.resize(s.count, new_disk);
    begin_list(s, pool, was);
    s.laws.lead = -s.laws.lag;
    compute_forces(s, pool);
    s.laws = laws_between_steps(s);
  });
  sum_edge_forces(s, pool);
}

}  // namespace arenite::dem
