#pragma once
#include "imaging/circles.hpp"
#include "imaging/disk_model.hpp"
#include "statistics/clusters.hpp"

namespace arenite::imaging {

/// Disks of a picture with their size classes.
struct DiskSearch {
  DiskModel model;
  statistics::Clusters sizes;  ///< of the disks' radii
  bool bright = true;
};

/// The search of find_circles. Whether disks are brighter or darker than what is around them is decided, if it is asked,
/// by which of the two accounts for more of the picture after the first round.
DiskSearch search_disks(const FloatImage& image, const CircleOptions& options);

}  // namespace arenite::imaging
