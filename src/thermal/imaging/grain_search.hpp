#pragma once
#include <optional>

#include "thermal/imaging/circles.hpp"
#include "thermal/imaging/disk_model.hpp"
#include "statistics/clusters.hpp"

namespace arenite::imaging {

/// Disks of a picture with their size classes.
struct DiskSearch {
  DiskModel model;
  statistics::Clusters sizes;  ///< of the disks' radii
  bool bright = true;
  std::optional<double> between = {};  ///< level of the background, where disks are brighter and darker
};

/// The search of find_circles. Whether disks are brighter or darker than what is around them is decided, if it is asked,
/// by which of the two accounts for more of the picture after the first round; where the picture has a
/// level between two others (levels_between) and disks on both sides of it account for most of the rest, these are taken.
DiskSearch search_disks(const FloatImage& image, const CircleOptions& options);

}  // namespace arenite::imaging
