#include "solid/elements/elements.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/joined_sets.hpp"
#include "core/problems.hpp"
#include "solid/statics/halo.hpp"

namespace arenite::elements {
namespace {

void check(const char* kind, const Constants& c) {
  if (!(c.young > 0) || !std::isfinite(c.young))
    throw refusal("the Young modulus of {} elements is {:g} Pa; give a positive one", kind, c.young);
  if (!(c.poisson > -1 && c.poisson < 0.5))
    throw refusal("Poisson's ratio of {} elements is {:g}; give one above -1 and below 0.5", kind, c.poisson);
}

std::array<int, 3> cells_of(const PhaseMap& map) { return {map.width, map.height, 1}; }
std::array<int, 3> cells_of(const VoxelMap& map) { return {map.width, map.height, map.depth}; }

Grid grid_of(const PhaseMap& map, int more) { return {map.width + more, map.height + more}; }
Grid grid_of(const VoxelMap& map, int more) { return {map.width + more, map.height + more, map.depth + more}; }

/// Kind of the cell at (x, y, z), by its own phase and those around it, beyond the border of a periodic sample too.
template <int D> Kind kind_at(const MapIn<D>& map, const ElementsIn<D>& elements, std::array<int, 3> at) {
  const auto own = static_cast<std::size_t>(elements.place(at[0], at[1], at[2]));
  if (map.phase[own] == Phase::empty) return none;
  const bool in_grain = map.phase[own] == Phase::particle;
  const auto& cells = elements.cells;
  const int reach = D > 2 ? 1 : 0;
  for (int c = at[2] - reach; c <= at[2] + reach; ++c)
    for (int b = at[1] - 1; b <= at[1] + 1; ++b)
      for (int a = at[0] - 1; a <= at[0] + 1; ++a) {
        const bool outside = a < 0 || b < 0 || c < 0 || a >= cells[0] || b >= cells[1] || c >= cells[2];
        if (outside && !elements.grid.periodic) continue;
        const auto n = static_cast<std::size_t>(
            outside ? elements.place((a + cells[0]) % cells[0], (b + cells[1]) % cells[1], (c + cells[2]) % cells[2])
                    : elements.place(a, b, c));
        if (map.phase[n] == Phase::particle && (!in_grain || map.grain[n] != map.grain[own])) return interface;
      }
  return in_grain ? particle : matrix;
}

}  // namespace

template <int D> std::array<std::ptrdiff_t, ElementsIn<D>::corner_count> ElementsIn<D>::steps() const {
  std::array<std::ptrdiff_t, corner_count> steps;
  for (std::size_t corner = 0; corner < corner_count; ++corner) {
    const auto c = static_cast<std::ptrdiff_t>(corner);
    steps[corner] = (c & 1) + (c >> 1 & 1) * grid.stride + (c >> 2) * grid.layer;
  }
  return steps;
}

template <int D>
ElementsIn<D> make_elements(const MapIn<D>& map, const Material& material, bool periodic, const ThreadPool* pool) {
  arenite::check(map);
  check("matrix", material.matrix);
  check("interface", material.interface);
  check("particle", material.particle);
  ElementsIn<D> elements;
  elements.pool = pool;
  elements.cells = cells_of(map);
  elements.grid = grid_of(map, periodic ? 0 : 1);
  elements.grid.periodic = periodic;
  elements.words = Buffer<std::uint32_t>(elements.grid.padded_size());
  elements.each_shared([&](int x, int y, int z) {
    elements.words[elements.grid.index(x, y, z)] = kind_at<D>(map, elements, {x, y, z});
  });
  statics::close_period(elements.grid, elements.words.data());
  for (const auto& [kind, constants] :
       {std::pair{matrix, material.matrix}, {interface, material.interface}, {particle, material.particle}}) {
    const Modes<D> exact = modes_of<D>(constants, material.element, material.plane);
    unsigned column = 0;
    for (const auto mode : Modes<D>::members) {
      elements.table[column][kind] = static_cast<float>(exact.*mode);
      elements.modes[kind].*mode = static_cast<double>(elements.table[column++][kind]);
    }
  }
  return elements;
}

template <int D> std::function<statics::BlockIn<D>(std::ptrdiff_t)> blocks_of(const ElementsIn<D>& elements) {
  constexpr std::size_t corners = ElementsIn<D>::corner_count;
  std::array<std::array<statics::BlockIn<D>, corners>, 4> of_kind{};
  for (const Kind kind : solid_kinds)
    for (std::size_t c = 0; c < corners; ++c) {
      const auto block = corner_block<D>(elements.modes[kind], static_cast<int>(c), static_cast<int>(c));
      for (int a = 0; a < D; ++a)
        for (int b = a; b < D; ++b)
          of_kind[kind][c](a, b) = block[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)];
    }
  return [&elements, of_kind, steps = elements.steps()](std::ptrdiff_t i) {
    statics::BlockIn<D> own;
    for (std::size_t c = corners; c-- > 0;) {
      const auto& block = of_kind[elements.kind(i - steps[c])][c];
      for (int a = 0; a < D; ++a)
        for (int b = a; b < D; ++b) own(a, b) += block(a, b);
    }
    return own;
  };
}

template <int D> BlockDiagonalIn<D, double> block_diagonal(const ElementsIn<D>& elements) {
  BlockDiagonalIn<D, double> sum(elements.grid.padded_size());
  const auto block = blocks_of(elements);
  elements.grid.each([&](std::ptrdiff_t i, int) { sum.set(i, block(i)); });
  return sum;
}

template <int D> statics::Smoothing smoothing_of(const ElementsIn<D>& elements) {
  double highest = 0;
  for (const Kind kind : solid_kinds) highest = std::max(highest, highest_ratio<D>(elements.modes[kind]));
  return D == 2 ? statics::Smoothing{6, highest / 40, highest} : statics::Smoothing{4, highest / 20, highest};
}

namespace {

/// The grain that most of the stiffness around a corner is of; -1 where all is void.
template <int D, class Steps>
std::int32_t owner_of(const ElementsIn<D>& elements, const Steps& steps, const Buffer<std::int32_t>& of_cell,
                      std::ptrdiff_t i) {
  std::int32_t best = -1;
  double most = 0;
  for (const std::ptrdiff_t own_step : steps) {
    const std::ptrdiff_t own = i - own_step;
    if (elements.kind(own) == none) continue;
    double weight = 0;
    for (const std::ptrdiff_t other_step : steps)
      if (const std::ptrdiff_t other = i - other_step; elements.kind(other) != none && of_cell[other] == of_cell[own])
        weight += elements.modes[elements.kind(other)].axial;
    if (weight > most || (weight == most && of_cell[own] < best)) most = weight, best = of_cell[own];
  }
  return best;
}

template <int D>
Buffer<std::int32_t> owners_of(const MapIn<D>& map, const ElementsIn<D>& elements,
                               const std::vector<std::uint8_t>& prescribed) {
  const Grid& grid = elements.grid;
  const auto of_map = statics::owners_in(map);
  Buffer<std::int32_t> of_cell(grid.padded_size(), -1), owner(grid.padded_size(), -1);
  elements.each_shared([&](int x, int y, int z) {
    of_cell[grid.index(x, y, z)] = of_map[static_cast<std::size_t>(elements.place(x, y, z))];
  });
  statics::close_period(grid, of_cell.data());
  const auto steps = elements.steps();
  statics::each_node(elements.pool, grid, [&](std::ptrdiff_t i, int level) {
    if (prescribed[static_cast<std::size_t>(level)] != statics::every_component<D>)
      owner[i] = owner_of(elements, steps, of_cell, i);
  });
  return owner;
}

}  // namespace

template <int D>
Aggregates cut_into_aggregates(const MapIn<D>& map, const ElementsIn<D>& elements,
                               const std::vector<std::uint8_t>& prescribed, int side) {
  const Grid& grid = elements.grid;
  const auto steps = elements.steps();
  const Buffer<std::int32_t> owner = owners_of<D>(map, elements, prescribed);
  // A cell of the map joins those of its corners that lie in the coarse cell: it may reach over the border on every
  // side.
  const auto join = [&](const statics::Cell& cell, JoinedSets& sets, int x, int y, int z) {
    const std::ptrdiff_t i = grid.index(cell.x0 + x, cell.y0 + y, cell.z0 + z);
    if (elements.kind(i) == none) return;
    std::array<int, ElementsIn<D>::corner_count> place;
    for (std::size_t c = 0; c < place.size(); ++c) {
      const int right = x + static_cast<int>(c & 1), back = y + static_cast<int>(c >> 1 & 1),
                up = z + static_cast<int>(c >> 2);
      const bool inside = right >= 0 && right < cell.wide && back >= 0 && back < cell.high && up >= 0 &&
                          up < cell.deep && owner[i + steps[c]] >= 0;
      place[c] = inside ? (up * side + back) * side + right : -1;
      if (place[c] < 0) continue;
      for (std::size_t b = 0; b < c; ++b)
        if (place[b] >= 0 && owner[i + steps[b]] == owner[i + steps[c]]) {
          sets.join(place[b], place[c]);
          break;
        }
    }
  };
  return statics::cut_by_owner(
      grid, owner,
      [&](const statics::Cell& cell, JoinedSets& sets) {
        for (int z = D > 2 ? -1 : 0; z < cell.deep; ++z)
          for (int y = -1; y < cell.high; ++y)
            for (int x = -1; x < cell.wide; ++x) join(cell, sets, x, y, z);
      },
      side, elements.pool);
}

template struct ElementsIn<2>;
template struct ElementsIn<3>;
template Elements make_elements<2>(const PhaseMap& map, const Material& material, bool periodic,
                                   const ThreadPool* pool);
template Voxels make_elements<3>(const VoxelMap& map, const Material& material, bool periodic, const ThreadPool* pool);
template BlockDiagonalIn<2, double> block_diagonal(const Elements& elements);
template BlockDiagonalIn<3, double> block_diagonal(const Voxels& elements);
template std::function<statics::BlockIn<2>(std::ptrdiff_t)> blocks_of(const Elements& elements);
template std::function<statics::BlockIn<3>(std::ptrdiff_t)> blocks_of(const Voxels& elements);
template statics::Smoothing smoothing_of(const Elements& elements);
template statics::Smoothing smoothing_of(const Voxels& elements);
template Aggregates cut_into_aggregates<2>(const PhaseMap& map, const Elements& elements,
                                           const std::vector<std::uint8_t>& prescribed, int side);
template Aggregates cut_into_aggregates<3>(const VoxelMap& map, const Voxels& elements,
                                           const std::vector<std::uint8_t>& prescribed, int side);

}  // namespace arenite::elements
