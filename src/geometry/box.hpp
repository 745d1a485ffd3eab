#pragma once

namespace arenite::geometry {

/// A box that holds disks: a rectangle from (x0, y0), m; a direction may be periodic.
struct Box {
  double x0 = 0, y0 = 0, width = 0, height = 0;
  bool periodic_x = false, periodic_y = false;
};

}  // namespace arenite::geometry
