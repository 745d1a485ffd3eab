#include "grains/packing/two_classes.hpp"

#include <numbers>

#include "grains/packing/poisson_disk.hpp"

namespace arenite::packing {
namespace {

using std::numbers::pi;

CutNormal law_of(const BidisperseParameters& p, double mean) {
  const double spread = p.cut * p.deviation, small = p.large_radius / p.size_ratio;
  if (p.cut_each_class) return {mean, p.deviation * mean, (1 - spread) * mean, (1 + spread) * mean};
  return {mean, p.deviation * mean, (1 - spread) * small, (1 + spread) * p.large_radius};
}

void add_class(const BidisperseParameters& p, double mean, FreeSpace& space, RandomStream random) {
  space.open_store(2 * mean);
  const CutNormal law = law_of(p, mean);
  if (p.hold_radius) fill_holding(space, law, random);
  else fill_redrawing(space, law, p.trials, p.maximal ? (1 - p.cut * p.deviation) * mean : 0, random);
}

}  // namespace

TwoClasses sample_two_classes(const BidisperseParameters& p, const geometry::Box<2>& box, double gap,
                              std::uint64_t seed, std::uint64_t attempt) {
  TwoClasses classes;
  classes.gap = gap;
  FreeSpace space(box, gap);
  add_class(p, p.large_radius, space, RandomStream(seed, Purpose::position, 2 * attempt));
  classes.large = space.disks().size();
  space.set_gap(0);
  add_class(p, p.large_radius / p.size_ratio, space, RandomStream(seed, Purpose::position, 2 * attempt + 1));
  classes.disks = space.disks();
  for (std::size_t i = 0; i < classes.disks.size(); ++i)
    (i < classes.large ? classes.area_large : classes.area_small) +=
        pi * classes.disks[i].radius * classes.disks[i].radius;
  return classes;
}

std::size_t leave_out_small(TwoClasses& classes, double volume_ratio, std::uint64_t seed) {
  RandomStream random(seed, Purpose::order);
  const double spare = classes.area_large / volume_ratio;
  const std::size_t had = classes.disks.size() - classes.large;
  while (classes.disks.size() > classes.large) {
    Disk& chosen = classes.disks[classes.large + random.below(classes.disks.size() - classes.large)];
    const double area = pi * chosen.radius * chosen.radius;
    if (classes.area_small - area / 2 < spare) break;  // without it the ratio would be farther off
    classes.area_small -= area;
    chosen = classes.disks.back();
    classes.disks.pop_back();
  }
  return had - (classes.disks.size() - classes.large);
}

}  // namespace arenite::packing
