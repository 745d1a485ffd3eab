#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "core/parameters.hpp"
#include "model/image.hpp"
#include "statistics/clusters.hpp"

namespace arenite::imaging {

/// Whether grains are brighter than what is between them.
enum class GrainContrast : std::uint8_t { found, bright, dark };

struct CircleOptions {
  std::vector<double> radii = {};  ///< of the size classes, pixels; empty: found
  double smallest = 2.5,
         largest = 0;  ///< radii looked for where none are given, pixels; 0: half the picture's smaller side
  GrainContrast contrast = GrainContrast::found;
  std::size_t materials = 0;  ///< classes of brightness; 0: found
  double least_score = 0.5;   ///< share of the rim that must show
};

/// Every parameter, lengths in pixels; and those of them that a film's recipe has, too.
void declare(ParameterVisitor& visitor, CircleOptions& options);
void declare_rims(ParameterVisitor& visitor, GrainContrast& contrast, double& least_score);

/// What was found besides the grains.
struct CircleReport {
  bool bright = true;
  std::optional<double> between = {};  ///< grey level between grains, where some are brighter and some darker
  double blur = 0;                     ///< standard deviation of lens and pixel, pixels
  double noise = 0;                    ///< of the picture near rims, in its unit
  statistics::Clusters sizes = {}, materials = {};  ///< by radius, pixels, and by brightness
  double largest_overlap = 0;                       ///< of two circles, pixels
  std::size_t overlapping = 0;  ///< pairs that overlap by more than three standard errors and 2 % of the smaller radius
};

struct FoundCircles {
  PictureGrains grains;  ///< row by row: by y, then x
  CircleReport report;
};

/// Grains of a picture, touching or not, of radii from about 3 pixels on: circles whose rims show edges are taken best
/// first as long as they do not overlap, fitted together (DiskModel), taken away, and what the rest still shows is
/// taken in turn, until nothing is left. Grains may also be brighter and darker than what is between them in one
/// picture. Sizes and brightnesses are parted into classes (statistics::cluster). No grains: empty. Throws InputError
/// for an empty picture, values that are no numbers, or one value everywhere.
FoundCircles find_circles(const FloatImage& image, const CircleOptions& options = {});

/// Grey levels that a picture's pixels gather at, with others on both sides: what is between black and white grains may
/// be one of them. Peaks of the smoothed histogram that hold 1 % of the pixels and fall to half before the next; the
/// fullest first, the darkest and the brightest of all left out. None where there are fewer than three.
std::vector<double> levels_between(const FloatImage& image);

}  // namespace arenite::imaging
