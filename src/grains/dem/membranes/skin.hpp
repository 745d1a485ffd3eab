#pragma once
#include <optional>
#include <vector>

#include "core/parameters.hpp"
#include "core/vec.hpp"

namespace arenite::dem {

/// Whether the ends of a membrane glide along the platens, or go with them in every way.
enum class SkinEnds { sliding, held };

/// What the membranes of a sample are made of.
struct SkinParameters {
  double stiffness = 500;           ///< tension by its strain and by the thickness of the sample, N/m: latex of 0.3 mm
  std::optional<double> spacing;    ///< of the nodes, m; unset: half the diameter of the smallest grain
  std::optional<double> node_mass;  ///< kg; unset: that of the lightest grain
  double damping = 0.5;             ///< of neighbouring nodes, as a share of what damps the fastest mode critically
  SkinEnds ends = SkinEnds::sliding;
  double largest_strain = 1;  ///< beyond which it would tear
  bool operator==(const SkinParameters&) const = default;
  void declare(ParameterVisitor& visitor);
};

/// A chain of nodes that is pulled where it is stretched and pressed from one side.
struct Skin {
  double stiffness = 0;  ///< tension by strain, N
  double rest = 0;       ///< length of a segment without tension, m
  double pressure = 0;   ///< by length, N/m: what acts outside times the thickness of the sample
  double towards = 1;    ///< +1 where the pressure pushes to the left of the way along the chain, -1 to the right
  double dashpot = 0;    ///< between neighbouring nodes, N s/m
};

/// Pull of a segment on its nodes, N: by its strain where it is stretched; nothing where it is slack; where it is
/// folded to less than half of its length it pushes as stiffly, so that no node passes another. The energy of that, J.
double pull_of(const Skin& skin, double length);
double energy_of(const Skin& skin, double length);

/// Forces on the nodes of a chain, N, each kind for itself.
struct SkinForces {
  std::vector<Vec2> pressed;  ///< pressure times the length of each segment along its normal, half to each of its nodes
  std::vector<Vec2> pulled, braked;
};
void find_forces(const Skin& skin, const std::vector<Vec2>& points, const std::vector<Vec2>& velocity,
                 SkinForces& forces);

/// Strain of the longest segment; of the whole chain.
double largest_strain(const Skin& skin, const std::vector<Vec2>& points);
double mean_strain(const Skin& skin, const std::vector<Vec2>& points);

/// Energy of all segments, J.
double energy_of(const Skin& skin, const std::vector<Vec2>& points);

/// Where a straight wall across this axis (0: x) would enclose the same area as a chain that runs along the other, m.
double mean_place(const std::vector<Vec2>& points, int axis);

}  // namespace arenite::dem
