#pragma once
#include <cstddef>
#include <optional>

#include "geometry/rectangle.hpp"
#include "model/cement.hpp"
#include "model/packing.hpp"

/// Matrix between grains (P II.B).
namespace arenite::cement {

using Window = geometry::Rectangle;

struct CementParameters {
  enum class Kind { none, bridges, full, coating, menisci };
  Kind kind = Kind::bridges;
  /// ell: widest surface gap that is bridged, m (bridges, menisci); unless given 0, in recipes 0.075 mean large radii
  /// (P's 3 dx).
  std::optional<double> gap = {};
  double width = 0.4;        ///< eta: half base of a bridge over the radius of its grain (bridges)
  bool full_width = false;   ///< eta is the whole base over the radius
  double thickness = 0;      ///< of the layer, m (coating)
  double volume = 0;         ///< of one meniscus, m^2 per unit length (menisci in the plane)
  double contact_angle = 0;  ///< at which menisci in space meet their spheres, rad
  /// S_m, the share of the space between grains that is matrix: width, thickness or volume is found so that it is met.
  std::optional<double> saturation = {};
  bool operator==(const CementParameters&) const = default;
};

/// Areas inside a window by geometry, without a grid, m^2: grains and matrix, each overlap once.
struct Areas {
  double window = 0, particle = 0, matrix = 0;
  /// S_m: matrix over what is not grain; 0 where all is grain.
  double saturation() const { return window > particle ? matrix / (window - particle) : 0; }
};

struct CementReport {
  Areas areas;                  ///< exact, in the window
  double saturation = 0;        ///< S_m of these
  double saturation_error = 0;  ///< S_m minus the prescribed value; 0 where none was
  double parameter = 0;         ///< width, thickness (m) or volume (m^2) used; 0 for none and full
  std::size_t necks = 0;        ///< bridges or menisci made, in the whole packing
  std::size_t ruptured = 0;     ///< menisci too small to span their gap, so not there
  std::size_t capped = 0;       ///< menisci that hold less than asked: their arcs are straight and can hold no more
};

/// The matrix of a packing; walls hold none, periodic sides do. With a saturation asked for, the free parameter of the
/// kind is found on the exact area inside `window`. Throws InputError for senseless parameters, and where no parameter
/// reaches the saturation, naming the range that can be reached.
Cement make_cement(const Packing& packing, const CementParameters& parameters, const Window& window,
                   CementReport& report);

/// Exact areas of the grains and the matrix that are placed in a window.
Areas exact_areas(const PlacedCement& placed, const Window& window);

}  // namespace arenite::cement
