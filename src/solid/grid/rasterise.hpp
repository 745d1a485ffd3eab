#pragma once
#include <cstdint>
#include <vector>

#include "geometry/rectangle.hpp"
#include "model/cement.hpp"
#include "model/packing.hpp"
#include "model/phase_map.hpp"

/// From geometry to nodes (P II.B), and the spaces between grains.
namespace arenite::grid {

struct GridParameters {
  std::int64_t nodes = 1024;  ///< a side of the square crop
  double crop = 0;            ///< side of the centred square, m; 0: the largest that lies in the sample
  bool operator==(const GridParameters&) const = default;
};

struct GridReport {
  geometry::Rectangle window;                             ///< the crop in the packing's coordinates, m
  double dx = 0;                                          ///< distance between nodes, m
  double exact_matrix_area = 0;                           ///< by geometry, m^2
  double particle_area_error = 0, matrix_area_error = 0;  ///< counted over exact, less one; 0 where there is none
  /// Bridges and menisci the middle of whose gap lies in the crop. `thinnest` is the fewest nodes that one of them has
  /// on a line of the lattice across its gap, its grains' included (0: a gap without a node); lost are those without a
  /// node of matrix though grains leave some of their area bare: `lost_area`, m^2.
  std::size_t necks = 0, lost_necks = 0;
  int thinnest_neck = 0;  ///< 0 also where there are none
  double lost_area = 0;
  int smallest_grain = 0;  ///< nodes across the smallest grain that lies in the crop as a whole; 0: none does
  std::vector<std::int32_t> grain_of_label;  ///< index in the packing, one a label of the map
};

/// The centred square that is cropped, in the packing's coordinates; throws InputError if it does not fit into the
/// sample.
geometry::Rectangle crop_window(const Packing& packing, double crop);

/// The nodes of the crop, at the middles of its cells, by phase and by grain. Where grains overlap a node goes to the
/// one with the smaller power distance (distance^2 - radius^2), of equals to the first. Labels number the grains that
/// have a node in the packing's order; their class is from `class_of_grain` (one a grain of the packing; empty: none).
/// Periodic images carry their grain's label. A mirrored sample gives the mirrored map.
PhaseMap rasterise(const Packing& packing, const Cement& cement, const GridParameters& parameters,
                   const std::vector<GrainClass>& class_of_grain, GridReport& report);

}  // namespace arenite::grid
