#include "grains/packing/two_classes.hpp"

#include "grains/packing/poisson_disk.hpp"

namespace arenite::packing {
namespace {

CutNormal law_of(const BidisperseParameters& p, double mean) {
  const double spread = p.cut * p.deviation, small = p.large_radius / p.size_ratio;
  if (p.cut_each_class) return {mean, p.deviation * mean, (1 - spread) * mean, (1 + spread) * mean};
  return {mean, p.deviation * mean, (1 - spread) * small, (1 + spread) * p.large_radius};
}

void fill_class(const BidisperseParameters& p, double mean, FreeSpace<2>& space, RandomStream& random) {
  const CutNormal law = law_of(p, mean);
  if (p.hold_radius) return void(fill_holding(space, law, random));
  fill_redrawing(space, law, p.trials, random);
  if (p.maximal) fill_rest(space, law, (1 - p.cut * p.deviation) * mean, random);
}
void fill_class(const BidisperseParameters& p, double mean, FreeSpace<3>& space, RandomStream& random) {
  fill_redrawing(space, law_of(p, mean), p.trials, random);
}

template <int D> void add_class(const BidisperseParameters& p, double mean, FreeSpace<D>& space, RandomStream random) {
  space.open_store(2 * mean);
  fill_class(p, mean, space, random);
}

}  // namespace

template <int D>
TwoClasses<D> sample_two_classes(const BidisperseParameters& p, const geometry::Box<D>& box, double gap,
                                 std::uint64_t seed, std::uint64_t attempt) {
  TwoClasses<D> classes;
  classes.gap = gap;
  FreeSpace<D> space(box, gap);
  add_class(p, p.large_radius, space, RandomStream(seed, Purpose::position, 2 * attempt));
  classes.large = space.balls().size();
  space.set_gap(0);
  add_class(p, p.large_radius / p.size_ratio, space, RandomStream(seed, Purpose::position, 2 * attempt + 1));
  classes.balls = space.balls();
  for (std::size_t i = 0; i < classes.balls.size(); ++i)
    (i < classes.large ? classes.volume_large : classes.volume_small) += classes.balls[i].volume();
  return classes;
}

template <int D> std::size_t leave_out_small(TwoClasses<D>& classes, double volume_ratio, std::uint64_t seed) {
  RandomStream random(seed, Purpose::order);
  const double spare = classes.volume_large / volume_ratio;
  const std::size_t had = classes.small();
  while (classes.small() > 0) {
    Ball<D>& chosen = classes.balls[classes.large + random.below(classes.small())];
    const double volume = chosen.volume();
    if (classes.volume_small - volume / 2 < spare) break;  // without it the ratio would be farther off
    classes.volume_small -= volume;
    chosen = classes.balls.back();
    classes.balls.pop_back();
  }
  return had - classes.small();
}

#define ARENITE_OF(D)                                                                                     \
  template TwoClasses<D> sample_two_classes(const BidisperseParameters&, const geometry::Box<D>&, double, \
                                            std::uint64_t, std::uint64_t);                                \
  template std::size_t leave_out_small(TwoClasses<D>&, double, std::uint64_t);
ARENITE_OF(2)
ARENITE_OF(3)
#undef ARENITE_OF

}  // namespace arenite::packing
