#pragma once
#include <vector>

#include "model/packing.hpp"

namespace arenite::packing {

/// While it lives, the grains are the circles around them, so that they may be put anywhere at any angle.
class Circles {
 public:
  explicit Circles(Grains& grains);
  ~Circles();
  Circles(const Circles&) = delete;
  Circles& operator=(const Circles&) = delete;

  /// Radii of the disks that have the grains' areas, m.
  const std::vector<double>& own_radii() const { return own_; }

 private:
  Grains& grains_;
  std::vector<double> own_;
};

/// Shares of an area that grains and the circles around them cover. Circles that touch at random jam as disks do, at
/// 0.82 to 0.84: at `most` they still find room.
struct Room {
  static constexpr double most = 0.8;
  double circles = 0, grains = 0;

  bool suffices() const { return circles <= most; }
  double times_larger() const { return circles / most; }             ///< that the area would have to be
  double solid_fraction() const { return grains * most / circles; }  ///< of the grains in that area
};
Room room_in(double area, const std::vector<double>& circle_radii, const std::vector<double>& own_radii);

}  // namespace arenite::packing
