#include "grains/packing/bidisperse.hpp"

#include <cmath>
#include <span>
#include <vector>

#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "grains/packing/free_space.hpp"
#include "grains/packing/gap_search.hpp"
#include "grains/packing/two_classes.hpp"
#include "statistics/correlation.hpp"

namespace arenite::packing {
namespace {

constexpr double smallest_box = 25;  // a few disks along a side: below it classes have no meaning

constexpr std::size_t fewest_small = 10;

template <int D> geometry::Box<D> set_box(DomainIn<D>& domain, double side) {
  for (int s = 0; s < sides_in<D>; ++s) {
    domain.wall[s] = {};
    domain.wall[s].present = !domain.is_periodic(s);
    domain.wall[s].position = s % 2 == 0 ? 0 : side;
  }
  domain.tilt = 0;
  return {{}, domain.size(), domain.periodic};
}

template <int D> double mean_radius(const std::vector<Ball<D>>& balls, std::size_t from, std::size_t to) {
  return statistics::mean_of_known(mapped(std::span(balls).subspan(from, to - from), &Ball<D>::radius));
}

template <int D> void hand_over(const TwoClasses<D>& classes, GrainsIn<D>& grains) {
  grains = {};
  grains.resize(classes.balls.size());
  for (std::size_t i = 0; i < grains.size(); ++i) {
    grains.position[i] = classes.balls[i].centre;
    grains.radius[i] = classes.balls[i].radius;
    grains.material[i] = i < classes.large ? 0 : 1;
  }
}

template <int D> [[noreturn]] void refuse_few_small(const BidisperseParameters& p, const TwoClasses<D>& classes) {
  throw refusal(
      "the volume ratio theta of {:g} is out of reach: it leaves {} small {}, and {} are the fewest; this box "
      "reaches about {:.2g}, a larger one more",
      p.volume_ratio, classes.small(), round_grains<D>, fewest_small,
      classes.volume_large /
          (static_cast<double>(fewest_small) * geometry::volume_of_ball<D>(p.large_radius / p.size_ratio)));
}

}  // namespace

void BidisperseParameters::declare(ParameterVisitor& v) {
  v.number({"large_radius", "Mean radius of the large grains.", true}, large_radius, "mm", range::positive);
  v.number({"size_ratio", "gamma: ratio of the mean radii of large and small grains."}, size_ratio, "",
           range::between(1, 20));
  v.number({"volume_ratio", "theta: ratio of the areas of large and small disks, of the volumes of spheres."},
           volume_ratio, "", range::above(0, 100));
  v.number({"deviation", "Standard deviation of each class over its mean radius."}, deviation, "",
           range::between(0, 0.5));
  v.number({"truncation", "Radii are truncated at this many standard deviations.", false, "cut"}, cut, "",
           range::above(0, 1.9));
  v.flag({"truncate_each_class", "Each class is truncated separately; otherwise both to their common range.", false,
          "cut_each_class"},
         cut_each_class);
  v.flag({"hold_radius",
          "A radius is kept until it is placed; otherwise it is redrawn at each trial, which favours small ones. Of "
          "disks."},
         hold_radius);
  v.number({"box_area",
            "Area of the square box over pi large_radius^2; in space volume of the cube over that of a sphere of "
            "large_radius."},
           box_area, "", range::between(smallest_box, 1e6));
  v.integer({"trials", "Number of positions tried around a grain before it is abandoned."}, trials, {1, 10'000});
  v.flag({"maximal",
          "After the trials every remaining place where a disk of the class fits is filled; the paper stops after the "
          "trials. Of disks."},
         maximal);
  v.number(
      {"tolerance", "Relative error of the volume ratio at which the search for the gap between large grains ends."},
      tolerance, "", range::between(1e-4, 0.5));
  v.require(deviation * cut < 0.95, {"truncation", "deviation"},
            "radii would be truncated at less than 5 % of their mean; lower truncation or deviation");
}

template <int D> void check(const BidisperseParameters& p) {
  constexpr double most_placed = 2e6;
  Problems problems;
  const auto finite_above = [](double v, double least) { return std::isfinite(v) && v > least; };
  problems.unless(finite_above(p.large_radius, 0), "the mean radius of large grains is {:g} m; give a positive one",
                  p.large_radius);
  problems.unless(
      p.deviation >= 0 && p.cut >= 0 && p.cut * p.deviation < 1,
      "radii truncated at {:g} standard deviations of {:g} of the mean reach zero or below; keep their product below 1",
      p.cut, p.deviation);
  problems.unless(p.trials >= 1, "{} trials around a grain; give 1 or more", p.trials);
  problems.unless(p.tolerance > 0, "the tolerance of the volume ratio is {:g}; give a positive one such as 0.01",
                  p.tolerance);
  const bool box = std::isfinite(p.box_area) && p.box_area >= smallest_box;
  problems.unless(box, "a box of {:g} times a mean large grain holds too few of them; give {:g} or more", p.box_area,
                  smallest_box);
  problems.unless(finite_above(p.volume_ratio, 0), "the volume ratio theta is {:g}; it must be positive",
                  p.volume_ratio);
  const double most = box ? geometry::side_of_cube<D>(most_placed / p.box_area) : 1;
  problems.unless(p.size_ratio >= 1 && p.size_ratio <= most,
                  "the size ratio gamma is {:g}; in this box it can be from 1 to {:.0f}, beyond which there are more "
                  "than {:g} small {}",
                  p.size_ratio, std::floor(most), most_placed, round_grains<D>);
  problems.unless(D == 2 || (!p.hold_radius && !p.maximal), "{}", of_disks_alone);
  problems.raise();
}

template <int D>
BidisperseReport sample_bidisperse(PackingIn<D>& packing, const BidisperseParameters& p, std::uint64_t seed) {
  check<D>(p);
  const double side = geometry::side_of_cube<D>(p.box_area * geometry::volume_of_ball<D>(1)) * p.large_radius;
  DomainIn<D> domain = packing.domain;
  const geometry::Box<D> box = set_box<D>(domain, side);
  TwoClasses<D> classes = find_gap(p, box, seed);

  BidisperseReport report;
  report.samplings = classes.samplings;
  report.gap = classes.gap;
  if (classes.volume_ratio() < p.volume_ratio * (1 - p.tolerance))
    report.left_out = leave_out_small(classes, p.volume_ratio, seed);
  report.large = classes.large;
  report.small = classes.small();
  if (report.small < fewest_small) refuse_few_small(p, classes);
  packing.domain = domain;
  packing.contacts = {};
  hand_over(classes, packing.grains);
  report.volume_ratio = classes.volume_ratio();
  report.volume_ratio_error = report.volume_ratio / p.volume_ratio - 1;
  report.solid_fraction = (classes.volume_large + classes.volume_small) / geometry::volume_of(box);
  report.mean_large = mean_radius(classes.balls, 0, classes.large);
  report.mean_small = mean_radius(classes.balls, classes.large, classes.balls.size());
  return report;
}

#define ARENITE_OF(D)                                  \
  template void check<D>(const BidisperseParameters&); \
  template BidisperseReport sample_bidisperse(PackingIn<D>&, const BidisperseParameters&, std::uint64_t);
ARENITE_OF(2)
ARENITE_OF(3)
#undef ARENITE_OF

}  // namespace arenite::packing
