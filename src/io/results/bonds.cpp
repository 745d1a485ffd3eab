#include <functional>

#include "core/mapped.hpp"
#include "io/results/groups.hpp"

namespace arenite::io {
namespace {

struct BondColumn {
  const char *name, *unit;
  double& (*of)(Bond&);
};
constexpr BondColumn bond_columns[] = {{"length", "m", [](Bond& b) -> double& { return b.length; }},
                                       {"nx", "1", [](Bond& b) -> double& { return b.normal.x; }},
                                       {"ny", "1", [](Bond& b) -> double& { return b.normal.y; }},
                                       {"angle_i", "rad", [](Bond& b) -> double& { return b.angle_i; }},
                                       {"angle_j", "rad", [](Bond& b) -> double& { return b.angle_j; }},
                                       {"fn", "N", [](Bond& b) -> double& { return b.fn; }},
                                       {"ft", "N", [](Bond& b) -> double& { return b.ft; }},
                                       {"moment", "N m", [](Bond& b) -> double& { return b.moment; }},
                                       {"energy", "J", [](Bond& b) -> double& { return b.energy; }},
                                       {"load", "1", [](Bond& b) -> double& { return b.load; }},
                                       {"time", "s", [](Bond& b) -> double& { return b.time; }},
                                       {"x", "m", [](Bond& b) -> double& { return b.place.x; }},
                                       {"y", "m", [](Bond& b) -> double& { return b.place.y; }}};

struct CohesiveColumn {
  const char *name, *unit;
  double CohesivePair::*of;
};
constexpr CohesiveColumn cohesive_columns[] = {{"gap", "m", &CohesivePair::gap}, {"pull", "N", &CohesivePair::pull}, {"energy", "J", &CohesivePair::energy}};

/// Which grains each item joins, i < j.
template <class Item> void transfer_ends(const ResultPart& group, std::vector<Item>& items, std::size_t grains, const char* refusal) {
  auto i = mapped(items, &Item::i), j = mapped(items, &Item::j);
  group.array("i", i);
  group.array("j", j);
  group.same_length({i.size(), j.size()});
  items.resize(i.size());
  for (std::size_t n = 0; n < items.size(); ++n) {
    if (group.reads() && (i[n] < 0 || j[n] <= i[n] || static_cast<std::size_t>(j[n]) >= grains)) group.take->refuse(refusal);
    items[n].i = i[n];
    items[n].j = j[n];
  }
}

template <class Item, class Columns> void transfer_values(const ResultPart& group, std::vector<Item>& items, const Columns& columns) {
  for (const auto& column : columns) {
    auto values = mapped(items, [&](Item item) { return std::invoke(column.of, item); });
    group.array(column.name, values, column.unit);
    group.same_length({values.size(), items.size()});
    for (std::size_t n = 0; n < items.size(); ++n) std::invoke(column.of, items[n]) = values[n];
  }
}

}  // namespace

void transfer_bonds(const ResultPart& at, std::vector<Bond>& bonds, std::size_t grains) {
  if (at.reads() ? !at.take->has_group("bonds") : bonds.empty()) return;
  constexpr const char* refusal = "names a grain or a break that does not exist";
  const auto group = at.group("bonds");
  group.note("i and j", "places in the arrays of grains, from 0, i < j; signs as of contacts; length, n and angles are those of when the bond was made");
  group.note("broken", "0: holds; broken in 1 tension, 2 bending, 3 shear, at that time and place, with that energy");
  transfer_ends(group, bonds, grains, refusal);
  auto broken = mapped(bonds, [](const Bond& b) { return static_cast<std::int32_t>(b.broken); });
  group.array("broken", broken);
  group.same_length({broken.size(), bonds.size()});
  for (std::size_t b = 0; b < bonds.size(); ++b) {
    if (group.reads() && (broken[b] < 0 || broken[b] > 3)) group.take->refuse(refusal);
    bonds[b].broken = static_cast<BondBreak>(broken[b]);
  }
  transfer_values(group, bonds, bond_columns);
}

void transfer_cohesive(const ResultPart& at, std::vector<CohesivePair>& pairs, std::size_t grains) {
  if (at.reads() ? !at.take->has_group("cohesive") : pairs.empty()) return;
  const auto group = at.group("cohesive");
  group.note("i and j", "places in the arrays of grains, from 0, i < j; the pull of a pair whose gap is not above 0 is part of the force of its contact");
  transfer_ends(group, pairs, grains, "names a grain that does not exist");
  transfer_values(group, pairs, cohesive_columns);
}

}  // namespace arenite::io
