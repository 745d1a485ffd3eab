#include "solid/elements/couplings.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "solid/elements/cell_sums.hpp"
#include "solid/elements/kernels/kernels.hpp"
#include "solid/statics/pool.hpp"

namespace arenite::elements {
namespace {

using Pairs = std::vector<std::pair<std::int32_t, std::int32_t>>;

/// The corners of an element by the aggregates that they are of.
template <int D> struct Owners {
  std::array<std::int32_t, ElementsIn<D>::corner_count> list;
  std::array<std::uint8_t, ElementsIn<D>::corner_count> of_corner;  ///< place in the list
  unsigned count = 0;
  bool is_whole = true;  ///< every corner is somebody's, and no period has led to another place
  static constexpr std::uint8_t nobody = 255;
};

/// The aggregates of elements, by their lowest corners.
template <int D> class Corners {
 public:
  Corners(const ElementsIn<D>& elements, const Aggregates& aggregates)
      : elements_(elements),
        aggregates_(aggregates),
        steps_(elements.steps()) {}

  Owners<D> of(int x, int y, int z) const {
    const auto& cells = elements_.cells;
    const std::ptrdiff_t i = elements_.grid.index(x, y, z);
    const bool wraps = elements_.grid.periodic && (x + 1 == cells[0] || y + 1 == cells[1] || z + 1 == cells[2]);
    Owners<D> owners;
    owners.is_whole = !wraps;
    for (std::size_t c = 0; c < steps_.size(); ++c) {
      const auto [right, back, up] = place_of(static_cast<int>(c));
      const std::ptrdiff_t node = wraps ? elements_.node(x + right, y + back, z + up) : i + steps_[c];
      const std::int32_t p = aggregates_.of_node[node];
      unsigned at = 0;
      while (at < owners.count && owners.list[at] != p) ++at;
      if (p >= 0 && at == owners.count) owners.list[owners.count++] = p;
      owners.is_whole = owners.is_whole && p >= 0;
      owners.of_corner[c] = p < 0 ? Owners<D>::nobody : static_cast<std::uint8_t>(at);
    }
    return owners;
  }
  /// Of a corner in its element.
  static std::array<int, 3> place_of(int corner) { return {corner & 1, corner >> 1 & 1, corner >> 2}; }

 private:
  const ElementsIn<D>& elements_;
  const Aggregates& aggregates_;
  std::array<std::ptrdiff_t, ElementsIn<D>::corner_count> steps_;
};

template <int D> Pairs coupled_pairs(const ElementsIn<D>& elements, const Aggregates& aggregates) {
  const Corners<D> corners(elements, aggregates);
  const auto count = static_cast<std::size_t>(aggregates.count());
  Pairs pairs;
  for (std::int32_t p = 0; p < aggregates.count(); ++p) pairs.push_back({p, p});
  std::vector<std::vector<std::int32_t>> others(count);
  elements.each([&](int x, int y, int z) {
    if (elements.kind(elements.grid.index(x, y, z)) == none) return;
    const Owners<D> owners = corners.of(x, y, z);
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

/// What single elements add to the sums of one level of coarse cells.
template <int D> class LevelSums {
 public:
  using CouplingSum = statics::CouplingSumIn<D>;

  LevelSums(const ElementsIn<D>& elements, const Aggregates& cut, const std::vector<std::uint8_t>& prescribed)
      : elements_(elements),
        corners_(elements, cut),
        hats_(cut.side),
        prescribed_(prescribed) {}

  void add(int x, int y, int z, CouplingSum& sum) const {
    const Kind kind = elements_.kind(elements_.grid.index(x, y, z));
    if (kind != none) add(x, y, z, elements_.modes[kind], owners(x, y, z), sum);
  }
  void add(int x, int y, int z, const Modes<D>& modes, const Owners<D>& owners, CouplingSum& sum) const {
    std::array<Part<D>, ElementsIn<D>::corner_count> parts;
    for (unsigned p = 0; p < owners.count; ++p) parts[p].clear();
    const std::array<int, 3> nodes = elements_.grid.size();
    for (std::size_t c = 0; c < owners.of_corner.size(); ++c)
      if (const unsigned at = owners.of_corner[c]; at != Owners<D>::nobody) {
        std::array<int, 3> node = Corners<D>::place_of(static_cast<int>(c));
        node[0] = (x + node[0]) % nodes[0], node[1] = (y + node[1]) % nodes[1], node[2] = (z + node[2]) % nodes[2];
        parts[at].add(hats_.at(node[0], node[1], node[2]), static_cast<int>(c), slides(node[D - 1]));
      }
    for (unsigned a = 0; a < owners.count; ++a)
      for (unsigned b = a; b < owners.count; ++b) {
        const bool swap = owners.list[b] < owners.list[a];
        const unsigned low = swap ? b : a, high = swap ? a : b;
        couple_(modes, parts[low], parts[high], sum.between(owners.list[low], owners.list[high]));
      }
  }
  /// An element that is one aggregate's, whose part in it is known.
  void add_whole(const Modes<D>& modes, const Part<D>& part, std::int32_t owner, CouplingSum& sum) const {
    couple_(modes, part, part, sum.between(owner, owner));
  }

  Owners<D> owners(int x, int y, int z) const { return corners_.of(x, y, z); }
  bool slides(int level) const { return prescribed_[static_cast<std::size_t>(level)] == statics::normal_component<D>; }
  const statics::HatTableIn<D>& hats() const { return hats_; }

 private:
  const ElementsIn<D>& elements_;
  Corners<D> corners_;
  statics::HatTableIn<D> hats_;
  const std::vector<std::uint8_t>& prescribed_;
  CouplingKernel<D> couple_ = coupling_kernel<D>();
};

/// All elements of a layer of coarse cells.
template <int D> class SumOfLayer;

/// In the plane an element whose corners are of one aggregate has the same part in it wherever its cell lies.
template <> class SumOfLayer<2> {
 public:
  SumOfLayer(const Elements& elements, const Aggregates& cut, const std::vector<std::uint8_t>&,
             const LevelSums<2>& level)
      : elements_(elements),
        side_(cut.side),
        level_(level),
        whole_(static_cast<std::size_t>(side_ * side_)) {
    for (int y = 0; y + 1 < side_; ++y)
      for (int x = 0; x + 1 < side_; ++x) {
        Part<2>& part = whole_[place_in_cell(x, y)];
        part.clear();
        for (int c = 0; c < statics::corners<2>; ++c) {
          const auto [right, back, up] = Corners<2>::place_of(c);
          part.add(level_.hats().at(x + right, y + back, up), c, false);
        }
      }
  }
  void add(int layer, statics::CouplingSumIn<2>& sum) const {
    const int first = layer * side_;
    elements_.each_between(first, std::min(first + side_, elements_.cells[1]), [&](int x, int y, int z) {
      const Kind kind = elements_.kind(elements_.grid.index(x, y, z));
      if (kind == none) return;
      const Modes<2>& modes = elements_.modes[kind];
      const Owners<2> owners = level_.owners(x, y, z);
      if (owners.count == 1 && owners.is_whole && !level_.slides(y))
        level_.add_whole(modes, whole_[place_in_cell(x % side_, y % side_)], owners.list[0], sum);
      else level_.add(x, y, z, modes, owners, sum);
    });
  }

 private:
  std::size_t place_in_cell(int x, int y) const { return static_cast<std::size_t>(y * side_ + x); }

  const Elements& elements_;
  int side_;
  const LevelSums<2>& level_;
  std::vector<Part<2>> whole_;  ///< by the place of an element in its cell
};

template <> class SumOfLayer<3> {
 public:
  SumOfLayer(const Voxels& elements, const Aggregates& cut, const std::vector<std::uint8_t>& prescribed,
             const LevelSums<3>& level)
      : elements_(elements),
        side_(cut.side),
        cells_(elements, cut, prescribed),
        level_(level) {}
  void add(int layer, statics::CouplingSumIn<3>& sum) const {
    const auto& count = elements_.cells;
    const auto within = [&](int from, int axis) {
      return std::min(side_, count[static_cast<std::size_t>(axis)] - from);
    };
    const int z0 = layer * side_;
    for (int y0 = 0; y0 < count[1]; y0 += side_)
      for (int x0 = 0; x0 < count[0]; x0 += side_)
        cells_.add({x0, y0, within(x0, 0), within(y0, 1), z0, within(z0, 2)}, sum,
                   [&](int x, int y, int z) { level_.add(x, y, z, sum); });
  }

 private:
  const Voxels& elements_;
  int side_;
  CellSums cells_;
  const LevelSums<3>& level_;
};

}  // namespace

template <int D>
statics::GalerkinSums<D> couplings(const ElementsIn<D>& elements, const Aggregates& aggregates,
                                   BlockDiagonalIn<D, double>, const std::vector<std::uint8_t>& prescribed) {
  statics::GalerkinSums<D> sums;
  sums.pairs = coupled_pairs(elements, aggregates);
  sums.each = [&elements, prescribed](const Aggregates& cut, const typename statics::GalerkinSums<D>::Take& take) {
    const LevelSums<D> level(elements, cut, prescribed);
    const auto layers = static_cast<std::size_t>((elements.cells[D - 1] + cut.side - 1) / cut.side);
    const auto members = static_cast<std::size_t>(elements.pool ? elements.pool->size() : 1);
    std::vector<statics::CouplingSumIn<D>> sum(members, statics::CouplingSumIn<D>(cut.list.size(), false));
    const SumOfLayer<D> of_layer(elements, cut, prescribed, level);
    for (std::size_t first = 0; first < layers; first += members) {
      const std::size_t count = std::min(members, layers - first);
      statics::for_each(elements.pool, count, [&](std::size_t k) {
        sum[k].clear();
        of_layer.add(static_cast<int>(first + k), sum[k]);
      });
      for (std::size_t k = 0; k < count; ++k)
        for (const statics::CouplingIn<D>& c : sum[k].crosses()) take(c);
    }
  };
  return sums;
}

template statics::GalerkinSums<2> couplings(const Elements& elements, const Aggregates& aggregates,
                                            BlockDiagonalIn<2, double> diagonal,
                                            const std::vector<std::uint8_t>& prescribed);
template statics::GalerkinSums<3> couplings(const Voxels& elements, const Aggregates& aggregates,
                                            BlockDiagonalIn<3, double> diagonal,
                                            const std::vector<std::uint8_t>& prescribed);

}  // namespace arenite::elements
