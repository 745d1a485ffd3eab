#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "model/film.hpp"
#include "statistics/least_squares.hpp"
#include "thermal/thermography/lockin.hpp"

namespace arenite::thermography {

/// Turns a picture into the coefficients of the cubic spline through its pixels. Rims in thermal pictures are little wider
/// than a pixel: local cubics, whose slopes are differences of neighbours, see them a third too flat.
void spline_coefficients(float* picture, int width, int height);

/// The spline between pixels, beyond the picture that of its outermost pixels; pictures are given by their coefficients.
class Resampled {
 public:
  Resampled(int width, int height, double x, double y) : width_(width) {
    const double left = std::floor(x), top = std::floor(y);
    u_ = x - left;
    v_ = y - top;
    weigh(u_, wx_, sx_);
    weigh(v_, wy_, sy_);
    for (int k = 0; k < 4; ++k) {
      column_[k] = std::clamp(static_cast<int>(left) - 1 + k, 0, width - 1);
      row_[k] = std::clamp(static_cast<int>(top) - 1 + k, 0, height - 1);
    }
  }

  double of(const float* picture) const {
    double sum = 0;
    for (int j = 0; j < 4; ++j) sum += wy_[j] * line(picture, j, wx_);
    return sum;
  }

  /// With the slopes along x and y, a pixel.
  double of(const float* picture, double& slope_x, double& slope_y) const {
    double sum = 0;
    slope_x = slope_y = 0;
    for (int j = 0; j < 4; ++j) {
      const double value = line(picture, j, wx_);
      sum += wy_[j] * value;
      slope_y += sy_[j] * value;
      slope_x += wy_[j] * line(picture, j, sx_);
    }
    return sum;
  }

  /// Variance of the value over that of the pixels: 1 on a pixel, about 0.76 an axis halfway to the next.
  double noise() const { return (1 - 0.96 * u_ * (1 - u_)) * (1 - 0.96 * v_ * (1 - v_)); }

 private:
  double line(const float* picture, int j, const double (&w)[4]) const {
    const float* row = picture + static_cast<std::ptrdiff_t>(row_[j]) * width_;
    return w[0] * static_cast<double>(row[column_[0]]) + w[1] * static_cast<double>(row[column_[1]]) + w[2] * static_cast<double>(row[column_[2]]) +
           w[3] * static_cast<double>(row[column_[3]]);
  }

  static void weigh(double u, double (&w)[4], double (&s)[4]) {
    const double v = 1 - u;
    w[0] = v * v * v / 6;
    w[1] = 2.0 / 3 - u * u * (1 - u / 2);
    w[2] = 2.0 / 3 - v * v * (1 - v / 2);
    w[3] = u * u * u / 6;
    s[0] = -v * v / 2;
    s[1] = u * (1.5 * u - 2);
    s[2] = -v * (1.5 * v - 2);
    s[3] = u * u / 2;
  }

  int width_;
  int column_[4], row_[4];
  double u_, v_, wx_[4], wy_[4], sx_[4], sy_[4];
};

/// 1, cosine and sine of the phase 2 pi f t, and of twice the phase.
using Harmonics = std::array<double, 5>;

/// Mean pictures of a cyclically loaded sample at phases of its load, as under a stroboscope: frames whose phase falls
/// into the same part of the cycle are averaged, less drift of the lock-in's order, which frames of a like phase show. What
/// moves or warms with the load is in these few pictures with all of the film's signal to noise.
struct PhasePictures {
  int width = 0, height = 0;
  std::vector<double> frames;     ///< in every picture
  std::vector<Harmonics> phases;  ///< means over the frames of every picture
  std::vector<float> spline;      ///< pictures x height x width: coefficients of the cubic spline through the pixels

  std::size_t size() const { return frames.size(); }
  std::size_t pixels() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
  const float* picture(std::size_t k) const { return spline.data() + k * pixels(); }
  /// Where a grain is in picture k, from its mean place.
  Vec2 moved(const GrainMotion& motion, std::size_t grain, std::size_t k) const { return motion.at(grain, phases[k][1], phases[k][2]); }
};

/// One pass over the film, with the frequency and the drift's order of its lock-in; pictures are at the film's mean. Parts of
/// the cycle in which there is no frame have no picture. Empty if `options.progress` stopped it.
PhasePictures phase_pictures(FilmSource& film, const LockinMaps& maps, const LockinOptions& options, std::size_t parts = 48);

/// One of the pictures itself, rows from the top.
std::vector<float> picture_of(const PhasePictures& pictures, std::size_t k);

/// What one place that follows a grain shows: mean, first and second harmonic, slopes of the mean picture.
struct Followed {
  Harmonics harmonics{};
  double slope_x = 0, slope_y = 0;
  double variance = 0;  ///< of one frame's noise, from what the harmonics leave
};

/// Least squares of mean and two harmonics in places that move with a grain.
class PixelHarmonics {
 public:
  PixelHarmonics(const PhasePictures& pictures, const GrainMotion& motion, std::size_t grain);
  /// (x, y) is the place when the grain is in the middle of its motion.
  Followed follow(const PhasePictures& pictures, double x, double y) const;

 private:
  std::vector<Vec2> moved_;  ///< in every picture
  statistics::Matrix fit_;   ///< pictures x 5
};

}  // namespace arenite::thermography
