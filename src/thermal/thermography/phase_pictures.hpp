#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "model/film.hpp"
#include "model/grain_motion.hpp"
#include "model/lockin_maps.hpp"
#include "statistics/least_squares.hpp"
#include "thermal/thermography/lockin.hpp"

namespace arenite::thermography {

/// Turns a picture into the coefficients of the cubic spline through its pixels. Rims in thermal pictures are little
/// wider than a pixel: local cubics, whose slopes are differences of neighbours, see them a third too flat.
void spline_coefficients(float* picture, int width, int height);

/// The spline between pixels, beyond the picture that of its outermost pixels; pictures are given by their
/// coefficients.
class Resampled {
 public:
  Resampled(int width, int height, Vec2 place) : width_(width), x_(place.x, width), y_(place.y, height) {}

  /// The value and the slope, a pixel.
  double of(const float* picture, Vec2& slope) const {
    double sum = 0;
    slope = {};
    for (int j = 0; j < 4; ++j) {
      const double value = line(picture, j, x_.weight);
      sum += y_.weight[j] * value;
      slope.y += y_.slope[j] * value;
      slope.x += y_.weight[j] * line(picture, j, x_.slope);
    }
    return sum;
  }

  /// Variance of the value over that of the pixels.
  double noise() const { return x_.noise() * y_.noise(); }

 private:
  /// The four pixels along one axis, with the weights of the spline and of its slope.
  struct Axis {
    int pixel[4];
    double u, weight[4], slope[4];

    Axis(double place, int pixels) : u(place - std::floor(place)) {
      for (int k = 0; k < 4; ++k) pixel[k] = std::clamp(static_cast<int>(std::floor(place)) - 1 + k, 0, pixels - 1);
      const double v = 1 - u;
      weight[0] = v * v * v / 6;
      weight[1] = 2.0 / 3 - u * u * (1 - u / 2);
      weight[2] = 2.0 / 3 - v * v * (1 - v / 2);
      weight[3] = u * u * u / 6;
      slope[0] = -v * v / 2;
      slope[1] = u * (1.5 * u - 2);
      slope[2] = -v * (1.5 * v - 2);
      slope[3] = u * u / 2;
    }
    /// 1 on a pixel, about 0.76 halfway to the next.
    double noise() const { return 1 - 0.96 * u * (1 - u); }
  };

  double line(const float* picture, int j, const double (&w)[4]) const {
    const float* row = picture + static_cast<std::ptrdiff_t>(y_.pixel[j]) * width_;
    const auto at = [&](int k) { return static_cast<double>(row[x_.pixel[k]]); };
    return w[0] * at(0) + w[1] * at(1) + w[2] * at(2) + w[3] * at(3);
  }

  int width_;
  Axis x_, y_;
};

/// Mean pictures of a cyclically loaded sample at phases of its load, as under a stroboscope: frames whose phase falls
/// into the same part of the cycle are averaged, less drift of the lock-in's order, which frames of a like phase show.
/// What moves or warms with the load is in these few pictures with all of the film's signal to noise.
struct PhasePictures {
  int width = 0, height = 0;
  std::vector<double> frames;     ///< in every picture
  std::vector<Harmonics> phases;  ///< means over the frames of every picture
  std::vector<float> spline;      ///< pictures x height x width: coefficients of the cubic spline through the pixels

  std::size_t size() const { return frames.size(); }
  std::size_t pixels() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
  const float* picture(std::size_t k) const { return spline.data() + k * pixels(); }
  /// Where a grain is in picture k, from its mean place.
  Vec2 moved(const GrainMotion& motion, std::size_t grain, std::size_t k) const {
    return motion.at(grain, phases[k][1], phases[k][2]);
  }
};

/// One pass over the film, with the frequency and the drift's order of its lock-in; pictures are at the film's mean
/// or, where pixels jump each on its own, between those jumps where the mean is smoothest.
/// Parts of the cycle in which there is no frame have no picture. Empty if `options.progress` stopped it.
PhasePictures phase_pictures(FilmSource& film, const LockinMaps& maps, const LockinOptions& options,
                             std::size_t parts = 48);

/// One of the pictures itself, rows from the top.
std::vector<float> picture_of(const PhasePictures& pictures, std::size_t k);

/// The picture whose phase is nearest to that of the smallest load, where the load goes as cos(2 pi f t - phase).
std::size_t picture_at_smallest_load(const PhasePictures& pictures, double phase);

/// The phase of a load that is largest where one of this phase is smallest, -pi to pi.
double opposite(double phase);

/// Whether two phases are more than a quarter of a cycle apart.
bool are_opposite(double phase, double other);

/// What one place that follows a grain shows: mean, first and second harmonic, slope of the mean picture.
struct Followed {
  Harmonics harmonics{};
  Vec2 slope;
  double variance = 0;  ///< of one frame's noise, from what the harmonics leave
};

/// Least squares of mean and two harmonics in places that move with a grain.
class PixelHarmonics {
 public:
  PixelHarmonics(const PhasePictures& pictures, const GrainMotion& motion, std::size_t grain);
  /// `place` when the grain is in the middle of its motion.
  Followed follow(const PhasePictures& pictures, Vec2 place) const;

 private:
  std::vector<Vec2> moved_;  ///< in every picture
  statistics::Matrix fit_;   ///< pictures x 5
};

}  // namespace arenite::thermography
