#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/parameters.hpp"
#include "geometry/label_cells.hpp"
#include "solid/cement/cement.hpp"

namespace arenite::recipe {

/// A phase map that loads act on in the place of a cemented packing: a picture, or a field of ours, which says all the
/// rest by itself.
struct MapSection {
  std::string file;
  std::string phases;                 ///< "0=void,85=particle,170=matrix"; empty: guessed of a picture of two values
  std::string labels = "components";  ///< a way to find grains, "none", or a picture whose values number them
  double smoothing = geometry::LabelOptions{}.smoothing;
  std::string crop;            ///< "X,Y,WIDTH,HEIGHT", pixels from the upper left
  std::int64_t dimension = 2;  ///< 3: all slices, a sample in space
  std::optional<std::int64_t> slice, label_slice;
  std::string dataset, label_dataset;
  std::optional<double> dx;         ///< side of a pixel, m; if not given, lengths are in nodes
  bool periodic = false;            ///< the map repeats itself along all axes: grains go on across its sides
  std::int64_t voxels = 128;        ///< of a table of spheres: along the longest side of its box
  std::vector<double> box;          ///< of its own, lowest and highest corner, m; empty: the smallest that holds all
  cement::CementParameters cement;  ///< and the matrix between them
  geometry::LabelOptions label_options() const;
  bool has_label_file() const { return labels != "components" && labels != "watershed" && labels != "none"; }
  bool operator==(const MapSection&) const = default;
};

void declare(ParameterVisitor& visitor, MapSection& map);

}  // namespace arenite::recipe
