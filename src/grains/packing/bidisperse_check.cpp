#include <fmt/format.h>

#include <cmath>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "grains/packing/bidisperse_steps.hpp"

namespace arenite::packing {

namespace {

constexpr double smallest_box = 25;      // a few disks along a side: below it classes have no meaning
constexpr double most_disks = 2e6;

}  // namespace

void check(const BidisperseParameters& p) {
  std::vector<Problem> problems;
  const auto need = [&](bool good, std::string message) {
    if (!good) problems.push_back({{}, 0, 0, std::move(message)});
  };
  const auto finite_above = [](double v, double least) { return std::isfinite(v) && v > least; };
  need(finite_above(p.large_radius, 0), fmt::format("the mean radius of large disks is {:g} m; give a positive one", p.large_radius));
  need(p.deviation >= 0 && p.cut >= 0 && p.cut * p.deviation < 1,
       fmt::format("radii cut at {:g} deviations of {:g} of the mean reach zero or below; keep their product below 1", p.cut, p.deviation));
  need(p.trials >= 1, fmt::format("{} trials round a disk; take 1 or more", p.trials));
  need(p.tolerance > 0, fmt::format("the tolerance of the volume ratio is {:g}; take a positive one such as 0.01", p.tolerance));
  const bool box = std::isfinite(p.box_area) && p.box_area >= smallest_box;
  need(box, fmt::format("a box of {:g} pi times the squared mean radius holds too few large disks; take {:g} or more", p.box_area, smallest_box));
  need(finite_above(p.volume_ratio, 0), fmt::format("the volume ratio theta is {:g}; it must be positive", p.volume_ratio));
  const double most = box ? std::sqrt(most_disks / p.box_area) : 1;
  need(p.size_ratio >= 1 && p.size_ratio <= most,
       fmt::format("the size ratio gamma is {:g}; in this box it can be from 1 to {:.0f}, beyond which there are more than {:g} small disks",
                   p.size_ratio, std::floor(most), most_disks));
  if (!problems.empty()) throw InputError(std::move(problems));
}

}  // namespace arenite::packing
