#include "grains/dem/neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "grains/dem/advance.hpp"
#include "grains/dem/integrators/time_step.hpp"
#include "grains/dem/measure.hpp"

namespace arenite::dem {
namespace {

template <int D> void check_places(const SampleIn<D>& s) {
  for (std::size_t k = 0; k < s.count; ++k) {
    const auto& d = s.record[k];
    const char* fault = nullptr;
    if (!is_finite(d.place + d.velocity) || !is_finite(d.omega))
      fault = " has a coordinate or velocity that is not finite";
    for (int side = 0; side < sides_in<D> && !fault; ++side)
      if (s.domain.wall[side].present && s.domain.depth(side, d.place) < 0)
        fault = " has left the container through a wall";
    if (fault) {
      const auto id = s.start.grains.id[d.grain];
      const std::string what = "grain " + std::to_string(id) + fault;
      if (s.step == 0) throw InputError(what + " before the first step; correct its position, or the container");
      throw CannotGoOn(what + " at step " + std::to_string(s.step) +
                       "; a smaller time step or a gentler load is needed");
    }
  }
}

/// Joined from the start, however deep they lie in each other.
template <int D> bool is_joined(const SampleIn<D>& s, std::size_t slot, std::int32_t a, std::int32_t b) {
  if (s.list.strength[slot] > 0) return true;
  return any_part(s, [&](const auto& part) { return part.joins(a, b); });
}

template <int D> bool is_foot(const SampleIn<D>& s, std::size_t slot) {
  return any_part(s, [&](const auto& part) { return part.is_foot(s, slot); });
}

/// A contact turns about where the centre of one grain enters the other: what has gone so deep goes through. The list
/// is the one that is about to be replaced, and is renewed several times while grains pass each other.
template <int D> void check_pairs(const SampleIn<D>& s) {
  for (std::size_t p = 0; p < s.list.pairs; ++p) {
    const auto &a = s.record[s.list.i[p]], &b = s.record[s.list.j[p]];
    const Vec<D> way = a.place - b.place;
    const double larger = std::max(a.radius, b.radius);
    if (!(dot(way, way) < larger * larger) || is_foot(s, p)) continue;  // polygons are checked with their feet
    const std::int32_t i = a.grain, j = s.record[s.list.owner[p]].grain;
    const Vec<D> at_start = s.start.grains.position[i] - s.start.grains.position[j];
    if (dot(at_start, at_start) < larger * larger || is_joined(s, p, i, j))
      continue;  // a sample given so crosses nothing
    const auto& id = grains_of(s).id;
    throw CannotGoOn("grains " + std::to_string(id[grain_of(s, i)]) + " and " + std::to_string(id[grain_of(s, j)]) +
                     " overlap by more than the radius of the smaller one, and pass through each other, at step " +
                     std::to_string(s.step) + "; stiffer contacts, a smaller time step or a gentler load are needed");
  }
}

template <int D> void wrap(SampleIn<D>& s) {
  if (s.domain.periodic[0]) s.domain.tilt -= std::round(s.domain.tilt / s.domain.extent(0)) * s.domain.extent(0);
  for (std::size_t k = 0; k < s.count; ++k)
    if (!is_part(s, k))
      wrap_over_sides(s, s.record[k].mass, s.record[k].place, s.velocity.along[0][k], s.record[k].velocity);
}

template <class T> void permute(std::vector<T>& values, const std::vector<std::int32_t>& order) {
  if (values.empty()) return;
  std::vector<T> old(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(order.size()));
  for (std::size_t k = 0; k < order.size(); ++k) values[k] = old[order[k]];
}

/// Returns the former number of every disk.
template <int D> std::vector<std::int32_t> sort_by_cell(SampleIn<D>& s) {
  const auto grid = cells_of(s);
  std::vector<std::int32_t> order =
      geometry::SortedCells(grid.size(), 0, s.count, [&](std::size_t k) { return grid.cell(s.record[k].place); }).item;
  s.record.resize(s.count);
  permute(s.record, order);
  each_motion_array(s, [&](auto& a) { permute(a, order); });
  for (auto& higher : s.higher)
    for (auto& a : higher.along) permute(a, order);
  return order;
}

/// The slot that joins disk a with disk b, or with wall b < 0, with the polygon of a itself where `as_polygon`; the
/// empty slot if there is none. `either`: b with a as well, which are two slots where the one that takes the reaction
/// stands for a polygon.
template <int D>
std::size_t find_slot(const ContactListIn<D>& list, std::int32_t a, std::int32_t b, bool as_polygon, bool either) {
  const auto slots = [&](std::int32_t q, auto&& joins) {
    for (auto g = list.first[q]; g < list.first[q + 1]; ++g) {
      const std::size_t p = list.group[g];
      if (p < list.size() && joins(p)) return p;
    }
    return list.size();
  };
  if (b < 0) return slots(2 * a, [&](std::size_t p) { return list.j[p] == b && (p >= list.polygons) == as_polygon; });
  const std::size_t own = slots(2 * a, [&](std::size_t p) { return list.owner[p] == b; });
  return own < list.size() || !either ? own : slots(2 * a + 1, [&](std::size_t p) { return list.i[p] == b; });
}

/// Takes over what touching pairs remember from the list before a rebuild; disk k was number `was[k]` in it. A periodic
/// cell is at least two reaches wide, so no pair meets twice.
template <int D>
void carry_over(SampleIn<D>& s, ContactListIn<D>& before, const std::vector<std::int32_t>& was,
                const ThreadPool& pool) {
  ContactListIn<D>& list = s.list;
  const bool parts_remember = any_part(s, [](const auto& part) { return part.remembers(); });
  if (before.size() == 0 ||
      (s.glued_pairs.empty() && !remembers(s.laws) && list.rolling_memory.empty() && !parts_remember))
    return;
  pool.for_ranges(list.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      const bool walled = list.j[p] < 0;
      const std::int32_t a = was[list.i[p]];
      const std::int32_t b = walled ? list.j[p] : was[list.owner[p]];
      if (a == new_disk || (!walled && b == new_disk)) continue;
      const std::size_t old = find_slot(before, a, b, p >= list.polygons, !is_foot(s, p));
      if (old == before.size()) continue;
      const auto take_over = [&](auto& now, const auto& then) {
        if (p < now.size()) now.put(p, then[old]);
      };
      take_over(list.memory, before.memory);
      take_over(list.normal_memory, before.normal_memory);
      take_over(list.rolling_memory, before.rolling_memory);
      take_over(list.twist_memory, before.twist_memory);
      list.glue[p] = before.glue[old];
      each_part(s, [&](auto& part) { part.take_over(p, old); });
    }
  });
}

}  // namespace

template <int D> void end_list(SampleIn<D>& s) {
  check_places(s);
  if (s.step > 0) check_pairs(s);
  each_part(s, [&](auto& part) { part.check_list(s); });
  wrap(s);
  each_part(s, [&](auto& part) { part.wrap(s); });
}

void choose_skin(Sample& /*sample*/) {}

/// A wide skin lists spheres that do not touch, a narrow one does not last; both cost the same where a list lasts for
/// four steps times the mean radius over the skin.
void choose_skin(SampleIn<3>& s) {
  const double mean = 0.5 * grains_of(s).mean_diameter();
  const double lasted = 0.25 * static_cast<double>(s.step - s.listed_step) * s.skin / mean;
  s.listed_step = s.step;
  if (s.builds == 0) s.skin = 0.05 * mean;
  else if (lasted > 1.5) s.skin = std::max(0.8 * s.skin, smallest_skin * mean);
  else if (lasted < 0.7) s.skin = std::min(1.25 * s.skin, largest_skin * mean);
}

template <int D> void begin_list(SampleIn<D>& s, const ThreadPool& pool, const std::vector<std::int32_t>& renumbered) {
  choose_skin(s);
  std::vector<std::int32_t> was = sort_by_cell(s);
  if (!renumbered.empty())
    for (std::int32_t& k : was) k = renumbered[k];
  s.listed.assign(s.count);
  for (std::size_t k = 0; k < s.count; ++k) s.listed.put(k, s.record[k].place);
  s.listed_domain = s.domain;
  s.listed_sheared = s.sheared;
  ++s.builds;
  std::swap(s.list, s.former);
  list_contacts(s, pool);
  carry_over(s, s.former, was, pool);
  each_part(s, [&](auto& part) { part.renew(s); });
}

template <int D> void rebuild_list(SampleIn<D>& s, const ThreadPool& pool) {
  end_list(s);
  begin_list(s, pool, {});
}

template <int D> void list_anew(SampleIn<D>& s, const ThreadPool& pool) {
  book_change(s, &Energies::work_walls, &Energies::elastic, [&] {
    rebuild_list(s, pool);
    s.laws.lead = -s.laws.lag;
    compute_forces(s, pool);
    s.laws = laws_between_steps(s);
  });
}

template void end_list(SampleIn<2>&);
template void begin_list(SampleIn<2>&, const ThreadPool&, const std::vector<std::int32_t>&);
template void rebuild_list(SampleIn<2>&, const ThreadPool&);
template void rebuild_list(SampleIn<3>&, const ThreadPool&);
template void list_anew(SampleIn<2>&, const ThreadPool&);
template void list_anew(SampleIn<3>&, const ThreadPool&);

}  // namespace arenite::dem
