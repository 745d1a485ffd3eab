#include "grains/packing/gap_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/problems.hpp"
#include "grains/packing/two_classes.hpp"

namespace arenite::packing {
namespace {

/// The search ends unfinished after as many samplings as hold so many together: a second or two of work.
constexpr std::size_t most_placed = 200'000;
constexpr std::size_t fewest_samplings = 8;
/// What samplings of disks, or of spheres, with half their gap around them cover, and both classes together: only first
/// guesses.
template <int D> constexpr double covered_with_gap = 0.62;
template <> constexpr double covered_with_gap<3> = 0.35;
template <int D> constexpr double covered = 0.78;
template <> constexpr double covered<3> = 0.5;
constexpr double fewest_large = 10;

/// The gap at which about `fewest_large` large ones are left.
template <int D> double widest_gap(const BidisperseParameters& p) {
  return 2 * (geometry::side_of_cube<D>(covered_with_gap<D> * p.box_area / fewest_large) - 1) * p.large_radius;
}

template <int D> double guess(const BidisperseParameters& p) {
  const double large = covered<D> * p.volume_ratio / (1 + p.volume_ratio);
  return std::clamp(2 * (geometry::side_of_cube<D>(covered_with_gap<D> / large) - 1) * p.large_radius, 0.0,
                    widest_gap<D>(p));
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

template <int D> class GapSearch {
 public:
  GapSearch(const BidisperseParameters& p, const geometry::Box<D>& box, std::uint64_t seed)
      : p_(p),
        box_(box),
        seed_(seed),
        widest_(widest_gap<D>(p)) {}

  TwoClasses<D> run() {
    search();
    best_.samplings = static_cast<int>(known_.size());
    return std::move(best_);
  }

 private:
  void search() {
    double near = guess<D>(p_), far = near;
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
    while (!done() && (known_.size() < fewest_samplings || placed_ < most_placed)) excess_at(aim(known_, near, far));
  }

  double first_step() const { return 0.1 * p_.large_radius; }

  double excess_at(double gap) {
    // Every attempt is another sampling, lest the search circles round a gap whose one sampling is off.
    TwoClasses<D> sampled = sample_two_classes(p_, box_, gap, seed_, known_.size());
    placed_ += sampled.balls.size();
    constexpr double no_small_ones = 5;  // where ln would be infinite
    const double excess = std::min(no_small_ones, std::log(sampled.volume_ratio() / p_.volume_ratio));
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
        "the volume ratio theta of {:g} is out of reach: in this box even the widest gap between large {}, {:.3g} "
        "of their mean radius, gives {:.3g}; prescribe more or use a larger box",
        p_.volume_ratio, round_grains<D>, widest_ / p_.large_radius, p_.volume_ratio * std::exp(known_.back().excess));
  }

  const BidisperseParameters& p_;
  const geometry::Box<D>& box_;
  std::uint64_t seed_;
  double widest_, least_ = 0;
  std::size_t placed_ = 0;
  std::vector<Known> known_;
  TwoClasses<D> best_;
};

}  // namespace

template <int D>
TwoClasses<D> find_gap(const BidisperseParameters& p, const geometry::Box<D>& box, std::uint64_t seed) {
  return GapSearch<D>(p, box, seed).run();
}
template TwoClasses<2> find_gap(const BidisperseParameters&, const geometry::Box<2>&, std::uint64_t);
template TwoClasses<3> find_gap(const BidisperseParameters&, const geometry::Box<3>&, std::uint64_t);

}  // namespace arenite::packing
