#pragma once
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

#include "core/parameters.hpp"
#include "core/vec.hpp"
#include "model/packing.hpp"

namespace arenite::fields {

/// Choices that the definitions leave open.
struct ChainOptions {
  double stress_factor = 1;
  double angle = std::numbers::pi / 4;
  std::size_t least = 3;
};
void declare(ParameterVisitor& visitor, ChainOptions& options);

/// Principal compression of a grain, from its contact forces.
struct GrainCompression {
  double major =
      0;  ///< greatest compressive principal stress, Pa (N/m without a thickness); below zero where all directions pull
  Vec2 direction;       ///< unit vector along it, either sense; {0, 0} where both principal stresses are equal
  bool loaded = false;  ///< has a contact with a force
};

/// Of every grain: moment of its contact forces, made symmetric, over its volume (T eq. 1.11).
std::vector<GrainCompression> grain_compressions(const Packing& packing);

/// Quasi-linear sequences of highly loaded grains.
struct ForceChains {
  std::vector<std::vector<std::int32_t>>
      chains;                          ///< grains in their order; by their smallest end, or smallest grain of a ring
  std::vector<std::uint8_t> ring;      ///< 1 where a chain closes, as straight ones do around a periodic cell
  std::vector<std::size_t> histogram;  ///< number of chains by number of grains (index)
  double mean_stress = 0;              ///< mean major principal stress over loaded grains, Pa (N/m without a thickness)
  double mean_length = 0;              ///< grains a chain; NaN without chains
  double grain_share = 0;              ///< share of loaded grains that are in a chain; NaN without loaded grains
  std::size_t highly_loaded = 0;       ///< grains
};

/// Force chains after J. F. Peters, M. Muthuswamy, J. Wibowo and A. Tordesillas, Phys. Rev. E 72, 041307 (2005): grains
/// whose major principal stress is above the mean, each joined to the next by a pushing contact whose branch lies
/// within `angle` of the direction of greatest compression of both. Where several would continue a chain, the
/// straightest does (greatest sum of the two cosines, chosen over the whole sample from the best on), so that a grain
/// has at most one neighbour to either side and the result depends on no order. Walls end chains. Throws InputError for
/// an angle that is not between 0 and 90 degrees.
ForceChains find_force_chains(const Packing& packing, const ChainOptions& options = {});

/// Clusters of contacts between grains that push more than `factor` times the mean of those that push.
struct StrongClusters {
  double threshold = 0;      ///< N; NaN where no contact pushes
  std::size_t contacts = 0;  ///< strong ones
  double share = 0;          ///< of pushing contacts that are strong; NaN where none pushes
  std::vector<std::size_t> grains,
      contacts_of;               ///< grains and strong contacts of each cluster, the largest (by grains) first
  std::vector<std::int32_t> of;  ///< cluster of every grain; -1: no strong contact
};

/// Grains joined by strong contacts (F. Radjai, D. E. Wolf, M. Jean and J.-J. Moreau, Phys. Rev. Lett. 80, 61, 1998).
StrongClusters strong_clusters(const Packing& packing, double factor = 1);

}  // namespace arenite::fields
