#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "core/lanes.hpp"
#include "core/pages.hpp"
#include "solid/statics/aggregates.hpp"

namespace arenite::statics {

template <int D> inline constexpr int corners = 1 << D;  ///< of a cell

/// The multilinear hats of a cell at one of its nodes; corners in the order (0,0), (1,0), (0,1), (1,1), the next layer
/// after them.
template <int D> using HatsIn = Vector<double, corners<D>>;
using Hats = HatsIn<2>;

/// Stiffness between the corners of aggregate p and those of aggregate q: [component][corner of p](corner of q), Pa in
/// the plane and N/m in space. Components row by row: xx, xy (x of p, y of q), yx, ..
template <int D> struct CouplingIn {
  std::int32_t p, q;
  std::array<std::array<HatsIn<D>, corners<D>>, D * D> block;
};
using Coupling = CouplingIn<2>;

/// Couplings by the pair that they join.
template <int D> class CouplingSumIn {
 public:
  /// `with_selves`: those of every aggregate with itself are kept apart; otherwise they are pairs like others.
  explicit CouplingSumIn(std::size_t aggregates, bool with_selves = true);
  CouplingIn<D>& self(std::int32_t p) { return self_[static_cast<std::size_t>(p)]; }
  std::vector<CouplingIn<D>>& selves() { return self_; }
  Buffer<CouplingIn<D>>& crosses() { return cross_; }
  /// Of p with q, in this order; added where there is none.
  CouplingIn<D>& between(std::int32_t p, std::int32_t q);
  /// Empty as at first, with its memory.
  void clear();
  /// All: of every aggregate with itself first, in order of aggregates.
  std::vector<CouplingIn<D>> taken();

 private:
  std::vector<CouplingIn<D>> self_;
  Buffer<CouplingIn<D>> cross_;
  std::vector<std::int32_t> other_;          ///< q of each of cross_
  std::vector<std::int32_t> latest_, next_;  ///< of each aggregate's couplings, the newest; they form a chain
};
using CouplingSum = CouplingSumIn<2>;
extern template class CouplingSumIn<2>;
extern template class CouplingSumIn<3>;

/// The Galerkin sums of a sample: which pairs of aggregates are coupled, of each with itself among them, and their
/// couplings as they are worked out. A pair may come several times; what came adds up. In space all of them at once
/// would outweigh the sample.
template <int D> struct GalerkinSums {
  using Take = std::function<void(const CouplingIn<D>&)>;
  std::vector<std::pair<std::int32_t, std::int32_t>> pairs;
  std::function<void(const Aggregates&, const Take&)> each;

  GalerkinSums() = default;
  /// Of couplings that are there.
  GalerkinSums(std::vector<CouplingIn<D>> couplings) {
    for (const auto& c : couplings) pairs.push_back({c.p, c.q});
    auto all = std::make_shared<const std::vector<CouplingIn<D>>>(std::move(couplings));
    each = [all = std::move(all)](const Aggregates&, const Take& take) {
      for (const auto& c : *all) take(c);
    };
  }
};

/// Hats at the nodes of square or cubic cells.
template <int D> class HatTableIn {
 public:
  explicit HatTableIn(int side);
  /// Of a node, by its place in the sample.
  const HatsIn<D>& at(int x, int y, int z) const {
    return hats_[static_cast<std::size_t>((z % side_ * side_ + y % side_) * side_ + x % side_)];
  }

 private:
  int side_;
  std::vector<HatsIn<D>> hats_;
};
extern template class HatTableIn<2>;
extern template class HatTableIn<3>;

/// Hats at a node of the plane, whose place counts from the corner of any cell of the usual side.
const Hats& hats_at(int x, int y);

}  // namespace arenite::statics
