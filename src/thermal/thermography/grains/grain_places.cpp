#include "thermal/thermography/grains/grain_places.hpp"

#include <cmath>
#include <limits>

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

PictureGrains with_errors_of_way(PictureGrains grains, const GrainMotion& motion) {
  for (std::size_t i = 0; i < motion.size(); ++i)
    if (!grains.position_error.empty() && std::isfinite(motion.error[i]))
      grains.position_error[i] = std::hypot(grains.position_error[i], 2 * motion.error[i]);
  return grains;
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
