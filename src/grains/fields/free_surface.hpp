#pragma once
#include <cstddef>
#include <vector>

#include "core/vec.hpp"
#include "model/packing.hpp"
#include "statistics/estimate.hpp"

namespace arenite::fields {

/// One side of a heap or layer: its surface from the highest place down to the lowest on that side.
struct Flank {
  statistics::Estimate angle;  ///< rad below the horizontal; unknown where the flank is too short to tell
  std::size_t columns = 0;     ///< of the profile that the line is laid through
};

/// The surface of what hangs together, seen with gravity pointing down. Lengths along the horizontal and the vertical
/// are counted from the container's origin. In space heights are means over the depth.
struct FreeSurface {
  std::vector<double> place, height;  ///< m; the highest rim above each of the columns, which are a mean diameter apart
  std::size_t grains = 0;             ///< that hang together
  double left = 0, right = 0;         ///< ends of the grains that hang together, m
  double bottom = 0, top = 0;         ///< m
  double diameter = 0;                ///< mean diameter, m
  bool fills_depth = true;            ///< in space: from back to front, so that the profile is that of the surface
  Flank left_flank, right_flank;      ///< that fall to the left and to the right
  statistics::Estimate angle;         ///< of both flanks by their columns, rad; unknown where there is none
};

/// The largest set of grains that hang together, its upper rim column by column, and the slope of its flanks by a
/// straight line through the middle of their height, with the error by leaving out one of eight blocks of neighbouring
/// columns at a time. Periodic sides do not count as neighbours. `gap`: mean diameters between surfaces up to which two
/// grains hang together; single grains that roll ahead do not. In space gravity lies in the plane x-y, and a heap that
/// does not reach from back to front has no angle, which its profile would understate. Throws InputError where gravity
/// has no direction, there are no grains, and for a gap below 0.
template <int D> FreeSurface find_free_surface(const PackingIn<D>& packing, Vec2 gravity, double gap = 0.1);

/// A side of what hangs together, and how far its end has gone outwards.
struct Front {
  bool to_right = true;
  double way = 0;  ///< m
};
/// The front that has gone farther from one moment to another.
Front farther_front(const FreeSurface& then, const FreeSurface& now);
/// How far a front has gone, m, whichever goes farther.
double way_of_front(bool to_right, const FreeSurface& then, const FreeSurface& now);

/// Whether a closed boundary turns, in space one about z: grains in a drum, which run out nowhere.
bool in_drum(const Domain& domain);
bool in_drum(const DomainIn<3>& domain);

}  // namespace arenite::fields
