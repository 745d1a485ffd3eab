#pragma once
#include "core/threads.hpp"
#include "grains/dem/sample.hpp"

namespace arenite::dem {

/// How far the cohesion of this sample reaches, and how steep it is. InputError where the law makes no sense for its grains.
void set_up_cohesion(Sample& sample);

/// Pairs of the packing that were joined go on. The list must have just been built.
void recall_cohesion(Sample& sample);

/// Finds the curves of the pairs that are joined.
void find_pull_curves(Sample& sample);

/// Adds the pulls to the forces of the pairs' slots, which hold those of their contacts, and joins and parts pairs. What a pair holds as it breaks is
/// booked as dissipated. A pair is found joined or parted up to a step late; what its force has not done by then goes into the same account.
void add_cohesion(Sample& sample, const ThreadPool& pool);

/// Pull of a slot now, N; 0 where none acts.
inline double pull_of(const Sample& s, std::size_t slot) { return slot < s.list.pull.size() ? s.list.pull[slot] : 0.0; }

/// Energy of all joined pairs, J.
double cohesive_energy(const Sample& sample);

/// All joined pairs, by the caller's grains.
std::vector<CohesivePair> cohesive_pairs(const Sample& sample);

}  // namespace arenite::dem
