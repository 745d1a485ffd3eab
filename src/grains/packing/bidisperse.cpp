#include "grains/packing/bidisperse.hpp"

#include <cmath>
#include <numbers>
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

using std::numbers::pi;
constexpr std::size_t fewest_small = 10;

geometry::Box<2> set_box(Domain& domain, double side) {
  for (int s = 0; s < 4; ++s) {
    domain.wall[s] = Wall{};
    domain.wall[s].present = !domain.is_periodic(s);
  }
  domain.wall[right].position = domain.wall[top].position = side;
  domain.tilt = 0;
  return {{}, {side, side}, domain.periodic};
}

double mean_radius(const std::vector<Disk>& disks, std::size_t from, std::size_t to) {
  return statistics::mean_of_known(mapped(std::span(disks).subspan(from, to - from), &Disk::radius));
}

void hand_over(const TwoClasses& classes, Grains& grains) {
  grains = {};
  grains.resize(classes.disks.size());
  for (std::size_t i = 0; i < grains.size(); ++i) {
    grains.position[i] = classes.disks[i].centre;
    grains.radius[i] = classes.disks[i].radius;
    grains.material[i] = i < classes.large ? 0 : 1;
  }
}

[[noreturn]] void refuse_few_small(const BidisperseParameters& p, const TwoClasses& classes) {
  const double small = p.large_radius / p.size_ratio;
  throw refusal(
      "the volume ratio theta of {:g} is out of reach: it leaves {} small disks, and {} are the fewest; this box "
      "reaches about {:.2g}, a larger one more",
      p.volume_ratio, classes.disks.size() - classes.large, fewest_small,
      classes.area_large / (static_cast<double>(fewest_small) * pi * small * small));
}

}  // namespace

void BidisperseParameters::declare(ParameterVisitor& v) {
  v.number({"large_radius", "Mean radius of the large disks.", true}, large_radius, "mm", range::positive);
  v.number({"size_ratio", "gamma: ratio of the mean radii of large and small disks."}, size_ratio, "",
           range::between(1, 20));
  v.number({"volume_ratio", "theta: ratio of the areas of large and small disks."}, volume_ratio, "",
           range::above(0, 100));
  v.number({"deviation", "Standard deviation of each class over its mean radius."}, deviation, "",
           range::between(0, 0.5));
  v.number({"truncation", "Radii are truncated at this many standard deviations.", false, "cut"}, cut, "",
           range::above(0, 1.9));
  v.flag({"truncate_each_class", "Each class is truncated separately; otherwise both to their common range.", false,
          "cut_each_class"},
         cut_each_class);
  v.flag({"hold_radius",
          "A radius is kept until it is placed; otherwise it is redrawn at each trial, which favours small ones."},
         hold_radius);
  v.number({"box_area", "Area of the square box over pi large_radius^2."}, box_area, "", range::between(20, 1e6));
  v.integer({"trials", "Number of positions tried around a disk before it is abandoned."}, trials, {1, 10'000});
  v.flag({"maximal",
          "After the trials every remaining place where a disk of the class fits is filled; the paper stops after the "
          "trials."},
         maximal);
  v.number(
      {"tolerance", "Relative error of the volume ratio at which the search for the gap between large disks ends."},
      tolerance, "", range::between(1e-4, 0.5));
  v.require(deviation * cut < 0.95, {"truncation", "deviation"},
            "radii would be truncated at less than 5 % of their mean; lower truncation or deviation");
}

void check(const BidisperseParameters& p) {
  constexpr double smallest_box = 25;  // a few disks along a side: below it classes have no meaning
  constexpr double most_disks = 2e6;
  Problems problems;
  const auto finite_above = [](double v, double least) { return std::isfinite(v) && v > least; };
  problems.unless(finite_above(p.large_radius, 0), "the mean radius of large disks is {:g} m; give a positive one",
                  p.large_radius);
  problems.unless(
      p.deviation >= 0 && p.cut >= 0 && p.cut * p.deviation < 1,
      "radii truncated at {:g} standard deviations of {:g} of the mean reach zero or below; keep their product below 1",
      p.cut, p.deviation);
  problems.unless(p.trials >= 1, "{} trials around a disk; give 1 or more", p.trials);
  problems.unless(p.tolerance > 0, "the tolerance of the volume ratio is {:g}; give a positive one such as 0.01",
                  p.tolerance);
  const bool box = std::isfinite(p.box_area) && p.box_area >= smallest_box;
  problems.unless(box, "a box of {:g} pi times the squared mean radius holds too few large disks; give {:g} or more",
                  p.box_area, smallest_box);
  problems.unless(finite_above(p.volume_ratio, 0), "the volume ratio theta is {:g}; it must be positive",
                  p.volume_ratio);
  const double most = box ? std::sqrt(most_disks / p.box_area) : 1;
  problems.unless(p.size_ratio >= 1 && p.size_ratio <= most,
                  "the size ratio gamma is {:g}; in this box it can be from 1 to {:.0f}, beyond which there are more "
                  "than {:g} small disks",
                  p.size_ratio, std::floor(most), most_disks);
  problems.raise();
}

BidisperseReport sample_bidisperse(Packing& packing, const BidisperseParameters& p, std::uint64_t seed) {
  check(p);
  const double side = std::sqrt(p.box_area * pi) * p.large_radius;
  Domain domain = packing.domain;
  const geometry::Box<2> box = set_box(domain, side);
  TwoClasses classes = find_gap(p, box, seed);

  BidisperseReport report;
  report.samplings = classes.samplings;
  report.gap = classes.gap;
  if (classes.volume_ratio() < p.volume_ratio * (1 - p.tolerance))
    report.left_out = leave_out_small(classes, p.volume_ratio, seed);
  report.large = classes.large;
  report.small = classes.disks.size() - classes.large;
  if (report.small < fewest_small) refuse_few_small(p, classes);
  packing.domain = domain;
  packing.contacts = {};
  hand_over(classes, packing.grains);
  report.volume_ratio = classes.volume_ratio();
  report.volume_ratio_error = report.volume_ratio / p.volume_ratio - 1;
  report.solid_fraction = (classes.area_large + classes.area_small) / (side * side);
  report.mean_large = mean_radius(classes.disks, 0, classes.large);
  report.mean_small = mean_radius(classes.disks, classes.large, classes.disks.size());
  return report;
}

}  // namespace arenite::packing
