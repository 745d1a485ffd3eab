#pragma once
#include <vector>

#include "model/picture_grains.hpp"
#include "thermal/thermography/phase_pictures.hpp"
#include "thermal/thermography/resample.hpp"

namespace arenite::thermography {

/// Rim of a grain that another grain's rim is seen beside.
struct OtherRim {
  std::size_t pixel = 0, grain = 0; ///< of the list, and of the grains
  double inside = 0;                ///< share of the pixel in that grain
  double slope_x = 0, slope_y = 0;  ///< of that share, a pixel
};

/// Pixels on both sides of a grain's rim that are in no other grain.
struct RimPixels {
  std::vector<double> x, y;                         ///< pixels
  std::vector<double> from_centre_x, from_centre_y; ///< over the radius
  std::vector<double> inside;                       ///< share of the pixel in the grain, over the width of a blurred rim
  std::vector<double> weight;
  std::vector<OtherRim> others;     ///< blurred rims of neighbours that reach into these pixels
};

std::vector<RimPixels> rim_pixels(const PictureGrains& grains, int width, int height, double rim);

/// What one place that follows a grain shows: mean, swing, second harmonic, slopes of the mean picture.
struct Followed {
  double mean = 0, cosine = 0, sine = 0, cosine2 = 0, sine2 = 0;
  double slope_x = 0, slope_y = 0;
  double variance = 0;              ///< of one frame's noise, from what the swings leave
};

/// Least squares of mean and two harmonics in places that move with a grain.
class SwingOfPixels {
 public:
  SwingOfPixels(const PhasePictures& pictures, double cos_x, double sin_x, double cos_y, double sin_y);
  /// (x, y) is the place when the grain is in the middle of its swing.
  Followed follow(const PhasePictures& pictures, double x, double y) const;

 private:
  std::vector<double> dx_, dy_;     ///< motion in every picture
  std::vector<double> fit_;         ///< 5 x pictures
};

}  // namespace arenite::thermography
