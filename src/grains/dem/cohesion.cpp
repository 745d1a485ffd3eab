#include "grains/dem/forces.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/error.hpp"
#include "grains/dem/movers.hpp"

namespace arenite::dem {
namespace {

PullCurve curve_between(const Sample& s, double smaller, double larger) {
  return s.contact.cohesion.visit([&](const auto& law) { return law.curve(smaller, larger, s.domain.thickness); });
}

/// Law of a liquid: the surfaces of more of it would bulge and push the two smallest grains apart.
template <class Law> void check_volume(const Law& law, double smallest, double thickness) {
  const double most = law.largest_volume(smallest, thickness);
  if (!(law.volume < most))
    throw InputError(
        fmt::format("contact.liquid_volume of {:.4g} mm^3 is more than two touching grains of radius {:.4g} mm hold "
                    "between straight surfaces; use less than {:.4g} mm^3",
                    1e9 * law.volume, 1e3 * smallest, 1e9 * most));
}

struct Across {
  double gap = 0, distance = 0;
  Vec2 branch;  ///< from j to i
};
Across across(const Sample& s, std::size_t p) {
  const DiskRecord &a = s.record[s.list.i[p]], &b = s.record[s.list.j[p]];
  const Vec2 branch = a.place - b.place;
  const double distance = norm(branch);
  return {distance - a.radius - b.radius, distance, branch};
}

std::int32_t curve_of(Sample& s, std::size_t p) {
  const double a = s.record[s.list.i[p]].radius, b = s.record[s.list.j[p]].radius;
  CohesionTable& table = s.cohesion;
  const auto [found, is_new] =
      table.place.try_emplace({std::min(a, b), std::max(a, b)}, static_cast<std::int32_t>(table.curve.size()));
  if (is_new) table.curve.push_back(curve_between(s, found->first.first, found->first.second));
  return found->second;
}

void pull_together(Sample& s, std::size_t p, const Across& at, double pull) {
  s.list.pull[p] = pull;
  s.list.force[p].on_i -= pull / at.distance * at.branch;
}

/// How fast the gap opens, by the integrated velocities.
double opening(const Sample& s, std::size_t p, const Across& at) {
  const std::int32_t owner = s.list.owner[p];
  return dot(velocity_beside(s, s.list.i[p], owner, s.record[s.list.j[p]].velocity - s.record[owner].velocity),
             at.branch) /
         at.distance;
}

/// What of a pair's energy its force has not been given or has not taken when it begins or ends: half of the last
/// step's work was still to be done with the force before, that of its force now at the velocities before.
double unsettled_energy(const Sample& s, std::size_t p, const Across& at, const PullCurve& curve) {
  return curve.energy(at.gap) - time_behind(s) * curve.pull(at.gap) * opening(s, p, at);
}

/// Pairs that meet and part in this step, in the order of the list.
void join_and_part(Sample& s) {
  const bool booked = s.cohesion.breaks && s.step > 0;  // pairs that touch at the start are there already
  for (std::size_t p = 0; p < s.list.pairs; ++p) {
    const Across at = across(s, p);
    if (s.list.pull[p] > 0) {
      const PullCurve& curve = s.cohesion.curve[s.list.curve[p]];
      if (at.gap < curve.reach()) continue;
      if (booked) s.tally.dissipated_breakage += unsettled_energy(s, p, at, curve);
      s.list.pull[p] = 0;
    } else if (at.gap < s.cohesion.joins_within) {
      s.list.curve[p] = curve_of(s, p);
      const PullCurve& curve = s.cohesion.curve[s.list.curve[p]];
      if (booked) s.tally.dissipated_breakage -= unsettled_energy(s, p, at, curve);
      pull_together(s, p, at, curve.pull(at.gap));
    }
  }
}

/// Calls `see(slot, where it is, its curve)` for each joined pair.
template <class See> void each_joined(const Sample& s, const See& see) {
  for (std::size_t p = 0; p < s.list.pull.size(); ++p)
    if (s.list.pull[p] > 0) see(p, across(s, p), s.cohesion.curve[s.list.curve[p]]);
}

}  // namespace

void set_up_cohesion(Sample& s) {
  if (!s.contact.is_cohesive()) return;
  double smallest = s.largest_radius;
  for (std::size_t k = 0; k < s.count; ++k) smallest = std::min(smallest, s.record[k].radius);
  const std::string_view reach_key = s.contact.cohesion.visit([&](const auto& law) {
    s.cohesion.joins_within = law.joins_within();
    s.cohesion.breaks = law.breaks;
    if constexpr (requires { law.largest_volume(smallest, smallest); }) check_volume(law, smallest, s.domain.thickness);
    return law.reach_key;
  });
  for (const auto& [a, b] :
       {std::pair{smallest, smallest}, {smallest, s.largest_radius}, {s.largest_radius, s.largest_radius}}) {
    const PullCurve curve = curve_between(s, a, b);
    s.cohesion.reach = std::max(s.cohesion.reach, curve.reach());
    s.cohesion.steepest = std::max(s.cohesion.steepest, curve.steepest());
  }
  if (s.cohesion.reach > s.largest_radius)
    throw InputError(
        fmt::format("contact.cohesion = \"{}\" would act across {:.4g} mm, more than the largest grain's radius of "
                    "{:.4g} mm; use a smaller {}",
                    s.contact.cohesion.word(), 1e3 * s.cohesion.reach, 1e3 * s.largest_radius, reach_key));
}

void recall_cohesion(Sample& s) {
  const std::vector<CohesivePair>& before = s.start.cohesive;
  for (std::size_t p = 0; p < s.list.pull.size(); ++p) {
    const std::uint64_t key = slot_key(s, p);
    const auto found = std::lower_bound(before.begin(), before.end(), key,
                                        [](const CohesivePair& c, std::uint64_t k) { return pair_key(c.i, c.j) < k; });
    if (found != before.end() && pair_key(found->i, found->j) == key) s.list.pull[p] = found->pull;
  }
  s.start.cohesive.clear();
  find_pull_curves(s);
}

void find_pull_curves(Sample& s) {
  for (std::size_t p = 0; p < s.list.pull.size(); ++p)
    if (s.list.pull[p] > 0) s.list.curve[p] = curve_of(s, p);
}

void add_cohesion(Sample& s, const ThreadPool& pool) {
  if (s.list.pull.empty()) return;
  std::atomic<bool> changed = false;
  pool.for_ranges(s.list.pairs, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      const Across at = across(s, p);
      const bool joined = s.list.pull[p] > 0;
      const PullCurve* curve = joined ? &s.cohesion.curve[s.list.curve[p]] : nullptr;
      if (joined ? at.gap >= curve->reach() : at.gap < s.cohesion.joins_within) changed = true;
      else if (joined) pull_together(s, p, at, curve->pull(at.gap));
    }
  });
  if (changed) join_and_part(s);
}

double cohesive_energy(const Sample& s) {
  double sum = 0;
  each_joined(s, [&](std::size_t, const Across& at, const PullCurve& curve) { sum += curve.energy(at.gap); });
  return sum;
}

std::vector<CohesivePair> cohesive_pairs(const Sample& s) {
  std::vector<CohesivePair> pairs;
  each_joined(s, [&](std::size_t p, const Across& at, const PullCurve& curve) {
    const std::int32_t a = s.record[s.list.i[p]].grain, b = s.record[s.list.owner[p]].grain;
    pairs.push_back({std::min(a, b), std::max(a, b), at.gap, curve.pull(at.gap), curve.energy(at.gap)});
  });
  std::sort(pairs.begin(), pairs.end(),
            [](const CohesivePair& a, const CohesivePair& b) { return pair_key(a.i, a.j) < pair_key(b.i, b.j); });
  return pairs;
}

}  // namespace arenite::dem
