#include "grains/packing/free_space.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace arenite::packing {

namespace {

using std::numbers::pi;
/// A new one stands off by this share of its distance, so that rounding never makes an overlap.
constexpr double stand_off = 1e-12;
/// Places narrower than this, rad, are taken as none.
constexpr double narrow = 1e-9;

double wrap_into(double v, double v0, double length) {
  v -= std::floor((v - v0) / length) * length;
  return v < v0 + length ? v : v0;
}

}  // namespace

template <int D> bool FreeSpace<D>::fits(const Ball<D>& ball) const {
  const double r = ball.radius;
  for (int axis = 0; axis < D; ++axis) {
    const double at = ball.centre[axis];
    if (box_.periodic[axis] ? 2 * r + gap_ > box_.size[axis] : at - r < box_.corner[axis] || at + r > box_.end()[axis])
      return false;
  }
  for (const BallCells<D>& store : stores_)
    if (store.any_near(ball.centre, r + store.largest() + gap_, [&](const Ball<D>& other) {
          const Vec<D> d = ball.centre - other.centre;
          const double reach = r + other.radius + gap_;
          return dot(d, d) < reach * reach;
        }))
      return false;
  return true;
}

template <int D> Vec<D> FreeSpace<D>::place_beside(const Ball<D>& ball, double radius, Vec<D> direction) const {
  const double distance = (ball.radius + radius + gap_) * (1 + stand_off);
  Vec<D> p = ball.centre + distance * direction;
  for (int axis = 0; axis < D; ++axis)
    if (box_.periodic[axis]) p[axis] = wrap_into(p[axis], box_.corner[axis], box_.size[axis]);
  return p;
}

/// Arcs of the circle of centres round `disk` that other disks or walls forbid, sorted and merged, within [-pi, pi].
template <int D> auto FreeSpace<D>::covered_arcs(const Ball<D>& disk, double radius) const -> std::vector<Arc> {
  const double distance = (disk.radius + radius + gap_) * (1 + stand_off);
  std::vector<Arc> arcs;
  const auto cover = [&](bool walled, double room,
                         double outward) {  // room: how far the centre may move towards the wall
    if (!walled || room >= distance) return;
    const double half = room <= -distance ? pi : std::acos(room / distance);
    arcs.push_back({outward - half, outward + half});
  };
  cover(!box_.periodic[0], disk.centre.x - radius - box_.corner.x, pi);
  cover(!box_.periodic[0], box_.end().x - radius - disk.centre.x, 0);
  cover(!box_.periodic[1], disk.centre.y - radius - box_.corner.y, -pi / 2);
  cover(!box_.periodic[1], box_.end().y - radius - disk.centre.y, pi / 2);
  for (const BallCells<D>& store : stores_)
    store.any_near(disk.centre, distance + radius + store.largest() + gap_, [&](const Ball<D>& other) {
      const Vec<D> d = other.centre - disk.centre;
      const double apart2 = dot(d, d), reach = other.radius + radius + gap_;
      if (apart2 == 0 || apart2 >= (distance + reach) * (distance + reach)) return false;
      const double apart = std::sqrt(apart2);
      const double cosine = (distance * distance + apart2 - reach * reach) / (2 * distance * apart);
      if (cosine >= 1) return false;
      const double half = cosine <= -1 ? pi : std::acos(cosine), towards = std::atan2(d.y, d.x);
      arcs.push_back({towards - half, towards + half});
      return half >= pi;
    });
  const std::size_t n = arcs.size();
  for (std::size_t k = 0; k < n; ++k) {
    if (arcs[k].from < -pi) arcs.push_back({arcs[k].from + 2 * pi, pi});
    if (arcs[k].to > pi) arcs.push_back({-pi, arcs[k].to - 2 * pi});
  }
  std::sort(arcs.begin(), arcs.end(), [](const Arc& a, const Arc& b) { return a.from < b.from; });
  return arcs;
}

template <int D>
std::optional<Vec<D>> FreeSpace<D>::free_place_beside(const Ball<D>& disk, double radius, RandomStream& random) const
    requires(D == 2) {
  std::vector<Arc> open;
  double at = -pi, sum = 0;
  const auto take_until = [&](double to) {
    if (to - at <= narrow) return;
    open.push_back({at, to});
    sum += to - at;
  };
  for (const Arc& arc : covered_arcs(disk, radius)) {
    take_until(arc.from);
    at = std::max(at, arc.to);
  }
  take_until(pi);
  // Ends of an arc touch a neighbour to rounding: there a second try is due, and a place that fails them all is none.
  for (int attempt = 0; attempt < 8 && !open.empty(); ++attempt) {
    double along = sum * random.uniform();
    std::size_t k = 0;
    while (k + 1 < open.size() && along > open[k].to - open[k].from) along -= open[k].to - open[k].from, ++k;
    const double angle = open[k].from + along;
    Vec<D> direction;
    direction.x = std::cos(angle), direction.y = std::sin(angle);
    const Vec<D> place = place_beside(disk, radius, direction);
    if (fits({place, radius})) return place;
  }
  return std::nullopt;
}

template class FreeSpace<2>;
template class FreeSpace<3>;

}  // namespace arenite::packing
