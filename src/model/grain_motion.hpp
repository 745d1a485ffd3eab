#pragma once
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/vec.hpp"

namespace arenite {

/// Motion of every grain about its mean place at the load frequency, in pixels (y down): cosine cos(2 pi f t) + sine
/// sin(2 pi f t), t in s after the first frame.
struct GrainMotion {
  std::vector<Vec2> cosine, sine;
  std::vector<double> error;          ///< standard error of each of the four coordinates
  std::vector<double> by_pixel = {};  ///< what it would be if what is left in pixels were independent; empty: `error`
  std::size_t size() const { return cosine.size(); }
  /// From its mean place, where the phase 2 pi f t has this cosine and sine.
  Vec2 at(std::size_t grain, double c, double s) const { return c * cosine[grain] + s * sine[grain]; }
  /// From the smallest to the largest load, which goes as cos(2 pi f t - phase).
  Vec2 way(std::size_t grain, double phase) const { return 2 * at(grain, std::cos(phase), std::sin(phase)); }
  /// Length of the way in whatever phase it is, peak to peak.
  double travel(std::size_t grain) const { return 2 * std::hypot(norm(cosine[grain]), norm(sine[grain])); }
};

/// Peak-to-peak change of temperature and stress of every grain between the smallest and the largest load, as a film
/// shows it.
struct PeakToPeak {
  std::vector<double> temperature;  ///< of the mean over the grain's centre, K
  std::vector<double> sigma_hyd;    ///< of (sigma_1 + sigma_2)/2, Pa; tension positive
  std::vector<double> error;        ///< standard error of sigma_hyd from pixel noise and position error, Pa
  std::vector<double> pixels;       ///< area that was averaged, pixels
  std::size_t size() const { return temperature.size(); }
};

}  // namespace arenite
