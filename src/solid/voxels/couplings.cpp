#include "solid/voxels/couplings.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "solid/voxels/kernels/kernels.hpp"

namespace arenite::voxels {
namespace {

using Coupling = statics::CouplingIn<3>;
using Pairs = std::vector<std::pair<std::int32_t, std::int32_t>>;

/// The corners of a voxel by the aggregates that they are of.
struct Owners {
  std::array<std::int32_t, 8> list;
  std::array<std::uint8_t, 8> of_corner;  ///< place in the list; 8: none
  unsigned count = 0;
};

/// The aggregates of voxels, by their lowest corners.
class Corners {
 public:
  Corners(const Voxels& voxels, const Aggregates& aggregates)
      : voxels_(voxels),
        aggregates_(aggregates),
        steps_(voxels.corners()) {}

  Owners of(int x, int y, int z) const {
    const std::ptrdiff_t i = voxels_.grid.index(x, y, z);
    const bool wraps =
        voxels_.grid.periodic && (x + 1 == voxels_.width || y + 1 == voxels_.height || z + 1 == voxels_.depth);
    Owners owners;
    for (unsigned c = 0; c < 8; ++c) {
      const int right = static_cast<int>(c & 1), back = static_cast<int>(c >> 1 & 1), up = static_cast<int>(c >> 2);
      const std::ptrdiff_t node = wraps ? voxels_.node(x + right, y + back, z + up) : i + steps_[c];
      const std::int32_t p = aggregates_.of_node[node];
      unsigned at = 0;
      while (at < owners.count && owners.list[at] != p) ++at;
      if (p >= 0 && at == owners.count) owners.list[owners.count++] = p;
      owners.of_corner[c] = static_cast<std::uint8_t>(p < 0 ? 8 : at);
    }
    return owners;
  }

 private:
  const Voxels& voxels_;
  const Aggregates& aggregates_;
  std::array<std::ptrdiff_t, 8> steps_;
};

/// visit(x, y, z, kind) for every voxel of some layers.
template <class Visit> void each_voxel(const Voxels& voxels, int from, int to, const Visit& visit) {
  for (int z = from; z < to; ++z)
    for (int y = 0; y < voxels.height; ++y)
      for (int x = 0; x < voxels.width; ++x)
        if (const Kind kind = voxels.kind(voxels.grid.index(x, y, z)); kind != none) visit(x, y, z, kind);
}

Pairs coupled_pairs(const Voxels& voxels, const Aggregates& aggregates) {
  const Corners corners(voxels, aggregates);
  const auto count = static_cast<std::size_t>(aggregates.count());
  Pairs pairs;
  for (std::int32_t p = 0; p < aggregates.count(); ++p) pairs.push_back({p, p});
  std::vector<std::vector<std::int32_t>> others(count);
  each_voxel(voxels, 0, voxels.depth, [&](int x, int y, int z, Kind) {
    const Owners owners = corners.of(x, y, z);
    for (unsigned a = 0; a < owners.count; ++a)
      for (unsigned b = a + 1; b < owners.count; ++b) {
        const auto [low, high] = std::minmax(owners.list[a], owners.list[b]);
        auto& known = others[static_cast<std::size_t>(low)];
        if (std::find(known.rbegin(), known.rend(), high) == known.rend()) known.push_back(high);
      }
  });
  for (std::size_t p = 0; p < count; ++p)
    for (const std::int32_t q : others[p]) pairs.push_back({static_cast<std::int32_t>(p), q});
  return pairs;
}

}  // namespace

statics::GalerkinSums<3> couplings(const Voxels& voxels, const Aggregates& aggregates, const BlockDiagonal&,
                                   const std::vector<std::uint8_t>& prescribed) {
  statics::GalerkinSums<3> sums;
  sums.pairs = coupled_pairs(voxels, aggregates);
  sums.each = [&voxels, prescribed](const Aggregates& cut, const statics::GalerkinSums<3>::Take& take) {
    const Corners corners(voxels, cut);
    const statics::HatTable hats(cut.side);
    const CouplingKernel& kernel = coupling_kernel();
    for (int z0 = 0; z0 < voxels.depth; z0 += cut.side) {
      statics::CouplingSumIn<3> sum(cut.list.size(), false);
      each_voxel(voxels, z0, std::min(z0 + cut.side, voxels.depth), [&](int x, int y, int z, Kind kind) {
        const Owners owners = corners.of(x, y, z);
        std::array<Part, 8> parts;
        for (unsigned c = 0; c < 8; ++c)
          if (const unsigned at = owners.of_corner[c]; at < 8) {
            const int up = z + static_cast<int>(c >> 2), right = x + static_cast<int>(c & 1),
                      back = y + static_cast<int>(c >> 1 & 1);
            const int wide = voxels.grid.width, high = voxels.grid.height, deep = voxels.grid.depth;
            const bool slides = prescribed[static_cast<std::size_t>(up % deep)] == statics::z_prescribed;
            parts[at].add(hats.at(right % wide, back % high, up % deep), c, slides);
          }
        for (unsigned a = 0; a < owners.count; ++a)
          for (unsigned b = a; b < owners.count; ++b) {
            const bool swap = owners.list[b] < owners.list[a];
            const unsigned low = swap ? b : a, high = swap ? a : b;
            kernel.couple(voxels.modes[kind], parts[low], parts[high],
                          sum.between(owners.list[low], owners.list[high]));
          }
      });
      for (const Coupling& c : sum.crosses()) take(c);
    }
  };
  return sums;
}

}  // namespace arenite::voxels
