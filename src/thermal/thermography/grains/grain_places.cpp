#include "thermal/thermography/grains/grain_places.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>
#include <utility>

#include "core/mapped.hpp"
#include "core/median.hpp"
#include "model/grain_motion.hpp"
#include "thermal/thermography/grains/follow_grains.hpp"
#include "thermal/thermography/grains/grain_motion.hpp"

namespace arenite::thermography {

PictureGrains moved(const PictureGrains& smallest, const GrainMotion& motion, double phase, double share) {
  PictureGrains grains = smallest;
  for (std::size_t i = 0; i < grains.size(); ++i) grains.centre[i] += share * motion.way(i, phase);
  return grains;
}

GrainMotion motion_from_smallest(const PhasePictures& pictures, const PictureGrains& smallest, double phase,
                                 PictureGrains& middle, int threads) {
  GrainMotion motion;
  for (int round = 0; round < 3; ++round) {
    motion = grain_motion(pictures, middle, threads);
    middle = moved(smallest, motion, phase, 0.5);
  }
  return motion;
}

GrainMotion motion_with_wall(const std::vector<double>& height, double travel, double phase) {
  GrainMotion motion;
  for (const double h : height) {
    const Vec2 amplitude{0, -0.5 * travel * (1 - h)};  // rows point down
    motion.cosine.push_back(std::cos(phase) * amplitude);
    motion.sine.push_back(std::sin(phase) * amplitude);
    motion.error.push_back(0.1 + 0.1 * std::abs(amplitude.y));
  }
  return motion;
}

double error_of_way(const GrainMotion& motion, std::size_t grain) {
  constexpr double sampled = 0.006;  // in films that are drawn 0.4 % of grains that stand alone, 0.8 % of a crowd
  return std::hypot(2 * motion.error[grain], sampled * motion.travel(grain));
}

PictureGrains with_errors_of_way(PictureGrains grains, const GrainMotion& motion) {
  for (std::size_t i = 0; i < motion.size(); ++i)
    if (!grains.position_error.empty() && std::isfinite(motion.error[i]))
      grains.position_error[i] = std::hypot(grains.position_error[i], error_of_way(motion, i));
  return grains;
}

namespace {

/// Mean cosine and sine of the motions of the nearest of the `seen` grains beside grain i.
std::pair<Vec2, Vec2> mean_beside(std::size_t i, const PictureGrains& grains, const GrainMotion& motion,
                                  std::vector<std::size_t> seen) {
  constexpr std::size_t others = 6;
  std::erase(seen, i);
  const std::size_t count = std::min(others, seen.size());
  std::ranges::partial_sort(seen, seen.begin() + static_cast<std::ptrdiff_t>(count), {},
                            [&](std::size_t j) { return norm(grains.centre[j] - grains.centre[i]); });
  std::pair<Vec2, Vec2> mean;
  for (std::size_t k = 0; k < count; ++k)
    mean.first += motion.cosine[seen[k]] / static_cast<double>(count),
        mean.second += motion.sine[seen[k]] / static_cast<double>(count);
  return mean;
}

/// How deep grain i lies in one of those that are seen.
double depth(std::size_t i, const PictureGrains& grains, const std::vector<std::size_t>& seen) {
  double deepest = 0;
  for (const std::size_t j : seen)
    if (j != i)
      deepest = std::max(deepest, grains.radius[i] + grains.radius[j] - norm(grains.centre[j] - grains.centre[i]));
  return deepest;
}

}  // namespace

std::vector<double> settle_lost(const PictureGrains& smallest, double phase, GrainMotion& motion) {
  const auto lost = lost_grains(motion);
  std::vector<std::size_t> seen;
  for (std::size_t i = 0; i < lost.size(); ++i)
    if (!lost[i]) seen.push_back(i);
  if (seen.size() == lost.size() || seen.size() < 2) return {};
  GrainMotion with_others = motion;
  for (std::size_t i = 0; i < lost.size(); ++i)
    std::tie(with_others.cosine[i], with_others.sine[i]) = mean_beside(i, smallest, motion, seen);
  const PictureGrains own = moved(smallest, motion, phase, 1), beside = moved(smallest, with_others, phase, 1);
  double usual = 0;  // of those that are seen
  for (const std::size_t i : seen) usual = std::max(usual, depth(i, own, seen));
  // Of lengths of vectors in the plane, the median is 1.18 standard deviations of a coordinate.
  const double spread = median(mapped(seen, [&](std::size_t i) { return norm(own.centre[i] - beside.centre[i]); })) /
                        std::sqrt(2 * std::numbers::ln2);
  std::vector<double> error(lost.size(), 0.0);
  for (std::size_t i = 0; i < lost.size(); ++i) {
    if (!lost[i]) continue;
    const bool goes = depth(i, own, seen) <= std::max(usual, depth(i, beside, seen));
    if (!goes) motion.cosine[i] = with_others.cosine[i], motion.sine[i] = with_others.sine[i];
    error[i] = goes ? error_of_way(motion, i) : spread;
    if (!smallest.position_error.empty()) error[i] = std::hypot(error[i], smallest.position_error[i]);
  }
  return error;
}

std::size_t forget_lost(const GrainMotion& motion, PeakToPeak& change) {
  const auto lost = lost_grains(motion);
  std::size_t count = 0;
  for (std::size_t i = 0; i < lost.size(); ++i) {
    if (!lost[i]) continue;
    ++count;
    change.temperature[i] = change.sigma_hyd[i] = std::numeric_limits<double>::quiet_NaN();
    change.error[i] = std::numeric_limits<double>::infinity();
  }
  return count;
}

}  // namespace arenite::thermography
