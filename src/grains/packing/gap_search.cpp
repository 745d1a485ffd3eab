#include "grains/packing/gap_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/problems.hpp"
#include "grains/packing/two_classes.hpp"

namespace arenite::packing {
namespace {

/// The search ends unfinished after as many samplings as hold so many disks together: a second or two of work.
constexpr std::size_t most_disks = 200'000;
constexpr std::size_t fewest_samplings = 8;
/// What maximal samplings of disks with half their gap around them cover, and both classes together: only first
/// guesses.
constexpr double covered_with_gap = 0.62, covered = 0.78;
constexpr double fewest_large = 10;

/// The gap at which about `fewest_large` large disks are left.
double widest_gap(const BidisperseParameters& p) {
  return 2 * (std::sqrt(covered_with_gap * p.box_area / fewest_large) - 1) * p.large_radius;
}

double guess(const BidisperseParameters& p) {
  const double large = covered * p.volume_ratio / (1 + p.volume_ratio);
  return std::clamp(2 * (std::sqrt(covered_with_gap / large) - 1) * p.large_radius, 0.0, widest_gap(p));
}

/// A gap and how far the ratio reached there is above the one asked for.
struct Known {
  double gap, excess;  ///< m; ln of the ratio over the one asked for, falls with the gap
};

/// Where the straight line through known points, the nearest to the aim weighing most, reaches the aim. Ratios scatter
/// by a few per cent from sampling to sampling, so a line through all is a better guide than the last two.
double aim(const std::vector<Known>& known, double near, double far) {
  double w = 0, g = 0, e = 0, gg = 0, ge = 0;
  for (const Known& k : known) {
    const double weight = 1 / (k.excess * k.excess + 4e-4);
    w += weight;
    g += weight * k.gap;
    e += weight * k.excess;
  }
  g /= w;
  e /= w;
  for (const Known& k : known) {
    const double weight = 1 / (k.excess * k.excess + 4e-4);
    gg += weight * (k.gap - g) * (k.gap - g);
    ge += weight * (k.gap - g) * (k.excess - e);
  }
  const double root = ge < 0 ? g - e * gg / ge : g;
  // The range itself rests on two samplings that scatter, so it may miss the aim by a little.
  const double slack = 0.5 * (far - near);
  return std::clamp(root, std::max(0.0, near - slack), far + slack);
}

class Search {
 public:
  Search(const BidisperseParameters& p, const geometry::Box<2>& box, std::uint64_t seed)
      : p_(p),
        box_(box),
        seed_(seed),
        widest_(widest_gap(p)) {}

  TwoClasses run() {
    search();
    best_.samplings = static_cast<int>(known_.size());
    return std::move(best_);
  }

 private:
  void search() {
    double near = guess(p_), far = near;
    // Steps from the guess, each twice as wide, until the ratio asked for lies between two gaps.
    if (excess_at(near) < 0) {
      for (double step = first_step(); !done() && near > 0; step *= 2) {
        far = near;
        near = std::max(0.0, near - step);
        if (excess_at(near) > 0) break;
      }
      if (known_.back().excess < 0) return;
    } else {
      for (double step = first_step(); !done(); step *= 2) {
        near = far;
        far = std::min(widest_, far + step);
        if (excess_at(far) < 0) break;
        if (far >= widest_ && !done()) refuse();
      }
    }
    while (!done() && (known_.size() < fewest_samplings || sampled_disks_ < most_disks))
      excess_at(aim(known_, near, far));
  }

  double first_step() const { return 0.1 * p_.large_radius; }

  double excess_at(double gap) {
    // Every attempt is another sampling, lest the search circles round a gap whose one sampling is off.
    TwoClasses sampled = sample_two_classes(p_, box_, gap, seed_, known_.size());
    sampled_disks_ += sampled.disks.size();
    constexpr double no_small_disks = 5;  // where ln would be infinite
    const double excess = std::min(no_small_disks, std::log(sampled.volume_ratio() / p_.volume_ratio));
    if (known_.empty() || std::abs(excess) < std::abs(least_)) {
      least_ = excess;
      best_ = std::move(sampled);
    }
    known_.push_back({gap, excess});
    return excess;
  }
  bool done() const { return std::abs(least_) <= std::log1p(p_.tolerance); }

  [[noreturn]] void refuse() const {
    throw refusal(
        "the volume ratio theta of {:g} is out of reach: in this box even the widest gap between large disks, {:.3g} "
        "of their mean radius, gives {:.3g}; prescribe more or use a larger box",
        p_.volume_ratio, widest_ / p_.large_radius, p_.volume_ratio * std::exp(known_.back().excess));
  }

  const BidisperseParameters& p_;
  const geometry::Box<2>& box_;
  std::uint64_t seed_;
  double widest_, least_ = 0;
  std::size_t sampled_disks_ = 0;
  std::vector<Known> known_;
  TwoClasses best_;
};

}  // namespace

TwoClasses find_gap(const BidisperseParameters& p, const geometry::Box<2>& box, std::uint64_t seed) {
  return Search(p, box, seed).run();
}

}  // namespace arenite::packing
