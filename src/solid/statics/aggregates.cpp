#include "solid/statics/aggregates.hpp"

#include <algorithm>
#include <array>

#include "solid/statics/pieces.hpp"

namespace arenite::statics {
namespace {

/// Numbers the aggregates of one cell in the order of their first node, among those of a layer of cells.
void add_aggregates(const Grid& grid, const Buffer<std::int32_t>& owner, const Cell& c, JoinedSets& sets,
                    std::vector<std::int32_t>& aggregate, Aggregates& aggregates,
                    std::vector<Aggregates::Aggregate>& list) {
  const int side = aggregates.side;
  for (int z = 0; z < c.deep; ++z)
    for (int y = 0; y < c.high; ++y)
      for (int x = 0; x < c.wide; ++x) {
        const std::ptrdiff_t i = grid.index(c.x0 + x, c.y0 + y, c.z0 + z);
        if (owner[i] < 0) continue;
        const std::int32_t k = (z * side + y) * side + x, root = sets.find(k);
        if (root == k) {
          aggregate[k] = static_cast<std::int32_t>(list.size());
          list.push_back({owner[i], {c.x0 / side, c.y0 / side, c.z0 / side}});
        }
        const std::int32_t p = aggregate[root];
        aggregates.of_node[i] = p;
        ++list[static_cast<std::size_t>(p)].nodes;
      }
}

}  // namespace

namespace {

/// `sides` leads to the neighbours of a node; `piece` has the owner of every particle's node, one of so
/// many.
template <class Map>
std::vector<std::int32_t> flooded(const Map& map, const Grid& grid, const std::vector<std::ptrdiff_t>& sides,
                                  const std::vector<std::int32_t>& piece, std::int32_t pieces) {
  constexpr std::int32_t unowned = -2;
  Buffer<std::int32_t> owner(grid.padded_size(), -1);
  std::size_t k = 0;
  grid.each([&](std::ptrdiff_t i, int) {
    owner[i] = map.phase[k] == Phase::particle ? piece[k] : map.phase[k] == Phase::matrix ? unowned : -1;
    ++k;
  });
  std::vector<std::ptrdiff_t> front;
  const auto flood_from = [&](std::ptrdiff_t i) {
    for (const auto step : sides)
      if (owner[i + step] == unowned) {
        owner[i + step] = owner[i];
        front.push_back(i + step);
      }
  };
  auto phase = map.phase.begin();
  grid.each([&](std::ptrdiff_t i, int) {
    if (*phase++ == Phase::particle) flood_from(i);
  });
  for (std::size_t n = 0; n < front.size(); ++n) flood_from(front[n]);
  std::replace(owner.begin(), owner.end(), unowned, pieces);
  std::vector<std::int32_t> compact;
  compact.reserve(map.size());
  grid.each([&](std::ptrdiff_t i, int) { compact.push_back(owner[i]); });
  return compact;
}

}  // namespace

std::vector<std::int32_t> owners_in(const PhaseMap& map) {
  const Grid grid(map.width, map.height);
  return flooded(map, grid, {1, -1, grid.stride, -grid.stride}, map.grain,
                 static_cast<std::int32_t>(map.grain_class.size()));
}

std::vector<std::int32_t> owners_in(const VoxelMap& map) {
  const Grid grid(map.width, map.height, map.depth);
  const std::array<int, 3> count{map.width, map.height, map.depth};
  std::vector<std::int32_t> piece = map.grain;
  for (std::size_t k = 0; k < piece.size(); ++k)
    if (map.phase[k] != Phase::particle) piece[k] = -1;
  const std::int32_t pieces = cut_at_necks(piece, count, 0, static_cast<std::int32_t>(map.grain_class.size()));
  std::vector<std::int32_t> owner =
      flooded(map, grid, {1, -1, grid.stride, -grid.stride, grid.layer, -grid.layer}, piece, pieces);
  cut_at_necks(owner, count, pieces, pieces + 1);
  return owner;
}

Aggregates cut_by_owner(const Grid& grid, const Buffer<std::int32_t>& owner,
                        const std::function<void(const Cell&, JoinedSets&)>& join, int side, const ThreadPool* pool) {
  Aggregates aggregates;
  aggregates.side = side;
  aggregates.of_node.assign(grid.padded_size(), Aggregates::none);
  const auto places = static_cast<std::size_t>(side * side * (grid.in_space() ? side : 1));
  std::vector<std::vector<Aggregates::Aggregate>> lists(static_cast<std::size_t>((grid.depth + side - 1) / side));
  for_each(pool, lists.size(), [&](std::size_t layer) {
    JoinedSets sets;
    std::vector<std::int32_t> aggregate(places);
    const int z0 = static_cast<int>(layer) * side;
    for (int y0 = 0; y0 < grid.height; y0 += side)
      for (int x0 = 0; x0 < grid.width; x0 += side) {
        const Cell c{x0,
                     y0,
                     std::min(side, grid.width - x0),
                     std::min(side, grid.height - y0),
                     z0,
                     std::min(side, grid.depth - z0)};
        sets.part(places);
        join(c, sets);
        add_aggregates(grid, owner, c, sets, aggregate, aggregates, lists[layer]);
      }
  });
  std::vector<std::int32_t> first;
  for (const auto& list : lists) {
    first.push_back(aggregates.count());
    aggregates.list.insert(aggregates.list.end(), list.begin(), list.end());
  }
  each_node(pool, grid, [&](std::ptrdiff_t i, int level) {
    std::int32_t& p = aggregates.of_node[i];
    if (p >= 0 && grid.in_space()) p += first[static_cast<std::size_t>(level / side)];
  });
  return aggregates;
}

}  // namespace arenite::statics
