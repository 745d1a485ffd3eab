#include "solid/voxels/support.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "core/joined_sets.hpp"
#include "solid/statics/halo.hpp"

namespace arenite::voxels {
namespace {

using statics::Tie;

/// The voxels of a sample by their places in its map.
struct Places {
  const Voxels& voxels;

  std::size_t count() const {
    return static_cast<std::size_t>(voxels.width) * static_cast<std::size_t>(voxels.height) *
           static_cast<std::size_t>(voxels.depth);
  }
  std::int32_t of(int x, int y, int z) const { return x + voxels.width * (y + voxels.height * z); }
  bool solid(int x, int y, int z) const { return voxels.kind(voxels.grid.index(x, y, z)) != none; }
  /// visit(x, y, z, place) for every solid voxel.
  template <class Visit> void each(const Visit& visit) const {
    for (int z = 0; z < voxels.depth; ++z)
      for (int y = 0; y < voxels.height; ++y)
        for (int x = 0; x < voxels.width; ++x)
          if (solid(x, y, z)) visit(x, y, z, of(x, y, z));
  }
};

/// Parts that faces join, inside the sample.
JoinedSets parts_of(const Places& places) {
  JoinedSets sets(places.count());
  places.each([&](int x, int y, int z, std::int32_t k) {
    if (x > 0 && places.solid(x - 1, y, z)) sets.join(places.of(x - 1, y, z), k);
    if (y > 0 && places.solid(x, y - 1, z)) sets.join(places.of(x, y - 1, z), k);
    if (z > 0 && places.solid(x, y, z - 1)) sets.join(places.of(x, y, z - 1), k);
  });
  return sets;
}

/// A face on the border of a period that joins two parts, or a part to its own image `shift` periods away.
struct Seam {
  std::int32_t to;
  std::array<int, 3> shift;
};

/// Parts, by their numbers, that lead to an image of themselves, those that hang on such a part among them.
std::unordered_map<std::int32_t, bool> endless_parts(const Places& places, JoinedSets& sets) {
  const Voxels& v = places.voxels;
  std::unordered_map<std::int32_t, std::vector<Seam>> seams;
  const auto join = [&](int axis, std::array<int, 3> first, std::array<int, 3> last) {
    if (!places.solid(first[0], first[1], first[2]) || !places.solid(last[0], last[1], last[2])) return;
    const std::int32_t a = sets.find(places.of(last[0], last[1], last[2])),
                       b = sets.find(places.of(first[0], first[1], first[2]));
    std::array<int, 3> shift{};
    shift[static_cast<std::size_t>(axis)] = 1;
    const auto add = [&](std::int32_t from, std::int32_t to, int sign) {
      Seam seam{to, shift};
      for (int& s : seam.shift) s *= sign;
      auto& list = seams[from];
      if (list.empty() || list.back().to != to || list.back().shift != seam.shift) list.push_back(seam);
    };
    add(a, b, 1);
    add(b, a, -1);
  };
  for (int z = 0; z < v.depth; ++z)
    for (int y = 0; y < v.height; ++y) join(0, {0, y, z}, {v.width - 1, y, z});
  for (int z = 0; z < v.depth; ++z)
    for (int x = 0; x < v.width; ++x) join(1, {x, 0, z}, {x, v.height - 1, z});
  for (int y = 0; y < v.height; ++y)
    for (int x = 0; x < v.width; ++x) join(2, {x, y, 0}, {x, y, v.depth - 1});
  std::unordered_map<std::int32_t, bool> endless;
  std::unordered_map<std::int32_t, std::array<int, 3>> at;
  for (const auto& [start, list] : seams) {
    if (at.contains(start)) continue;
    std::vector<std::int32_t> cluster{start};
    at[start] = {};
    bool wraps = false;
    for (std::size_t k = 0; k < cluster.size(); ++k)
      for (const Seam& seam : seams[cluster[k]]) {
        std::array<int, 3> there = at[cluster[k]];
        for (std::size_t axis = 0; axis < 3; ++axis) there[axis] += seam.shift[axis];
        const auto [known, is_new] = at.try_emplace(seam.to, there);
        if (is_new) cluster.push_back(seam.to);
        else wraps = wraps || known->second != there;
      }
    for (const std::int32_t part : cluster) endless[part] = wraps;
  }
  return endless;
}

}  // namespace

statics::Support prune(Voxels& voxels, Buffer<Tie>& tie) {
  const Grid& grid = voxels.grid;
  const Places places{voxels};
  JoinedSets sets = parts_of(places);
  std::vector<std::uint8_t> ties(places.count(), 0);
  for (int y = 0; y < voxels.height; ++y)
    for (int x = 0; x < voxels.width; ++x) {
      ties[static_cast<std::size_t>(sets.find(places.of(x, y, 0)))] |= static_cast<std::uint8_t>(Tie::below);
      ties[static_cast<std::size_t>(sets.find(places.of(x, y, voxels.depth - 1)))] |=
          static_cast<std::uint8_t>(Tie::above);
    }
  statics::Support support;
  tie = Buffer<Tie>(grid.padded_size());
  const auto steps = voxels.corners();
  places.each([&](int x, int y, int z, std::int32_t k) {
    const std::int32_t root = sets.find(k);
    const auto own = static_cast<Tie>(ties[static_cast<std::size_t>(root)]);
    support.islands += own == Tie::none && root == k;
    ++(own == Tie::both    ? support.carrying
       : own == Tie::above ? support.held_above
       : own == Tie::below ? support.held_below
                           : support.floating);
    const std::ptrdiff_t i = grid.index(x, y, z);
    for (const std::ptrdiff_t step : steps) tie[i + step] = std::max(tie[i + step], own);
    if (own != Tie::both) voxels.words[i] = none;
  });
  support.solid = support.carrying + support.held_below + support.held_above + support.floating;
  return support;
}

statics::Support prune_periodic(Voxels& voxels) {
  const Places places{voxels};
  JoinedSets sets = parts_of(places);
  const auto endless = endless_parts(places, sets);
  statics::Support support;
  places.each([&](int x, int y, int z, std::int32_t k) {
    const std::int32_t root = sets.find(k);
    const auto found = endless.find(root);
    const bool carries = found != endless.end() && found->second;
    support.islands += !carries && root == k;
    ++(carries ? support.carrying : support.floating);
    if (!carries) voxels.words[voxels.grid.index(x, y, z)] = none;
  });
  statics::close_period(voxels.grid, voxels.words.data());
  support.solid = support.carrying + support.floating;
  return support;
}

}  // namespace arenite::voxels
