#pragma once
#include <functional>
#include <vector>

#include "validation/claims/paper_runs.hpp"

/// Errors of numbers of many pairs that have few samples each.
namespace arenite::validation {

/// The same means with errors from one variance of samples over all pairs, where Bartlett's test at 1 % leaves them
/// one, or else over the pairs of one gamma; a pair's own scatter where they differ there, too. Five samples tell their
/// scatter to a third only; those of 45 pairs together, with 180 degrees of freedom, to a twentieth.
PairMeans with_pooled_variance(PairMeans means);
/// Whether a pair's error is from more samples than its own.
bool is_pooled(const PairMean& pair);

/// A number worked out from several means, its error by the jackknife: each pair in turn without each of its samples,
/// since packings of different pairs are independent. Samples of one packing are left out together. Unknown where a
/// pair has one sample.
Value jackknifed(const std::vector<PairMeans>& means,
                 const std::function<double(const std::vector<PairMeans>&)>& number);
Value jackknifed(const PairMeans& means, const std::function<double(const PairMeans&)>& number);

}  // namespace arenite::validation
