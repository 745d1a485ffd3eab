#pragma once
#include "model/image.hpp"
#include "support/drawn_picture.hpp"

namespace arenite::test {

/// What a search gave against the truth.
struct Score {
  int missed = 0, invented = 0, wrong_material = 0;
  double rms = 0, errors = 0;  ///< of the centre along one axis, pixels; the same over the stated errors
};

/// Grains are held against disks by place and radius; the brighter class must be POM.
inline Score compare(const std::vector<DrawnDisk>& disks, const PictureGrains& grains) {
  Score score;
  std::size_t matched = 0;
  for (const DrawnDisk& d : disks) {
    bool found = false;
    for (std::size_t k = 0; k < grains.size() && !found; ++k) {
      const double away = std::hypot(grains.centre[k].x - d.x, grains.centre[k].y - d.y);
      if (away > 0.3 * d.radius || std::abs(grains.radius[k] - d.radius) > 0.1 * d.radius) continue;
      found = true;
      ++matched;
      score.rms += away * away / 2;
      score.errors += away * away / 2 / (grains.position_error[k] * grains.position_error[k]);
      if ((grains.material[k] == 1) != (d.material == 0)) ++score.wrong_material;
    }
    if (!found) ++score.missed;
  }
  score.invented = static_cast<int>(grains.size() - matched);
  score.rms = std::sqrt(score.rms / static_cast<double>(matched));
  score.errors = std::sqrt(score.errors / static_cast<double>(matched));
  return score;
}

}  // namespace arenite::test
