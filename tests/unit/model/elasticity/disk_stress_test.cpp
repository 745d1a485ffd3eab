#include "model/elasticity/disk_stress.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "model/elasticity/disk_field.hpp"
#include "support/film_page_sample.hpp"

namespace arenite::elasticity {
namespace {

TEST(DiskStress, IsTheMeanOfTheClosedForm) {
  const test::PageSample run(60);
  const Packing& p = run.stage.snapshots[3].packing;
  std::vector<Disk> disks;
  for (const double r : p.grains.radius) disks.push_back({r, p.domain.thickness, {}, Traction::point});
  for (std::size_t c = 0; c < p.contacts.size(); ++c) {
    disks[static_cast<std::size_t>(p.contacts.i[c])].forces.push_back(
        {p.contacts.normal[c], p.contacts.fn[c], p.contacts.ft[c], 0});
    if (!p.contacts.is_wall(c))
      disks[static_cast<std::size_t>(p.contacts.j[c])].forces.push_back(
          {-1 * p.contacts.normal[c], p.contacts.fn[c], p.contacts.ft[c], 0});
  }
  const auto stress = stress_of_disks(p);
  for (std::size_t g = 0; g < disks.size(); ++g) {
    const double closed = sigma_kk(disks[g], {}) / 2;
    EXPECT_NEAR(stress[g], closed, 1e-9 * std::abs(closed));
  }
}

TEST(DiskStress, ChangesByWhatTheLoadAdds) {
  // A disk squeezed by two walls, fn on either side: -2 fn/(2 pi R L), in a state of 30 N and one of 100 N.
  Packing low;
  low.materials = {{"A", 1000, 0, 0}};
  low.domain.thickness = 0.05;
  low.grains.resize(1);
  low.grains.radius = {0.01};
  Packing high = low;
  for (const double side : {-1.0, 1.0}) {
    low.contacts.add(0, wall_partner(side < 0 ? left : right), {-side, 0}, 30, 0, 0.01, 0);
    high.contacts.add(0, wall_partner(side < 0 ? left : right), {-side, 0}, 100, 0, 0.01, 0);
  }
  const double per_newton = -1 / (std::numbers::pi * 0.01 * 0.05);
  EXPECT_NEAR(stress_change(&low, high)[0], 70 * per_newton, 1e-9 * 1e5);
  EXPECT_NEAR(stress_change(nullptr, high)[0], 100 * per_newton, 1e-9 * 1e5);
}

}  // namespace
}  // namespace arenite::elasticity
