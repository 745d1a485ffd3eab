#include "grains/packing/poisson_disk.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include "grains/packing/free_space.hpp"

namespace arenite::packing {

double CutNormal::draw(RandomStream& random, double below) const {
  const double top = std::min(high, below);
  if (top <= low) return low;
  if (deviation <= 0) return std::clamp(mean, low, top);
  // Rejection from the whole law is cheap where the range holds most of it, rejection from a rectangle where it is
  // narrow.
  if (low <= mean && mean <= top && top - low > 2 * deviation) {
    for (;;)
      if (const double r = mean + deviation * random.normal(); r >= low && r <= top) return r;
  }
  const auto exponent = [&](double r) { return -0.5 * (r - mean) * (r - mean) / (deviation * deviation); };
  const double peak = exponent(std::clamp(mean, low, top));
  for (;;) {
    const double r = random.uniform(low, top);
    if (random.uniform() < std::exp(exponent(r) - peak)) return r;
  }
}

namespace {

/// A unit vector, each as likely.
template <int D> Vec<D> random_direction(RandomStream& random);
template <> Vec2 random_direction<2>(RandomStream& random) {
  const double angle = random.uniform(0, 2 * std::numbers::pi);
  return {std::cos(angle), std::sin(angle)};
}
template <> Vec3 random_direction<3>(RandomStream& random) {
  const double along = random.uniform(-1, 1), across = std::sqrt(1 - along * along);  // Archimedes' hat box
  const Vec2 around = random_direction<2>(random);
  return {across * around.x, across * around.y, along};
}

/// The first one of an empty box, anywhere; false if the radius does not fit into the box at all.
template <int D> bool place_first(FreeSpace<D>& space, double radius, RandomStream& random) {
  const geometry::Box<D>& box = space.box();
  const Vec<D> place = by_axis<D>([&](int axis) {
    const double margin = box.periodic[axis] ? 0 : radius;
    return random.uniform(box.corner[axis] + margin, box.end()[axis] - margin);
  });
  if (!space.fits({place, radius})) return false;
  space.add({place, radius});
  return true;
}

std::vector<std::size_t> indices_of(std::size_t count) {
  std::vector<std::size_t> indices(count);
  std::iota(indices.begin(), indices.end(), std::size_t{0});
  return indices;
}

template <int D>
bool try_beside(FreeSpace<D>& space, std::size_t k, const CutNormal& law, int trials, RandomStream& random) {
  for (int trial = 0; trial < trials; ++trial) {
    const double radius = law.draw(random);
    const Vec<D> place = space.place_beside(space.balls()[k], radius, random_direction<D>(random));
    if (!space.fits({place, radius})) continue;
    space.add({place, radius});
    return true;
  }
  return false;
}

/// One more disk beside disk k where `least` still fits; false if it does not. Drawing again below each radius that
/// fails gives the law's part that fits, in few draws however small that part is.
bool fill_beside(FreeSpace<2>& space, std::size_t k, CutNormal law, double least, RandomStream& random) {
  auto place = space.free_place_beside(space.balls()[k], least, random);
  if (!place) return false;
  double radius = least, below = law.high;
  law.low = least;
  for (int draws = 0; draws < 60; ++draws) {
    const double drawn = law.draw(random, below);
    if (const auto other = space.free_place_beside(space.balls()[k], drawn, random)) {
      place = other;
      radius = drawn;
      break;
    }
    below = drawn;
  }
  space.add({*place, radius});
  return true;
}

}  // namespace

template <int D> void fill_redrawing(FreeSpace<D>& space, const CutNormal& law, int trials, RandomStream& random) {
  if (space.balls().empty() && !place_first(space, law.draw(random), random)) return;
  std::vector<std::size_t> active = indices_of(space.balls().size());
  while (!active.empty()) {
    const std::size_t pick = random.below(active.size());
    if (try_beside(space, active[pick], law, trials, random)) {
      active.push_back(space.balls().size() - 1);
    } else {
      active[pick] = active.back();
      active.pop_back();
    }
  }
}
template void fill_redrawing(FreeSpace<2>&, const CutNormal&, int, RandomStream&);
template void fill_redrawing(FreeSpace<3>&, const CutNormal&, int, RandomStream&);

void fill_rest(FreeSpace<2>& space, const CutNormal& law, double least, RandomStream& random) {
  for (std::size_t k = 0; k < space.balls().size(); ++k)
    while (fill_beside(space, k, law, least, random)) {}
}

double fill_holding(FreeSpace<2>& space, const CutNormal& law, RandomStream& random) {
  double radius = law.draw(random);
  if (space.balls().empty()) {
    if (!place_first(space, radius, random)) return radius;
    radius = law.draw(random);
  }
  std::vector<std::size_t> active = indices_of(space.balls().size());
  // A radius that once did not fit beside a disk never will, nor will a larger one: room only shrinks.
  std::vector<double> too_large(space.balls().size(), 2 * law.high);
  for (std::size_t tried = 0; tried < active.size();) {
    std::swap(active[tried], active[tried + random.below(active.size() - tried)]);
    const std::size_t k = active[tried];
    ++tried;
    if (radius >= too_large[k]) continue;
    if (const auto place = space.free_place_beside(space.balls()[k], radius, random)) {
      space.add({*place, radius});
      active.push_back(space.balls().size() - 1);
      too_large.push_back(2 * law.high);
      radius = law.draw(random);
      tried = 0;
      continue;
    }
    too_large[k] = radius;
    if (radius > law.low) continue;
    active[--tried] = active.back();
    active.pop_back();
  }
  return radius;
}

}  // namespace arenite::packing
