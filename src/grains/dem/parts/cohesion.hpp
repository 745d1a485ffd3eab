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
struct CohesivePairs : PartOf<2> {
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

  /// How far the cohesion of this sample reaches, and how steep it is. InputError where the law makes no sense for its
  /// grains.
  void set_up(Sample& sample);
  /// Pairs of the packing that were joined go on.
  void recall(Sample& sample);
  double reach() const { return farthest; }
  void list_others(Sample& sample);
  bool remembers() const { return !pull.empty(); }
  void take_over(std::size_t slot, std::size_t former);
  /// Adds the pulls to the forces of the pairs' slots, which hold those of their contacts, and joins and parts pairs.
  /// What a pair holds as it breaks is booked as dissipated. A pair is found joined or parted up to a step late; what
  /// its force has not done by then goes into the same account.
  void add_forces(Sample& sample, const ThreadPool& pool);
  double steepest_slope() const { return steepest; }
  Rates added_rates(const Sample& sample) const;
  void add_energy(const Sample& sample, Energies& energies) const;
  void report(const Sample& sample, Packing& out) const;
  template <class Members> void transfer_listed(Sample& sample, Members& members) {
    const std::size_t pairs = pull.size();
    if (pairs > 0) members(pull);
    if (!members.reads()) return;
    members.expect(pull.size() == pairs);
    find_curves(sample);
  }

 private:
  void find_curves(const Sample& sample);
};

CohesionCount count_cohesion(const Sample& sample);

}  // namespace arenite::dem
