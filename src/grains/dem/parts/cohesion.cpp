#include "grains/dem/parts/cohesion.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string_view>

#include "core/error.hpp"
#include "grains/dem/forces.hpp"
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

std::int32_t curve_of(CohesivePairs& all, const Sample& s, std::size_t p) {
  const double a = s.record[s.list.i[p]].radius, b = s.record[s.list.j[p]].radius;
  const auto [found, is_new] =
      all.place.try_emplace({std::min(a, b), std::max(a, b)}, static_cast<std::int32_t>(all.curves.size()));
  if (is_new) all.curves.push_back(curve_between(s, found->first.first, found->first.second));
  return found->second;
}

void pull_together(Sample& s, std::size_t p, const Across& at, double pull) {
  the<CohesivePairs>(s).pull[p] = pull;
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
void join_and_part(CohesivePairs& all, Sample& s) {
  const bool booked = all.breaks && s.step > 0;  // pairs that touch at the start are there already
  for (std::size_t p = 0; p < s.list.pairs; ++p) {
    const Across at = across(s, p);
    if (all.pull[p] > 0) {
      const PullCurve& curve = all.curves[all.curve[p]];
      if (at.gap < curve.reach()) continue;
      if (booked) s.tally.dissipated_breakage += unsettled_energy(s, p, at, curve);
      all.pull[p] = 0;
    } else if (at.gap < all.joins_within) {
      all.curve[p] = curve_of(all, s, p);
      const PullCurve& curve = all.curves[all.curve[p]];
      if (booked) s.tally.dissipated_breakage -= unsettled_energy(s, p, at, curve);
      pull_together(s, p, at, curve.pull(at.gap));
    }
  }
}

/// Calls `see(slot, where it is, its curve)` for each joined pair.
template <class See> void each_joined(const CohesivePairs& all, const Sample& s, const See& see) {
  for (std::size_t p = 0; p < all.pull.size(); ++p)
    if (all.pull[p] > 0) see(p, across(s, p), all.curves[all.curve[p]]);
}

std::vector<CohesivePair> cohesive_pairs(const CohesivePairs& all, const Sample& s) {
  std::vector<CohesivePair> pairs;
  each_joined(all, s, [&](std::size_t p, const Across& at, const PullCurve& curve) {
    const std::int32_t a = s.record[s.list.i[p]].grain, b = s.record[s.list.owner[p]].grain;
    pairs.push_back({std::min(a, b), std::max(a, b), at.gap, curve.pull(at.gap), curve.energy(at.gap)});
  });
  std::sort(pairs.begin(), pairs.end(),
            [](const CohesivePair& a, const CohesivePair& b) { return pair_key(a.i, a.j) < pair_key(b.i, b.j); });
  return pairs;
}

}  // namespace

void CohesivePairs::set_up(Sample& s) {
  if (!s.contact.is_cohesive()) return;
  double smallest = s.largest_radius;
  for (std::size_t k = 0; k < s.count; ++k) smallest = std::min(smallest, s.record[k].radius);
  const std::string_view reach_key = s.contact.cohesion.visit([&](const auto& law) {
    joins_within = law.joins_within();
    breaks = law.breaks;
    if constexpr (requires { law.largest_volume(smallest, smallest); }) check_volume(law, smallest, s.domain.thickness);
    return law.reach_key;
  });
  for (const auto& [a, b] :
       {std::pair{smallest, smallest}, {smallest, s.largest_radius}, {s.largest_radius, s.largest_radius}}) {
    const PullCurve between = curve_between(s, a, b);
    farthest = std::max(farthest, between.reach());
    steepest = std::max(steepest, between.steepest());
  }
  if (farthest > s.largest_radius)
    throw InputError(
        fmt::format("contact.cohesion = \"{}\" would act across {:.4g} mm, more than the largest grain's radius of "
                    "{:.4g} mm; use a smaller {}",
                    s.contact.cohesion.word(), 1e3 * farthest, 1e3 * s.largest_radius, reach_key));
}

void CohesivePairs::recall(Sample& s) {
  const std::vector<CohesivePair>& before = s.start.cohesive;
  for (std::size_t p = 0; p < pull.size(); ++p) {
    const std::uint64_t key = slot_key(s, p);
    const auto found = std::lower_bound(before.begin(), before.end(), key,
                                        [](const CohesivePair& c, std::uint64_t k) { return pair_key(c.i, c.j) < k; });
    if (found != before.end() && pair_key(found->i, found->j) == key) pull[p] = found->pull;
  }
  s.start.cohesive.clear();
  find_curves(s);
}

void CohesivePairs::find_curves(const Sample& s) {
  for (std::size_t p = 0; p < pull.size(); ++p)
    if (pull[p] > 0) curve[p] = curve_of(*this, s, p);
}

void CohesivePairs::list_others(Sample& s) {
  std::swap(pull, former_pull);
  std::swap(curve, former_curve);
  pull.assign(s.contact.is_cohesive() ? s.list.pairs : 0);
  curve.assign(pull.size(), 0);
}

void CohesivePairs::take_over(std::size_t slot, std::size_t former) {
  if (slot >= pull.size() || former >= former_pull.size()) return;
  pull[slot] = former_pull[former];
  curve[slot] = former_curve[former];
}

void CohesivePairs::add_forces(Sample& s, const ThreadPool& pool) {
  if (pull.empty()) return;
  std::atomic<bool> changed = false;
  pool.for_ranges(s.list.pairs, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      const Across at = across(s, p);
      const bool joined = pull[p] > 0;
      const PullCurve* of = joined ? &curves[curve[p]] : nullptr;
      if (joined ? at.gap >= of->reach() : at.gap < joins_within) changed = true;
      else if (joined) pull_together(s, p, at, of->pull(at.gap));
    }
  });
  if (changed) join_and_part(*this, s);
}

/// What pulls add to the squared frequency of the lightest grain with six neighbours, 1/s^2.
Rates CohesivePairs::added_rates(const Sample& s) const {
  double lightest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < s.count; ++k) lightest = std::min(lightest, s.record[k].mass);
  return {6.0 * steepest / lightest, 0};
}

void CohesivePairs::add_energy(const Sample& s, Energies& energies) const {
  double sum = 0;
  each_joined(*this, s, [&](std::size_t, const Across& at, const PullCurve& of) { sum += of.energy(at.gap); });
  energies.adhesive += sum;
}

void CohesivePairs::report(const Sample& s, Packing& out) const { out.cohesive = cohesive_pairs(*this, s); }

CohesionCount count_cohesion(const Sample& s) {
  const std::vector<CohesivePair> pairs = cohesive_pairs(the<CohesivePairs>(s), s);
  return {pairs.size(), static_cast<std::size_t>(std::ranges::count_if(pairs, acts_across_gap))};
}

}  // namespace arenite::dem
