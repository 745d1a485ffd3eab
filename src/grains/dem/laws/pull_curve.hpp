#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace arenite::dem {

/// What a cohesion law says of a pair at one gap.
struct PullPoint {
  double energy = 0, pull = 0, slope = 0;  ///< J, N (> 0 pulls) = d energy/d gap, N/m = d pull/d gap
};

/// Pull of one pair against its gap, tabulated once: the energy is a piecewise polynomial of fifth degree that has the
/// law's energy, pull and slope at its nodes, and the pull that acts is its exact derivative. Where the grains overlap
/// the pull is that at gap 0, beyond the reach that at the reach. Nodes lie evenly in u = gap/(gap + scale), so closer
/// where the gap is small.
class PullCurve {
 public:
  static constexpr std::size_t pieces = 48;

  PullCurve() = default;
  /// `at(gap)` gives the PullPoint for gaps from 0 to `reach`, m.
  template <class At> PullCurve(double reach, double scale, const At& at) : reach_(reach), scale_(scale) {
    step_ = reach / (reach + scale) / pieces;
    PullPoint next = node(at, 0);
    at_touch_ = {next.energy, at(0.0).pull, 0};
    for (std::size_t k = 0; k < pieces; ++k) {
      const PullPoint now = next;
      next = node(at, k + 1);
      piece_.push_back(joining(now, next));
    }
  }

  double reach() const { return reach_; }
  double pull(double gap) const {
    if (gap <= 0) return at_touch_.pull;
    gap = std::min(gap, reach_);
    const Place p = place(gap);
    const auto& c = piece_[p.piece];
    const double by_step = c[1] + p.t * (2 * c[2] + p.t * (3 * c[3] + p.t * (4 * c[4] + p.t * 5 * c[5])));
    return by_step / step_ * scale_ / ((gap + scale_) * (gap + scale_));
  }
  double energy(double gap) const {
    if (gap <= 0) return at_touch_.energy + at_touch_.pull * gap;
    if (gap > reach_) return energy(reach_) + pull(reach_) * (gap - reach_);
    const Place p = place(gap);
    const auto& c = piece_[p.piece];
    return c[0] + p.t * (c[1] + p.t * (c[2] + p.t * (c[3] + p.t * (c[4] + p.t * c[5]))));
  }
  /// Largest |d pull/d gap| at a node, N/m.
  double steepest() const { return steepest_; }

 private:
  struct Place {
    std::size_t piece;
    double t;  ///< 0 to 1 along it
  };
  Place place(double gap) const {
    const double along = std::min(gap / (gap + scale_) / step_, static_cast<double>(pieces));
    const auto piece = std::min(static_cast<std::size_t>(along), pieces - 1);
    return {piece, along - static_cast<double>(piece)};
  }
  /// The point at node k, with derivatives by the node's number.
  template <class At> PullPoint node(const At& at, std::size_t k) {
    const double u = static_cast<double>(k) * step_, left = 1 - u;
    const PullPoint p = at(k == pieces ? reach_ : scale_ * u / left);
    steepest_ = std::max({steepest_, p.slope, -p.slope});
    const double stretch = scale_ / (left * left),
                 bend = 2 * stretch / left;  // first and second derivative of the gap by u
    return {p.energy, p.pull * stretch * step_, (p.slope * stretch * stretch + p.pull * bend) * step_ * step_};
  }
  static std::array<double, 6> joining(const PullPoint& a, const PullPoint& b) {
    const double half = 0.5 * a.slope, rise = b.energy - a.energy - a.pull - half, turn = b.pull - a.pull - a.slope,
                 bend = b.slope - a.slope;
    return {a.energy,
            a.pull,
            half,
            10 * rise - 4 * turn + 0.5 * bend,
            -15 * rise + 7 * turn - bend,
            6 * rise - 3 * turn + 0.5 * bend};
  }

  double reach_ = 0, scale_ = 1, step_ = 1, steepest_ = 0;
  PullPoint at_touch_;
  std::vector<std::array<double, 6>> piece_;
};

}  // namespace arenite::dem
