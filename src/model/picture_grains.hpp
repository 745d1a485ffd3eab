#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace arenite {

/// Grains found in a picture, in pixels: the centre of the pixel in column c and row r (from the top) is at x = c, y = r.
struct PictureGrains {
  std::vector<double> x, y, radius;       ///< pixels
  std::vector<double> position_error;     ///< standard error of the centre along one axis, pixels
  std::vector<double> radius_error;       ///< pixels
  std::vector<double> brightness;         ///< mean over the inner half of the disk
  std::vector<double> score;              ///< share of the rim that shows an edge, 0 to 1
  std::vector<std::int32_t> material;     ///< index into the classes by brightness, darkest first; -1 unknown
  std::vector<std::int32_t> size_class;   ///< index into the classes of radius, smallest first
  std::size_t size() const { return x.size(); }
};

}  // namespace arenite
