#pragma once
#include <functional>
#include <string>

#include "validation/claims/paper_runs.hpp"

/// Checks over all pairs of size ratio and volume ratio.
namespace arenite::validation {

/// What is asked of the samples of one load.
using Asked = std::function<std::vector<Check>(const Samples&)>;

/// Every pair lies between the bounds.
Check in_range(const std::string& what, const std::string& source, const PairMeans& means, double low, double high);
/// The slope against gamma goes this way (+1, -1) at every theta.
Check with_gamma(const std::string& what, const std::string& source, const PairMeans& means, int direction);
/// A number worked out at each theta.
Family by_theta(const PairMeans& means, const std::function<Value(double theta)>& number);

/// R^2 of a line through the means of one theta, against gamma or its inverse; unknown for fewer than three gammas.
enum class Against { gamma, inverse_gamma };
Value straightness(const PairMeans& means, double theta, Against against);
/// At least 0.98 at every theta.
Check straight(const std::string& what, const std::string& source, const PairMeans& means, Against against);

/// Further seeds of claims on packings are those of the full sample alone: what cements a packing does not change it.
void draw_packings_alone(Judgement& judgement);

/// How a number goes with gamma at one theta that first falls and then rises: its mean at the least gamma, and at the
/// greatest, over that at the lowest point. Where that lies is found without the sample that is looked at, since the
/// lowest of several noisy means lies below the true ones.
struct Dip {
  Value fall, rise;
};
Dip dip(const PairMeans& means, double theta);

/// `numbers` at the cement where `sizes` are greatest, one entry a cement, pair by pair and sample by sample; which
/// cement that is is found from the pair's other samples, for the same reason.
PairMeans at_greatest(const std::vector<PairMeans>& sizes, const std::vector<PairMeans>& numbers);

}  // namespace arenite::validation
