#pragma once
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "grains/dem/parts/part.hpp"

namespace arenite::dem {

/// The pairs that cohesion joins: all, and those whose grains do not touch.
struct CohesionCount {
  std::size_t joined = 0, apart = 0;
};

/// Attraction of grains that touch or nearly do.
template <int D> struct CohesivePairsIn : PartOf<D> {
  using S = SampleIn<D>;
  std::vector<PullCurve> curves;                            ///< of the pairs of radii that have been joined so far
  std::map<std::pair<double, double>, std::int32_t> place;  ///< of a curve, by the smaller and the larger radius
  double farthest = 0, steepest = 0;                        ///< that pairs act, m; largest slope of equal grains, N/m
  double joins_within = 0;                                  ///< the law's, m
  bool breaks = false;                                      ///< the law's
  /// By slot of two disks: the pull now, N, > 0 where the pair is joined, and the place of its curve. Empty without
  /// cohesion.
  Components<1> pull, former_pull;
  std::vector<std::int32_t> curve, former_curve;

  /// Pull of a slot now, N; 0 where none acts.
  double pull_of(std::size_t slot) const { return slot < pull.size() ? pull[slot] : 0.0; }

  /// Refuses laws that are written for the other dimension.
  static void check(Problems& problems, const PackingIn<D>& start, const ContactParameters& contact,
                    const IntegrationParameters& integration);
  /// How far the cohesion of this sample reaches, and how steep it is. InputError where the law makes no sense for its
  /// grains.
  void set_up(S& sample);
  /// Pairs of the packing that were joined go on.
  void recall(S& sample);
  double reach() const { return farthest; }
  void list_others(S& sample);
  bool remembers() const { return !pull.empty(); }
  void take_over(std::size_t slot, std::size_t former);
  /// Adds the pulls to the forces of the pairs' slots, which hold those of their contacts, and joins and parts pairs.
  /// What a pair holds as it breaks is booked as dissipated. A pair is found joined or parted up to a step late; what
  /// its force has not done by then goes into the same account.
  void add_forces(S& sample, const ThreadPool& pool);
  double steepest_slope() const { return steepest; }
  Rates added_rates(const S& sample) const;
  void add_energy(const S& sample, Energies& energies) const;
  void report(const S& sample, PackingIn<D>& out) const;
  template <class Members> void transfer_listed(S& sample, Members& members) {
    const std::size_t pairs = pull.size();
    if (pairs > 0) members(pull);
    if (!members.reads()) return;
    members.expect(pull.size() == pairs);
    find_curves(sample);
  }

 private:
  void find_curves(const S& sample);
};
using CohesivePairs = CohesivePairsIn<2>;

template <int D> CohesionCount count_cohesion(const SampleIn<D>& sample);

}  // namespace arenite::dem
