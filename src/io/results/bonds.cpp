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

}  // namespace

void transfer_bonds(const ResultPart& at, std::vector<Bond>& bonds, std::size_t grains) {
  if (at.reads() ? !at.take->has_group("bonds") : bonds.empty()) return;
  const auto group = at.group("bonds");
  group.note("i and j", "places in the arrays of grains, from 0, i < j; signs as of contacts; length, n and angles are those of when the bond was made");
  group.note("broken", "0: holds; broken in 1 tension, 2 bending, 3 shear, at that time and place, with that energy");
  auto i = mapped(bonds, &Bond::i), j = mapped(bonds, &Bond::j), broken = mapped(bonds, [](const Bond&b) { return static_cast<std::int32_t>(b.broken); });
  group.array("i", i);
  group.array("j", j);
  group.array("broken", broken);
  group.same_length({i.size(), j.size(), broken.size()});
  bonds.resize(i.size());
  for (std::size_t b = 0; b < bonds.size(); ++b) {
    if (i[b] < 0 || j[b] <= i[b] || static_cast<std::size_t>(j[b]) >= grains || broken[b] < 0 || broken[b] > 3)
      if (at.reads()) group.take->refuse("names a grain or a break that does not exist");
    bonds[b].i = i[b];
    bonds[b].j = j[b];
    bonds[b].broken = static_cast<BondBreak>(broken[b]);
  }
  for (const BondColumn& column : bond_columns) {
    auto values = mapped(bonds, [&](Bond bond) { return column.of(bond); });
    group.array(column.name, values, column.unit);
    group.same_length({values.size(), bonds.size()});
    for (std::size_t b = 0; b < bonds.size(); ++b) column.of(bonds[b]) = values[b];
  }
}

void transfer_cohesive(const ResultPart& at, std::vector<CohesivePair>& pairs, std::size_t grains) {
  if (at.reads() ? !at.take->has_group("cohesive") : pairs.empty()) return;
  const auto group = at.group("cohesive");
  group.note("i and j", "places in the arrays of grains, from 0, i < j; the pull of a pair whose gap is not above 0 is part of the force of its contact");
  auto i = mapped(pairs, &CohesivePair::i), j = mapped(pairs, &CohesivePair::j);
  group.array("i", i);
  group.array("j", j);
  group.same_length({i.size(), j.size()});
  pairs.resize(i.size());
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    if (at.reads() && (i[p] < 0 || j[p] <= i[p] || static_cast<std::size_t>(j[p]) >= grains)) group.take->refuse("names a grain that does not exist");
    pairs[p].i = i[p];
    pairs[p].j = j[p];
  }
  for (const CohesiveColumn& column : cohesive_columns) {
    auto values = mapped(pairs, column.of);
    group.array(column.name, values, column.unit);
    group.same_length({values.size(), pairs.size()});
    for (std::size_t p = 0; p < pairs.size(); ++p) pairs[p].*column.of = values[p];
  }
}

}  // namespace arenite::io
