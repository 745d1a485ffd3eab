#pragma once
#include <cmath>
#include <vector>

#include "core/parameters.hpp"
#include "core/vec.hpp"

namespace arenite::elasticity {

/// How a contact's force is spread over its arc of the rim: all of it in one point, evenly, or as the half ellipse of
/// Hertz. The traction has the direction of the force everywhere.
enum class Traction { point, uniform, elliptic };

/// One force on the rim of a disk. `normal` points from the contact point to the disk's centre, so the contact point is
/// -radius normal from it; the force on the disk is fn normal + ft t, with t the normal turned by +90 degrees. For
/// grain i of a contact (model/packing.hpp) that is its n, fn and ft; for grain j it is -n with the same fn and ft.
struct RimForce {
  Vec2 normal{0, 1};
  double fn = 0, ft = 0;  ///< N
  double half_angle = 0;  ///< half of the arc that carries the force, rad; not used by point forces
};

/// An elastic disk in plane stress under forces on its rim: Flamant's field of every force, the isotropic tension that
/// frees the rim between them (Michell), and a body force (weight, inertia) that balances what the forces leave. That
/// body force adds nothing to sigma_kk, so sigma_kk is harmonic. Positions count from the disk's centre, m.
struct Disk {
  double radius = 0;  ///< m
  double length = 1;  ///< out of plane, m
  std::vector<RimForce> forces;
  Traction traction = Traction::point;
};

/// sigma_xx + sigma_yy at a point inside the disk or on its rim, Pa; tension positive: at the centre the mean over
/// every concentric disk. Grows as 1/distance towards a point force; a spread force is exact to 1e-4 of itself from a
/// tenth of the arc's half length on.
double sigma_kk(const Disk& disk, Vec2 x);

/// Mean of sigma_kk over a square that lies in the disk, by closed form, as a pixel sees it, Pa.
double square_mean(const Disk& disk, Vec2 centre, double side);

/// r_eff of two disks in the geometrical adhesion gamma sqrt(r_eff h) (T eq. 1.22). Equal cylinders, as the thesis
/// pulled apart, do not tell the three forms apart.
enum class EffectiveRadius { four_reduced, sum, geometric_mean };

std::vector<Word> words(EffectiveRadius);

/// As its words say, m; each is 2 r for equal radii r.
inline double effective_radius(EffectiveRadius kind, double radius_i, double radius_j) {
  switch (kind) {
    case EffectiveRadius::sum: return radius_i + radius_j;
    case EffectiveRadius::geometric_mean: return 2 * std::sqrt(radius_i * radius_j);
    case EffectiveRadius::four_reduced: break;
  }
  return 4 * radius_i * radius_j / (radius_i + radius_j);
}

}  // namespace arenite::elasticity
