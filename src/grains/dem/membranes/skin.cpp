#include "grains/dem/membranes/skin.hpp"

#include <algorithm>
#include <cmath>

namespace arenite::dem {
namespace {

constexpr double folded = -0.5;  // strain below which a segment pushes

/// The strain that counts: 0 where the segment is slack.
double acting_strain(const Skin& skin, double length) {
  const double strain = length / skin.rest - 1;
  return strain > 0 ? strain : std::min(strain - folded, 0.0);
}

}  // namespace

void SkinParameters::declare(ParameterVisitor& v) {
  v.number({"stiffness",
            "Tension of the skin by its strain and by the thickness of the sample: its Young's modulus times its own "
            "thickness. Latex of 0.3 mm has about 0.5 N/mm."},
           stiffness, "N/mm", range::positive);
  v.number({"spacing", "Distance of the nodes as it is put on. Unless given, half the diameter of the smallest grain."},
           spacing, "mm", range::positive);
  v.number({"node_mass",
            "Mass of a node. Unless given, that of the lightest grain, which leaves the time step as it "
            "is."},
           node_mass, "kg", range::positive);
  v.number({"damping",
            "Dashpots between neighbouring nodes, as a fraction of what damps the fastest mode of the skin "
            "critically."},
           damping, "", range::not_negative);
  v.choice({"ends", "What the platens do to the ends of the skin."}, ends,
           {{"sliding", "the ends stay on the platens and glide along them, as on lubricated ones"},
            {"held", "the ends go with the platens, as rings hold them"}});
  v.number({"largest_strain", "Strain beyond which the skin would tear; the outcome of a stage says so."},
           largest_strain, "", range::positive);
}

double pull_of(const Skin& skin, double length) { return skin.stiffness * acting_strain(skin, length); }

double energy_of(const Skin& skin, double length) {
  const double strain = acting_strain(skin, length);
  return 0.5 * skin.stiffness * skin.rest * strain * strain;
}

void find_forces(const Skin& skin, const std::vector<Vec2>& points, const std::vector<Vec2>& velocity,
                 SkinForces& forces) {
  for (auto* of : {&forces.pressed, &forces.pulled, &forces.braked}) of->assign(points.size(), Vec2{});
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    const Vec2 way = points[k + 1] - points[k];
    const double length = norm(way);
    const Vec2 press = (0.5 * skin.pressure * skin.towards) * perpendicular(way);
    const Vec2 pull = (length > 0 ? pull_of(skin, length) / length : 0.0) * way;
    const Vec2 brake = skin.dashpot * (velocity[k + 1] - velocity[k]);
    for (const std::size_t node : {k, k + 1}) forces.pressed[node] += press;
    forces.pulled[k] += pull, forces.pulled[k + 1] -= pull;
    forces.braked[k] += brake, forces.braked[k + 1] -= brake;
  }
}

double largest_strain(const Skin& skin, const std::vector<Vec2>& points) {
  double longest = 0;
  for (std::size_t k = 0; k + 1 < points.size(); ++k) longest = std::max(longest, norm(points[k + 1] - points[k]));
  return longest / skin.rest - 1;
}

double mean_strain(const Skin& skin, const std::vector<Vec2>& points) {
  double length = 0;
  for (std::size_t k = 0; k + 1 < points.size(); ++k) length += norm(points[k + 1] - points[k]);
  return length / (skin.rest * static_cast<double>(points.size() - 1)) - 1;
}

double energy_of(const Skin& skin, const std::vector<Vec2>& points) {
  double energy = 0;
  for (std::size_t k = 0; k + 1 < points.size(); ++k) energy += energy_of(skin, norm(points[k + 1] - points[k]));
  return energy;
}

double mean_place(const std::vector<Vec2>& points, int axis) {
  double area = 0;
  for (std::size_t k = 0; k + 1 < points.size(); ++k)
    area += 0.5 * (points[k][axis] + points[k + 1][axis]) * (points[k + 1][1 - axis] - points[k][1 - axis]);
  return area / (points.back()[1 - axis] - points.front()[1 - axis]);
}

}  // namespace arenite::dem
