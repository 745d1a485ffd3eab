#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>

#include "support.hpp"

namespace arenite::verification {
namespace {

using dem::Engine;

/// Every overlap of the sample, pair by pair and wall by wall.
std::map<std::pair<std::int32_t, std::int32_t>, double> all_overlaps(const Packing& p) {
  std::map<std::pair<std::int32_t, std::int32_t>, double> found;
  const auto n = static_cast<std::int32_t>(p.grains.size());
  for (std::int32_t i = 0; i < n; ++i) {
    const auto a = static_cast<std::size_t>(i);
    for (std::int32_t j = i + 1; j < n; ++j) {
      const auto b = static_cast<std::size_t>(j);
      const Vec2 d = p.domain.nearest_image(p.grains.position[a] - p.grains.position[b]);
      const double overlap = p.grains.radius[a] + p.grains.radius[b] - norm(d);
      if (overlap > 0) found[{i, j}] = overlap;
    }
    for (int side = 0; side < 4; ++side) {
      const Wall& wall = p.domain.wall[static_cast<std::size_t>(side)];
      if (!wall.present) continue;
      const Vec2 plane =
          side < 2 ? Vec2{wall.position, p.grains.position[a].y} : Vec2{p.grains.position[a].x, wall.position};
      const double overlap = p.grains.radius[a] - dot(p.grains.position[a] - plane, inward_normal(side));
      if (overlap > 0) found[{i, wall_partner(side)}] = overlap;
    }
  }
  return found;
}

/// A gas of disks of radii 1 to 8 mm that flies apart at up to some radii a hundred steps.
Packing gas(bool periodic_x, bool periodic_y, double tilt) {
  Packing p = box(0.16, 0.12);
  p.domain.periodic[0] = periodic_x;
  p.domain.periodic[1] = periodic_y;
  p.domain.tilt = tilt;
  RandomStream random(17, Purpose::test);
  for (int attempt = 0; attempt < 4000 && p.grains.size() < 110; ++attempt) {
    Disk disk;
    disk.radius = p.grains.size() < 12 ? 8e-3 : random.uniform(1e-3, 3e-3);
    disk.centre = {random.uniform(disk.radius, 0.16 - disk.radius), random.uniform(disk.radius, 0.12 - disk.radius)};
    disk.velocity = {random.uniform(-30, 30), random.uniform(-30, 30)};
    disk.material = random.uniform() < 0.5 ? pom : hdpe;
    const bool free =
        std::none_of(p.grains.position.begin(), p.grains.position.end(), [&, i = std::size_t{0}](Vec2 other) mutable {
          const Vec2 d = p.domain.nearest_image(other - disk.centre);
          return norm(d) < 0.95 * (p.grains.radius[i++] + disk.radius);
        });
    if (free) add(p, disk);
  }
  return p;
}

TEST(ContactSearch, MissesNoneOfTheContactsThatTryingAllPairsFinds) {
  struct Cell {
    bool x, y;
    double tilt;
  };
  for (const Cell cell : {Cell{false, false, 0}, Cell{true, false, 0}, Cell{false, true, 0}, Cell{true, true, 0},
                          Cell{true, true, 0.05}}) {
    SCOPED_TRACE(std::string(cell.x ? "periodic in x " : "") + (cell.y ? "periodic in y " : "") +
                 std::to_string(cell.tilt));
    Engine engine(gas(cell.x, cell.y, cell.tilt), frictionless(0.9), with_step(2e-7));
    std::size_t seen = 0;
    for (int part = 0; part < 300; ++part) {
      engine.advance(37);
      const Packing p = packing_of(engine);
      const auto expected = all_overlaps(p);
      ASSERT_EQ(p.contacts.size(), expected.size()) << "at step " << engine.step;
      for (std::size_t c = 0; c < p.contacts.size(); ++c) {
        const auto it = expected.find({p.contacts.i[c], p.contacts.j[c]});
        ASSERT_TRUE(it != expected.end());
        EXPECT_NEAR(p.contacts.overlap[c], it->second, 1e-15);
      }
      seen += expected.size();
    }
    EXPECT_GT(seen, 800u);
  }
}

}  // namespace
}  // namespace arenite::verification
