#pragma once
#include <cstddef>
#include <vector>

namespace arenite {

/// Motion of every grain at the load frequency, in pixels (y down): x(t) = x_mean + Re[(cx + i sx) exp(-i 2 pi f t)],
/// that is cx cos(2 pi f t) + sx sin(2 pi f t); t in s after the first frame.
struct GrainMotion {
  std::vector<double> cos_x, sin_x, cos_y, sin_y;
  std::vector<double> error;        ///< standard error of each of the four
  std::size_t size() const { return cos_x.size(); }
};

/// Swing of the stress of every grain between the smallest and the largest load, as a film shows it.
struct GrainSwing {
  std::vector<double> temperature;  ///< full swing of the mean over the grain's centre, K
  std::vector<double> sigma_hyd;    ///< full swing of (sigma_1 + sigma_2)/2, Pa; tension positive
  std::vector<double> error;        ///< standard error of sigma_hyd from pixel noise and position error, Pa
  std::vector<double> pixels;       ///< area that was averaged, pixels
  std::size_t size() const { return temperature.size(); }
};

}  // namespace arenite
