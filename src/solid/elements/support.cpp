#include "solid/elements/support.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "core/joined_sets.hpp"
#include "core/pages.hpp"
#include "solid/statics/halo.hpp"

namespace arenite::elements {
namespace {

using statics::Tie;
using Place = std::array<int, 3>;

template <int D> bool is_solid(const ElementsIn<D>& elements, Place at) {
  return elements.kind(elements.grid.index(at[0], at[1], at[2])) != none;
}
template <int D> std::int32_t place_of(const ElementsIn<D>& elements, Place at) {
  return elements.place(at[0], at[1], at[2]);
}

/// visit(place) for every cell that is not void.
template <int D, class Visit> void each_solid(const ElementsIn<D>& elements, const Visit& visit) {
  elements.each([&](int x, int y, int z) {
    if (is_solid(elements, {x, y, z})) visit(Place{x, y, z});
  });
}

/// Parts that edges (faces in space) join, inside the sample.
template <int D> JoinedSets parts_of(const ElementsIn<D>& elements) {
  JoinedSets sets(elements.count());
  each_solid(elements, [&](Place at) {
    for (std::size_t axis = 0; axis < D; ++axis) {
      Place before = at;
      if (--before[axis] >= 0 && is_solid(elements, before))
        sets.join(place_of(elements, before), place_of(elements, at));
    }
  });
  return sets;
}

/// What on the border of a period joins two parts, or a part to its own image `shift` periods away.
struct Seam {
  std::int32_t to;
  std::array<int, 3> shift;
};
using Seams = std::unordered_map<std::int32_t, std::vector<Seam>>;

template <int D> Seams seams_of(const ElementsIn<D>& elements, JoinedSets& sets) {
  Seams seams;
  const auto join = [&](std::size_t axis, Place first) {
    Place last = first;
    last[axis] = elements.cells[axis] - 1;
    if (!is_solid(elements, first) || !is_solid(elements, last)) return;
    const std::int32_t a = sets.find(place_of(elements, last)), b = sets.find(place_of(elements, first));
    const auto add = [&](std::int32_t from, std::int32_t to, int sign) {
      Seam seam{to, {}};
      seam.shift[axis] = sign;
      auto& list = seams[from];
      if (list.empty() || list.back().to != to || list.back().shift != seam.shift) list.push_back(seam);
    };
    add(a, b, 1);
    add(b, a, -1);
  };
  for (std::size_t axis = 0; axis < D; ++axis) {
    std::array<int, 3> border = elements.cells;
    border[axis] = 1;
    for (int z = 0; z < border[2]; ++z)
      for (int y = 0; y < border[1]; ++y)
        for (int x = 0; x < border[0]; ++x) join(axis, {x, y, z});
  }
  return seams;
}

/// Parts, by their numbers, that lead to an image of themselves, those that hang on such a part among them.
std::unordered_map<std::int32_t, bool> endless_parts(Seams seams) {
  std::unordered_map<std::int32_t, bool> endless;
  std::unordered_map<std::int32_t, std::array<int, 3>> at;
  for (const auto& [start, list] : seams) {
    if (at.contains(start)) continue;
    std::vector<std::int32_t> cluster{start};
    at[start] = {};
    bool wraps = false;
    for (std::size_t k = 0; k < cluster.size(); ++k)
      for (const Seam& seam : seams.at(cluster[k])) {
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

template <int D> statics::Support prune(ElementsIn<D>& elements, Buffer<Tie>& tie) {
  const Grid& grid = elements.grid;
  JoinedSets sets = parts_of(elements);
  Buffer<std::uint8_t> ties(elements.count());
  const int top = elements.cells[D - 1] - 1;
  const auto hold = [&](int level, Tie by) {
    elements.each_between(level, level + 1, [&](int x, int y, int z) {
      ties[static_cast<std::size_t>(sets.find(elements.place(x, y, z)))] |= static_cast<std::uint8_t>(by);
    });
  };
  hold(0, Tie::below);
  hold(top, Tie::above);
  statics::Support support;
  tie = Buffer<Tie>(grid.padded_size());
  const auto steps = elements.steps();
  each_solid(elements, [&](Place at) {
    const std::int32_t k = place_of(elements, at), root = sets.find(k);
    const auto own = static_cast<Tie>(ties[static_cast<std::size_t>(root)]);
    support.islands += own == Tie::none && root == k;
    ++(own == Tie::both    ? support.carrying
       : own == Tie::above ? support.held_above
       : own == Tie::below ? support.held_below
                           : support.floating);
    const std::ptrdiff_t i = grid.index(at[0], at[1], at[2]);
    for (const std::ptrdiff_t step : steps) tie[i + step] = std::max(tie[i + step], own);
    if (own != Tie::both) elements.words[i] = none;
  });
  support.solid = support.carrying + support.held_below + support.held_above + support.floating;
  return support;
}

template <int D> statics::Support prune_periodic(ElementsIn<D>& elements) {
  JoinedSets sets = parts_of(elements);
  const auto endless = endless_parts(seams_of(elements, sets));
  statics::Support support;
  each_solid(elements, [&](Place at) {
    const std::int32_t k = place_of(elements, at), root = sets.find(k);
    const auto found = endless.find(root);
    const bool carries = found != endless.end() && found->second;
    support.islands += !carries && root == k;
    ++(carries ? support.carrying : support.floating);
    if (!carries) elements.words[elements.grid.index(at[0], at[1], at[2])] = none;
  });
  statics::close_period(elements.grid, elements.words.data());
  support.solid = support.carrying + support.floating;
  return support;
}

template statics::Support prune(Elements& elements, Buffer<Tie>& tie);
template statics::Support prune(Voxels& elements, Buffer<Tie>& tie);
template statics::Support prune_periodic(Elements& elements);
template statics::Support prune_periodic(Voxels& elements);

}  // namespace arenite::elements
