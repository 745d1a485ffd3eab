#include "solid/peridynamics/hinges.hpp"

#include <algorithm>
#include <cstdint>
#include <map>

namespace arenite::peridynamics {
namespace {

/// Depth-first walk without recursion: a sample is a million nodes deep. The lower clamp is where it starts; the upper
/// clamp is a node of its own, tied to every node of the top row.
struct Walk {
  static constexpr std::ptrdiff_t upper_clamp = 0;  ///< a place in the padding
  static constexpr int bonds_of_node = 2 * bonds_per_node;
  const Bonds& bonds;
  struct Visit {
    std::int32_t order = 0;   ///< of discovery; 0: not yet, 1: the lower clamp
    std::int32_t low = 0;     ///< earliest node that the branch is tied to
    std::int32_t behind = 1;  ///< nodes of the branch
    std::int32_t next = 0;    ///< tie to follow next
    std::int32_t parent = -1;
    bool top = false;  ///< the branch holds the upper clamp
  };
  std::vector<Visit> visits;
  std::map<std::ptrdiff_t, Hinge> hinges;
  std::int32_t count = 1;

  explicit Walk(const Bonds& b) : bonds(b), visits(b.grid.padded_size()) {
    at(upper_clamp).behind = 0;
    at(upper_clamp).top = true;
  }

  Visit& at(std::ptrdiff_t i) { return visits[i]; }
  int row_of(std::ptrdiff_t i) const { return static_cast<int>((i - bonds.grid.row(0)) / bonds.grid.stride); }
  int ties_of(std::ptrdiff_t i) const { return i == upper_clamp ? bonds.grid.width : bonds_of_node + 1; }
  bool has_bonds(std::ptrdiff_t i) const {
    for (int k = 0; k < bonds_of_node; ++k)
      if (bonded(i, k) >= 0) return true;
    return false;
  }

  /// Where tie k of a node leads, -1 where it has none: the 28 bonds, the clamp.
  std::ptrdiff_t tied(std::ptrdiff_t i, int k) const {
    const int top = bonds.grid.height - 1;
    if (i == upper_clamp) return has_bonds(bonds.grid.index(k, top)) ? bonds.grid.index(k, top) : -1;
    if (k == bonds_of_node) return row_of(i) == top ? upper_clamp : -1;
    return bonded(i, k);
  }
  /// The 14 bonds that start at a node come first, then the 14 that end there.
  std::ptrdiff_t bonded(std::ptrdiff_t i, int k) const {
    if (k < bonds_per_node) return bonds.type(i, k) ? i + bonds.step(k) : -1;
    const std::ptrdiff_t j = i - bonds.step(k - bonds_per_node);
    return bonds.type(j, k - bonds_per_node) ? j : -1;
  }

  void discover(std::ptrdiff_t i, std::ptrdiff_t parent) {
    Visit& v = at(i);
    v.order = ++count;
    v.low = i != upper_clamp && row_of(i) == 0 ? 1 : v.order;
    v.parent = static_cast<std::int32_t>(parent);
  }

  void close(std::ptrdiff_t child) {
    const Visit& c = at(child);
    const std::ptrdiff_t parent = c.parent;
    Visit& p = at(parent);
    p.low = std::min(p.low, c.low);
    p.behind += c.behind;
    p.top = p.top || c.top;
    if (c.low < p.order || parent == upper_clamp || child == upper_clamp) return;
    const int y = row_of(parent);
    Hinge& h = hinges.try_emplace(parent, Hinge{static_cast<std::int32_t>(parent - bonds.grid.row(y)), y, 0, false})
                   .first->second;
    h.nodes += static_cast<std::size_t>(c.behind);
    h.carries = h.carries || c.top;
  }

  void start_at(std::ptrdiff_t start) {
    discover(start, -1);
    for (std::ptrdiff_t i = start;;) {
      Visit& v = at(i);
      if (v.next == ties_of(i)) {
        if (i == start) return;
        close(i);
        i = v.parent;
        continue;
      }
      const std::ptrdiff_t j = tied(i, v.next++);
      if (j < 0) continue;
      if (at(j).order == 0) {
        discover(j, i);
        i = j;
      } else if (j != v.parent) {
        v.low = std::min(v.low, at(j).order);
      }
    }
  }
};

}  // namespace

std::vector<Hinge> find_hinges(const Bonds& bonds) {
  Walk walk(bonds);
  const Grid& grid = bonds.grid;
  for (int x = 0; x < grid.width; ++x)
    if (bonds.words[grid.index(x, 0)] && walk.at(grid.index(x, 0)).order == 0) walk.start_at(grid.index(x, 0));
  std::vector<Hinge> hinges;
  for (const auto& [node, hinge] : walk.hinges) hinges.push_back(hinge);
  return hinges;
}

}  // namespace arenite::peridynamics
