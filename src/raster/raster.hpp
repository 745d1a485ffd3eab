#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "model/cement.hpp"
#include "model/packing.hpp"
#include "model/phase_map.hpp"

/// From geometry to nodes (P II.B), and the spaces between grains.
namespace arenite::raster {

struct RasterParameters {
  std::int64_t nodes = 1024;         ///< a side of the square crop
  double crop = 0;                   ///< side of the centred square, m; 0: the largest that lies in the sample
  bool operator==(const RasterParameters&) const = default;
};

struct RasterReport {
  double x_min = 0, y_min = 0;       ///< lower left corner of the crop in the packing's coordinates, m
  double side = 0;                   ///< m
  double particle_area = 0, matrix_area = 0;              ///< counted, m^2
  double particle_area_error = 0, matrix_area_error = 0;  ///< counted over exact, less one; 0 where there is none
  int thinnest_bridge = 0;           ///< fewest nodes across a bridge or meniscus that lies in the crop; 0: one is lost
  std::size_t bridges = 0, lost_bridges = 0;              ///< in the crop; those without a node of matrix though they have area
  std::int32_t smallest_grain = 0;   ///< nodes across the smallest whole grain
};

/// The nodes of the crop by phase and by grain. `grain_class` of the map is that of each grain that has a node, from
/// `class_of_grain` (one a grain of the packing; empty: none).
PhaseMap rasterise(const Packing& packing, const Cement& cement, const RasterParameters& parameters,
                   const std::vector<GrainClass>& class_of_grain, RasterReport& report);

}  // namespace arenite::raster
