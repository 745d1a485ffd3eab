#include "solid/elements/support.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/joined_sets.hpp"

namespace arenite::elements {
namespace {

using statics::Tie;

/// Parts that edges join, by the pixels of each row.
JoinedSets parts_of(const Elements& elements) {
  const auto wide = static_cast<std::int32_t>(elements.columns());
  JoinedSets sets(static_cast<std::size_t>(wide) * static_cast<std::size_t>(elements.rows()));
  for (int y = 0; y < elements.rows(); ++y)
    for (std::int32_t x = 0; x < wide; ++x) {
      const std::ptrdiff_t i = elements.grid.index(x, y);
      if (elements.kind(i) == none) continue;
      if (x > 0 && elements.kind(i - 1) != none) sets.join(y * wide + x - 1, y * wide + x);
      if (y > 0 && elements.kind(i - elements.grid.stride) != none) sets.join((y - 1) * wide + x, y * wide + x);
    }
  return sets;
}

}  // namespace

statics::Support prune(Elements& elements, Buffer<Tie>& tie) {
  const Grid& grid = elements.grid;
  const std::int32_t wide = elements.columns(), high = elements.rows();
  JoinedSets sets = parts_of(elements);
  std::vector<std::uint8_t> ties(static_cast<std::size_t>(wide) * static_cast<std::size_t>(high), 0);
  for (std::int32_t x = 0; x < wide; ++x) {
    ties[static_cast<std::size_t>(sets.find(x))] |= static_cast<std::uint8_t>(Tie::below);
    ties[static_cast<std::size_t>(sets.find((high - 1) * wide + x))] |= static_cast<std::uint8_t>(Tie::above);
  }
  statics::Support support;
  tie = Buffer<Tie>(grid.padded_size());
  for (std::int32_t y = 0; y < high; ++y)
    for (std::int32_t x = 0; x < wide; ++x) {
      const std::ptrdiff_t i = grid.index(x, y);
      if (elements.kind(i) == none) continue;
      const std::int32_t root = sets.find(y * wide + x);
      const auto own = static_cast<Tie>(ties[static_cast<std::size_t>(root)]);
      support.islands += own == Tie::none && root == y * wide + x;
      ++(own == Tie::both    ? support.carrying
         : own == Tie::above ? support.held_above
         : own == Tie::below ? support.held_below
                             : support.floating);
      for (const std::ptrdiff_t corner : {i, i + 1, i + grid.stride, i + grid.stride + 1})
        tie[corner] = std::max(tie[corner], own);
      if (own != Tie::both) elements.words[i] = none;
    }
  support.solid = support.carrying + support.held_below + support.held_above + support.floating;
  return support;
}

}  // namespace arenite::elements
