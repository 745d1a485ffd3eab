#include "geometry/close_pairs.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "core/random.hpp"

namespace arenite::geometry {
namespace {

template <int D>
std::vector<Pair> by_brute_force(const std::vector<Vec<D>>& centre, const std::vector<double>& r, const Box<D>& box,
                                 double gap) {
  std::vector<Pair> pairs;
  for (int i = 0; i < static_cast<int>(centre.size()); ++i)
    for (int j = i + 1; j < static_cast<int>(centre.size()); ++j) {
      double square = 0;
      for (int axis = 0; axis < D; ++axis) {
        double d = centre[i][axis] - centre[j][axis];
        if (box.periodic[axis]) d -= box.size[axis] * std::nearbyint(d / box.size[axis]);
        square += d * d;
      }
      const double reach = r[i] + r[j] + gap;
      if (square <= reach * reach) pairs.push_back({i, j});
    }
  return pairs;
}

bool same(const std::vector<Pair>& a, const std::vector<Pair>& b) {
  return a.size() == b.size() &&
         std::equal(a.begin(), a.end(), b.begin(), [](Pair p, Pair q) { return p.i == q.i && p.j == q.j; });
}

template <int D> void hold_against_all_with_all() {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  const auto n = *rc::gen::inRange(0, 120);
  Box<D> box;
  for (int axis = 0; axis < D; ++axis) {
    box.corner[axis] = axis == 0 ? -1 : 2;
    box.size[axis] = *rc::gen::element(3.0, 8.0, 30.0);
    box.periodic[axis] = *rc::gen::arbitrary<bool>();
  }
  RandomStream random(seed, Purpose::test);
  std::vector<Vec<D>> centre(n);
  std::vector<double> r;
  for (Vec<D>& c : centre) {
    for (int axis = 0; axis < D; ++axis) {
      // Some lie outside the box: a list is built before they are wrapped.
      c[axis] = random.uniform(box.corner[axis] - 0.5, box.end()[axis] + 0.5);
      if (box.periodic[axis]) c[axis] -= box.size[axis] * std::floor((c[axis] - box.corner[axis]) / box.size[axis]);
    }
    r.push_back(random.uniform(0.05, 0.6));
  }
  if (std::ranges::none_of(box.periodic, [](bool periodic) { return periodic; })) RC_CLASSIFY(true, "walls");
  RC_ASSERT(same(close_pairs<D>(centre, r, box, 0.2), by_brute_force(centre, r, box, 0.2)));
}

RC_GTEST_PROP(ClosePairs, OfDisksAreThoseThatComparingAllWithAllFinds, ()) { hold_against_all_with_all<2>(); }
RC_GTEST_PROP(ClosePairs, OfSpheresAreThoseThatComparingAllWithAllFinds, ()) { hold_against_all_with_all<3>(); }

TEST(ClosePairs, OfDisksThatAllLieInEachOtherAreRefused) {
  const std::size_t n = 3000;
  const std::vector<Vec2> centre(n, {0.5, 0.5});
  const std::vector<double> r(n, 8.0);
  EXPECT_THROW(close_pairs(centre, r, {{}, {1, 1}}, 0), InputError);
}

}  // namespace
}  // namespace arenite::geometry
