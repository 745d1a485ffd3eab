#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "grains/packing/grain_shapes.hpp"
#include "grains/packing/size_laws/size_laws.hpp"
#include "model/packing.hpp"

namespace arenite::packing {

/// Grains of one material, shape and size law; a count, or a share by number of a total.
struct Population {
  std::string material;
  std::optional<std::int64_t> count;
  std::optional<double> ratio;  ///< relative to the other populations' ratios
  SizeLaw size;                 ///< diameters; of grains that are no disks those of the disks of their area
  GrainShape shape;
  bool operator==(const Population&) const = default;
};

/// Grains of all populations, in random order, at rest at the origin: radius, material, id and shape are set, and a
/// random angle where not all are disks. Populations with a ratio share `total` less the counts, by largest remainder.
/// Same seed: same grains. Throws InputError for an unknown material or a total that leaves no grain.
Grains draw_grains(const std::vector<Population>& populations, const Materials& materials, std::int64_t total,
                   std::uint64_t seed);

/// The same of spheres.
GrainsIn<3> draw_spheres(const std::vector<Population>& populations, const Materials& materials, std::int64_t total,
                         std::uint64_t seed);

/// Radius of the smallest circle about each grain's centre that holds it, m.
std::vector<double> circle_radii(const Grains& grains);

/// A glued region: grains whose centre lies inside are in zone 1.
struct Region {
  enum class Shape { circle, rectangle };
  Shape shape = Shape::circle;
  Vec2 centre;                        ///< m from the container's lower left corner
  double radius = 0;                  ///< circle
  double width = 0, height = 0;       ///< rectangle
  std::optional<std::int64_t> count;  ///< the grains nearest to the centre, that many, instead of a shape
  bool operator==(const Region&) const = default;
  void declare(ParameterVisitor& visitor);
};

/// Puts the grains of the region into zone 1, all others into zone 0; returns how many are in it.
std::int64_t mark_region(Grains& grains, const Domain& domain, const Region& region);

/// A grading curve: share of the mass in grains no wider than each diameter; between two points it keeps the value of
/// the first.
struct SizeCurve {
  std::vector<double> diameter;  ///< m, rising
  std::vector<double> passing;   ///< 0 to 1
};

/// Of grains as cylinders of one length, with the densities of their materials; at most `most` points, evenly spaced in
/// mass.
SizeCurve measured_size_curve(const Grains& grains, const Materials& materials, std::size_t most = 200);

/// That of the populations' laws themselves: of very many grains drawn from them in the shares that `total` grains
/// have.
SizeCurve asked_size_curve(const std::vector<Population>& populations, const Materials& materials, std::int64_t total,
                           std::size_t most = 200);

}  // namespace arenite::packing
