#include "model/elasticity/disk_stress.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
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

}  // namespace
}  // namespace arenite::elasticity
