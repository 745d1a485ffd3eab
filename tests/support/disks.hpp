#pragma once
#include <cmath>
#include <vector>

#include "model/packing.hpp"

namespace arenite::test {

struct Disk {
  double x, y, r;
};

/// Disks in a container from (-half, -half) to (half, half), walls or periodic.
inline Packing disks(const std::vector<Disk>& all, double half, bool periodic = false) {
  Packing packing;
  packing.grains.resize(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    packing.grains.position[i] = {all[i].x, all[i].y};
    packing.grains.radius[i] = all[i].r;
  }
  packing.domain.wall[left].position = packing.domain.wall[bottom].position = -half;
  packing.domain.wall[right].position = packing.domain.wall[top].position = half;
  packing.domain.periodic[0] = packing.domain.periodic[1] = periodic;
  for (auto& wall : packing.domain.wall) wall.present = !periodic;
  return packing;
}

}  // namespace arenite::test
