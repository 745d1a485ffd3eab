#pragma once
#include <vector>

#include "model/image.hpp"
#include "thermal/imaging/circles.hpp"
#include "thermal/imaging/disk_model.hpp"

namespace arenite::imaging {

/// Convolution with a Gaussian of this standard deviation in pixels; pixels beyond the edge repeat the edge.
FloatImage blurred(const FloatImage& image, double sigma);

/// Mean of every two by two pixels; an odd last row or column is left out. Pixel (c, r) lies at (2c + 0.5, 2r + 0.5).
FloatImage halved(const FloatImage& image);

/// Standard deviation of the noise from pixel to pixel: the median size of a second difference that is blind to slopes
/// in x and y, so edges count as little as they are rare.
double noise_level(const FloatImage& image);

/// Pixels first .. last of a row.
struct Run {
  int y, first, last;
};

/// Pixels that are open (not 0).
using Mask = Picture<char>;

/// The open pixels and those beside them, row by row.
std::vector<Run> runs_of(const Mask& open);

/// Open pixels of a picture halved, with those beside them, since a centre may yet move by a pixel.
Mask halved_open(const Mask& open);

struct RimOptions {
  bool bright = true;  ///< disks brighter than what is around them
  double smallest = 1.6,
         largest = 8;  ///< radii of the steepest slope, pixels; in small disks it lies up to 1 pixel inside the rim
  double least = 0.1;  ///< score below which a circle is not listed
  const Mask* open = nullptr;  ///< where centres can lie; null: everywhere
};

/// Circles whose rims show edges: the slope along the normal in a ring, against the root mean square slope nearby, each
/// pixel's share cut at 1 (and at -0.3 for the wrong sign), so that uneven light, unlike materials and single strong
/// edges count little. Radii go up by 5 % a step, on pictures halved until a radius is below 8 pixels. Local maxima
/// over place and radius, best first. What of a rim lies outside the picture counts as not seen.
std::vector<Circle> search_rims(const FloatImage& image, const RimOptions& options);

/// Grey levels that a picture's pixels gather at, with others on both sides: what is between black and white grains may
/// be one of them. Peaks of the smoothed histogram that hold 1 % of the pixels and fall to half before the next; the
/// fullest first, the darkest and the brightest of all left out. None where there are fewer than three.
std::vector<double> levels_between(const FloatImage& image);

/// The smallest radius of which a blurred picture still shows a rim and not a spot, pixels.
inline double least_resolved(const DiskModel& model) { return 2.5 * model.blur(); }

/// Marks the disks of a fitted model that the picture does not bear out: little contrast, little rim, not flat, a size
/// that makes up next to nothing (dirt), or on top of a better disk. With `strict` rims and flatness are also held
/// against those of the median disk by area, which tells a cluster of small grains from one large grain once most are
/// found.
std::vector<char> refuted_disks(const DiskModel& model, const CircleOptions& options, bool strict);

}  // namespace arenite::imaging
