#include "geometry/close_pairs.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "core/random.hpp"

namespace arenite::geometry {
namespace {

std::vector<Pair> by_brute_force(const std::vector<double>& x, const std::vector<double>& y, const std::vector<double>& r, const Box& box, double gap) {
  std::vector<Pair> pairs;
  for (int i = 0; i < static_cast<int>(x.size()); ++i)
    for (int j = i + 1; j < static_cast<int>(x.size()); ++j) {
      double dx = x[i] - x[j], dy = y[i] - y[j];
      if (box.periodic_x) dx -= box.width * std::nearbyint(dx / box.width);
      if (box.periodic_y) dy -= box.height * std::nearbyint(dy / box.height);
      const double reach = r[i] + r[j] + gap;
      if (dx * dx + dy * dy <= reach * reach) pairs.push_back({i, j});
    }
  return pairs;
}

bool same(const std::vector<Pair>& a, const std::vector<Pair>& b) {
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](Pair p, Pair q) { return p.i == q.i && p.j == q.j; });
}

RC_GTEST_PROP(ClosePairs, AreThoseThatComparingAllWithAllFinds, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  const auto n = *rc::gen::inRange(0, 120);
  const Box box{-1, 2, *rc::gen::element(3.0, 10.0, 40.0), *rc::gen::element(3.0, 8.0, 30.0), *rc::gen::arbitrary<bool>(), *rc::gen::arbitrary<bool>()};
  RandomStream random(seed, Purpose::test);
  std::vector<double> x, y, r;
  for (int i = 0; i < n; ++i) {
    // Some centres lie outside the box: a list is built before they are wrapped.
    x.push_back(random.uniform(box.x0 - 0.5, box.x0 + box.width + 0.5));
    y.push_back(random.uniform(box.y0 - 0.5, box.y0 + box.height + 0.5));
    r.push_back(random.uniform(0.05, 0.6));
  }
  if (!box.periodic_x && !box.periodic_y) RC_CLASSIFY(true, "walls");
  std::vector<double> wx = x, wy = y;
  if (box.periodic_x)
    for (auto& v : wx) v -= box.width * std::floor((v - box.x0) / box.width);
  if (box.periodic_y)
    for (auto& v : wy) v -= box.height * std::floor((v - box.y0) / box.height);
  RC_ASSERT(same(close_pairs(wx, wy, r, box, 0.2), by_brute_force(wx, wy, r, box, 0.2)));
}

TEST(ClosePairs, OfDisksThatAllLieInEachOtherAreRefused) {
  const std::size_t n = 3000;
  const std::vector<double> x(n, 0.5), y(n, 0.5), r(n, 8.0);
  EXPECT_THROW(close_pairs(x, y, r, {0, 0, 1, 1, false, false}, 0), InputError);
}

}  // namespace
}  // namespace arenite::geometry
