#pragma once
#include <optional>

#include "model/cement.hpp"
#include "model/packing.hpp"

/// Matrix between grains (P II.B).
namespace arenite::cement {

struct CementParameters {
  enum class Kind { none, bridges, full, coating, menisci };
  Kind kind = Kind::bridges;
  double gap = 0;                    ///< ell: widest surface gap that is bridged, m (bridges, menisci)
  double width = 0.4;                ///< eta: half base of a bridge over the radius of its grain (bridges)
  bool full_width = false;           ///< eta is the whole base over the radius
  double thickness = 0;              ///< of the layer, m (coating)
  double volume = 0;                 ///< of one meniscus, m^2 per unit length (menisci)
  /// S_m, the share of the space between grains that is matrix: width, thickness or volume is found so that it is met.
  std::optional<double> saturation;
  bool operator==(const CementParameters&) const = default;
};

/// The matrix of a packing. With a saturation asked for, the free parameter of the kind is found on the exact area inside
/// `window` (see exact_areas); throws InputError where no value reaches it, naming what can be reached.
struct Window { double x_min = 0, x_max = 0, y_min = 0, y_max = 0; };
Cement make_cement(const Packing& packing, const CementParameters& parameters, const Window& window);

/// Areas inside a window by geometry, without a raster, m^2: grains (overlaps once) and matrix.
struct Areas { double window = 0, particle = 0, matrix = 0; };
Areas exact_areas(const Packing& packing, const Cement& cement, const Window& window);

}  // namespace arenite::cement
