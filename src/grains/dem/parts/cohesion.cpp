#include "grains/dem/parts/cohesion.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string_view>

#include "core/error.hpp"
#include "core/problems.hpp"
#include "grains/dem/forces.hpp"
#include "grains/dem/movers.hpp"

namespace arenite::dem {
namespace {

/// Out of the plane, m; of no meaning to spheres.
double thickness_of(const Domain& domain) { return domain.thickness; }
double thickness_of(const DomainIn<3>& /*domain*/) { return 1; }

template <int D> PullCurve curve_between(const SampleIn<D>& s, double smaller, double larger) {
  const double thickness = thickness_of(s.domain);
  return s.contact.cohesion.visit([&](const auto& law) { return law.curve(smaller, larger, thickness); });
}

/// A law is one of disks alone where the liquid that it gives them is a prism.
void check_law(Problems& /*problems*/, const Packing& /*start*/, const Cohesion& /*cohesion*/) {}
void check_law(Problems& problems, const PackingIn<3>& /*start*/, const Cohesion& cohesion) {
  cohesion.visit([&](const auto& law) {
    if constexpr (requires { law.largest_volume(0.0, 0.0); })
      problems.unless(false, "contact.cohesion = \"{}\" is of disks; spheres take \"{}\"", cohesion.word(),
                      CapillarySpheres::word.word);
  });
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

template <int D> struct Across {
  double gap = 0, distance = 0;
  Vec<D> branch;  ///< from j to i
};
template <int D> Across<D> across(const SampleIn<D>& s, std::size_t p) {
  const auto &a = s.record[s.list.i[p]], &b = s.record[s.list.j[p]];
  const Vec<D> branch = a.place - b.place;
  const double distance = norm(branch);
  return {distance - a.radius - b.radius, distance, branch};
}

template <int D> std::int32_t curve_of(CohesivePairsIn<D>& all, const SampleIn<D>& s, std::size_t p) {
  const double a = s.record[s.list.i[p]].radius, b = s.record[s.list.j[p]].radius;
  const auto [found, is_new] =
      all.place.try_emplace({std::min(a, b), std::max(a, b)}, static_cast<std::int32_t>(all.curves.size()));
  if (is_new) all.curves.push_back(curve_between(s, found->first.first, found->first.second));
  return found->second;
}

template <int D> void pull_together(SampleIn<D>& s, std::size_t p, const Across<D>& at, double pull) {
  the<CohesivePairsIn<D>>(s).pull[p] = pull;
  s.list.force[p].on_i -= pull / at.distance * at.branch;
}

/// How fast the gap opens, by the integrated velocities.
template <int D> double opening(const SampleIn<D>& s, std::size_t p, const Across<D>& at) {
  const std::int32_t owner = s.list.owner[p];
  return dot(velocity_beside(s, s.list.i[p], owner, s.record[s.list.j[p]].velocity - s.record[owner].velocity),
             at.branch) /
         at.distance;
}

/// What of a pair's energy its force has not been given or has not taken when it begins or ends: half of the last
/// step's work was still to be done with the force before, that of its force now at the velocities before.
template <int D>
double unsettled_energy(const SampleIn<D>& s, std::size_t p, const Across<D>& at, const PullCurve& curve) {
  return curve.energy(at.gap) - time_behind(s) * curve.pull(at.gap) * opening(s, p, at);
}

/// Pairs that meet and part in this step, in the order of the list.
template <int D> void join_and_part(CohesivePairsIn<D>& all, SampleIn<D>& s) {
  const bool booked = all.breaks && s.step > 0;  // pairs that touch at the start are there already
  for (std::size_t p = 0; p < s.list.pairs; ++p) {
    const Across<D> at = across(s, p);
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
template <int D, class See> void each_joined(const CohesivePairsIn<D>& all, const SampleIn<D>& s, const See& see) {
  for (std::size_t p = 0; p < all.pull.size(); ++p)
    if (all.pull[p] > 0) see(p, across(s, p), all.curves[all.curve[p]]);
}

template <int D> std::vector<CohesivePair> cohesive_pairs(const CohesivePairsIn<D>& all, const SampleIn<D>& s) {
  std::vector<CohesivePair> pairs;
  each_joined(all, s, [&](std::size_t p, const Across<D>& at, const PullCurve& curve) {
    const std::int32_t a = s.record[s.list.i[p]].grain, b = s.record[s.list.owner[p]].grain;
    pairs.push_back({std::min(a, b), std::max(a, b), at.gap, curve.pull(at.gap), curve.energy(at.gap)});
  });
  std::sort(pairs.begin(), pairs.end(),
            [](const CohesivePair& a, const CohesivePair& b) { return pair_key(a.i, a.j) < pair_key(b.i, b.j); });
  return pairs;
}

}  // namespace

template <int D>
void CohesivePairsIn<D>::check(Problems& problems, const PackingIn<D>& start, const ContactParameters& contact,
                               const IntegrationParameters& /*integration*/) {
  check_law(problems, start, contact.cohesion);
}

template <int D> void CohesivePairsIn<D>::set_up(SampleIn<D>& s) {
  if (!s.contact.is_cohesive()) return;
  double smallest = s.largest_radius;
  for (std::size_t k = 0; k < s.count; ++k) smallest = std::min(smallest, s.record[k].radius);
  const std::string_view reach_key = s.contact.cohesion.visit([&](const auto& law) {
    joins_within = law.joins_within();
    breaks = law.breaks;
    if constexpr (requires { law.largest_volume(smallest, smallest); })
      check_volume(law, smallest, thickness_of(s.domain));
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

template <int D> void CohesivePairsIn<D>::recall(SampleIn<D>& s) {
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

template <int D> void CohesivePairsIn<D>::find_curves(const SampleIn<D>& s) {
  for (std::size_t p = 0; p < pull.size(); ++p)
    if (pull[p] > 0) curve[p] = curve_of(*this, s, p);
}

template <int D> void CohesivePairsIn<D>::list_others(SampleIn<D>& s) {
  std::swap(pull, former_pull);
  std::swap(curve, former_curve);
  pull.assign(s.contact.is_cohesive() ? s.list.pairs : 0);
  curve.assign(pull.size(), 0);
}

template <int D> void CohesivePairsIn<D>::take_over(std::size_t slot, std::size_t former) {
  if (slot >= pull.size() || former >= former_pull.size()) return;
  pull[slot] = former_pull[former];
  curve[slot] = former_curve[former];
}

template <int D> void CohesivePairsIn<D>::add_forces(SampleIn<D>& s, const ThreadPool& pool) {
  if (pull.empty()) return;
  std::atomic<bool> changed = false;
  pool.for_ranges(s.list.pairs, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      const Across<D> at = across(s, p);
      const bool joined = pull[p] > 0;
      const PullCurve* of = joined ? &curves[curve[p]] : nullptr;
      if (joined ? at.gap >= of->reach() : at.gap < joins_within) changed = true;
      else if (joined) pull_together(s, p, at, of->pull(at.gap));
    }
  });
  if (changed) join_and_part(*this, s);
}

/// What pulls add to the squared frequency of the lightest grain with six neighbours, in space twelve, 1/s^2.
template <int D> Rates CohesivePairsIn<D>::added_rates(const SampleIn<D>& s) const {
  double lightest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < s.count; ++k) lightest = std::min(lightest, s.record[k].mass);
  constexpr double neighbours = 6.0 * (D - 1);
  return {2 * neighbours / D * steepest / lightest, 0};
}

template <int D> void CohesivePairsIn<D>::add_energy(const SampleIn<D>& s, Energies& energies) const {
  double sum = 0;
  each_joined(*this, s, [&](std::size_t, const Across<D>& at, const PullCurve& of) { sum += of.energy(at.gap); });
  energies.adhesive += sum;
}

template <int D> void CohesivePairsIn<D>::report(const SampleIn<D>& s, PackingIn<D>& out) const {
  out.cohesive = cohesive_pairs(*this, s);
}

template <int D> CohesionCount count_cohesion(const SampleIn<D>& s) {
  const std::vector<CohesivePair> pairs = cohesive_pairs(the<CohesivePairsIn<D>>(s), s);
  return {pairs.size(), static_cast<std::size_t>(std::ranges::count_if(pairs, acts_across_gap))};
}

template struct CohesivePairsIn<2>;
template struct CohesivePairsIn<3>;
template CohesionCount count_cohesion(const SampleIn<2>&);
template CohesionCount count_cohesion(const SampleIn<3>&);

}  // namespace arenite::dem
