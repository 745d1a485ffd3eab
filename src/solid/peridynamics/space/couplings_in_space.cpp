#include "solid/peridynamics/space/couplings_in_space.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

namespace arenite::peridynamics {
namespace {

using statics::HatsIn;

/// The pairs of components that a symmetric block has, and where they stand in a coupling.
constexpr std::array<std::array<int, 2>, 6> space_components{{{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}}};
constexpr std::size_t place_in_coupling(int a, int b) { return static_cast<std::size_t>(3 * a + b); }

/// What one node's bonds to one aggregate sum to: block times hats of the other ends.
struct SpaceReach {
  std::int32_t q;
  std::array<HatsIn<3>, 6> sum;
};

class SpaceBondSums {
 public:
  SpaceBondSums(const SpaceBonds& bonds, const statics::Aggregates& cut,
                const statics::BlockDiagonalIn<3, double>& diagonal, const std::vector<std::uint8_t>& prescribed)
      : bonds_(bonds),
        cut_(cut),
        diagonal_(diagonal),
        prescribed_(prescribed),
        hats_(cut.side) {}

  /// All of a layer of cells.
  void add_layers(int first, int last, statics::CouplingSumIn<3>& sum) {
    each_node(first, last, [&](std::ptrdiff_t i, std::array<int, 3> at) {
      if (!slides(at[2])) add_node(i, at, sum);
    });
    for (statics::CouplingIn<3>& c : sum.crosses())
      for (const auto& [a, b] : space_components) c.block[place_in_coupling(b, a)] = c.block[place_in_coupling(a, b)];
    each_node(first, last, [&](std::ptrdiff_t i, std::array<int, 3> at) {
      if (slides(at[2])) add_sliding_node(i, at, sum);
    });
  }

 private:
  template <class Visit> void each_node(int first, int last, const Visit& visit) const {
    const auto& grid = bonds_.grid;
    for (int z = first; z < last; ++z)
      for (int y = 0; y < grid.height; ++y)
        for (int x = 0; x < grid.width; ++x)
          if (const std::ptrdiff_t i = grid.index(x, y, z); cut_.of_node[i] >= 0) visit(i, std::array<int, 3>{x, y, z});
  }
  bool slides(int level) const { return prescribed_[static_cast<std::size_t>(level)] == statics::normal_component<3>; }
  const HatsIn<3>& hats(std::array<int, 3> at) const { return hats_.at(at[0], at[1], at[2]); }
  std::array<int, 3> end(std::array<int, 3> at, std::size_t d) const {
    const SpaceOffset e = bonds_.half[d];
    return {at[0] + e.x, at[1] + e.y, at[2] + e.z};
  }

  /// to := to - p q^T, p the hats of the first aggregate's node.
  static void take_product(std::array<HatsIn<3>, 8>& to, const HatsIn<3>& p, const HatsIn<3>& q) {
    for (std::size_t c = 0; c < 8; ++c) to[c] -= p[c] * q;
  }

  void add_node(std::ptrdiff_t i, std::array<int, 3> at, statics::CouplingSumIn<3>& sum) {
    const std::int32_t p = cut_.of_node[i];
    reach_.clear();
    reach_.push_back({p, {}});
    std::size_t known = 0;
    for (std::size_t d = 0; d < bonds_.count(); ++d) {
      const unsigned type = bonds_.type(i, d);
      const std::int32_t q = type ? cut_.of_node[i + bonds_.step(d)] : -1;
      if (q < 0) continue;
      if (reach_[known].q != q) {
        for (known = 0; known < reach_.size() && reach_[known].q != q;) ++known;
        if (known == reach_.size()) reach_.push_back({q, {}});
      }
      const HatsIn<3> other = bonds_.stiffness_of(d, type) * hats(end(at, d));
      const std::array<int, 3> e{bonds_.half[d].x, bonds_.half[d].y, bonds_.half[d].z};
      for (std::size_t c = 0; c < 6; ++c) {
        const auto [a, b] = space_components[c];
        if (const int product = e[static_cast<std::size_t>(a)] * e[static_cast<std::size_t>(b)])
          reach_[known].sum[c] += product * other;
      }
    }
    const HatsIn<3>& own = hats(at);
    const auto diagonal = diagonal_.at(i);
    statics::CouplingIn<3>& within = sum.between(p, p);
    for (std::size_t c = 0; c < 6; ++c) {
      const auto [a, b] = space_components[c];
      auto& to = within.block[place_in_coupling(a, b)];
      const HatsIn<3>& ends = reach_[0].sum[c];
      take_product(to, own, ends - diagonal(a, b) * own);
      take_product(to, ends, own);
    }
    for (std::size_t k = 1; k < reach_.size(); ++k) {
      const bool low = p < reach_[k].q;
      statics::CouplingIn<3>& to = low ? sum.between(p, reach_[k].q) : sum.between(reach_[k].q, p);
      for (std::size_t c = 0; c < 6; ++c) {
        const auto [a, b] = space_components[c];
        auto& block = to.block[place_in_coupling(a, b)];
        if (low) take_product(block, own, reach_[k].sum[c]);
        else take_product(block, reach_[k].sum[c], own);
      }
    }
  }

  /// A node of the lowest level that moves along it only; all its bonds to nodes above start here.
  void add_sliding_node(std::ptrdiff_t i, std::array<int, 3> at, statics::CouplingSumIn<3>& sum) {
    const std::int32_t p = cut_.of_node[i];
    const HatsIn<3>& own = hats(at);
    const auto diagonal = diagonal_.at(i);
    statics::CouplingIn<3>& within = sum.between(p, p);
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b) take_product(within.block[place_in_coupling(a, b)], own, -diagonal(a, b) * own);
    for (std::size_t d = 0; d < bonds_.count(); ++d) {
      const unsigned type = bonds_.type(i, d);
      const std::int32_t q = type ? cut_.of_node[i + bonds_.step(d)] : -1;
      if (q < 0) continue;
      const std::array<int, 3> e{bonds_.half[d].x, bonds_.half[d].y, bonds_.half[d].z};
      const HatsIn<3> other = bonds_.stiffness_of(d, type) * hats(end(at, d));
      statics::CouplingIn<3>& to = p <= q ? sum.between(p, q) : sum.between(q, p);
      for (int a = 0; a < 2; ++a)
        for (int b = 0; b < (e[2] > 0 ? 3 : 2); ++b) {
          const HatsIn<3> scaled = e[static_cast<std::size_t>(a)] * e[static_cast<std::size_t>(b)] * other;
          if (p <= q) take_product(to.block[place_in_coupling(a, b)], own, scaled);
          if (p >= q) take_product(to.block[place_in_coupling(b, a)], scaled, own);
        }
    }
  }

  const SpaceBonds& bonds_;
  const statics::Aggregates& cut_;
  const statics::BlockDiagonalIn<3, double>& diagonal_;
  const std::vector<std::uint8_t>& prescribed_;
  statics::HatTableIn<3> hats_;
  std::vector<SpaceReach> reach_;
};

std::vector<std::pair<std::int32_t, std::int32_t>> bonded_pairs(const SpaceBonds& bonds,
                                                                const statics::Aggregates& aggregates) {
  std::vector<std::vector<std::int32_t>> others(aggregates.list.size());
  for (std::int32_t p = 0; p < aggregates.count(); ++p) others[static_cast<std::size_t>(p)].push_back(p);
  bonds.grid.each([&](std::ptrdiff_t i, int) {
    const std::int32_t p = aggregates.of_node[i];
    if (p < 0) return;
    for (std::size_t d = 0; d < bonds.count(); ++d) {
      const std::int32_t q = bonds.type(i, d) ? aggregates.of_node[i + bonds.step(d)] : -1;
      if (q < 0 || q == p) continue;
      const auto [low, high] = std::minmax(p, q);
      auto& known = others[static_cast<std::size_t>(low)];
      if (std::find(known.rbegin(), known.rend(), high) == known.rend()) known.push_back(high);
    }
  });
  std::vector<std::pair<std::int32_t, std::int32_t>> pairs;
  for (std::size_t p = 0; p < others.size(); ++p)
    for (const std::int32_t q : others[p]) pairs.push_back({static_cast<std::int32_t>(p), q});
  return pairs;
}

}  // namespace

statics::GalerkinSums<3> couplings(const SpaceBonds& bonds, const statics::Aggregates& aggregates,
                                   statics::BlockDiagonalIn<3, double> diagonal,
                                   const std::vector<std::uint8_t>& prescribed) {
  statics::GalerkinSums<3> sums;
  sums.pairs = bonded_pairs(bonds, aggregates);
  auto kept = std::make_shared<const statics::BlockDiagonalIn<3, double>>(std::move(diagonal));
  sums.each = [&bonds, kept = std::move(kept), prescribed](const statics::Aggregates& cut,
                                                           const statics::GalerkinSums<3>::Take& take) {
    SpaceBondSums level(bonds, cut, *kept, prescribed);
    for (int first = 0; first < bonds.grid.depth; first += cut.side) {
      statics::CouplingSumIn<3> sum(cut.list.size(), false);
      level.add_layers(first, std::min(first + cut.side, bonds.grid.depth), sum);
      for (const statics::CouplingIn<3>& c : sum.crosses()) take(c);
    }
  };
  return sums;
}

}  // namespace arenite::peridynamics
