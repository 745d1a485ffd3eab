#pragma once
#include <cmath>

#include "core/random.hpp"
#include "grains/dem/engine.hpp"
#include "grains/dem/run_stage.hpp"

namespace arenite::dem::testing {

/// A container without grains; one material of 27.35 kN/mm and 1410 kg/m^3, 60 mm thick.
inline Packing empty_container(double width, double height) {
  Packing p;
  p.materials = {{"pom", 1410, 27.35e6, 0}, {"hdpe", 950, 6.43e6, 0}};
  p.domain.wall[right].position = width;
  p.domain.wall[top].position = height;
  p.domain.thickness = 0.06;
  return p;
}

inline std::size_t add_grain(Packing& p, double x, double y, double radius, int material = 0) {
  const std::size_t k = p.grains.size();
  p.grains.resize(k + 1);
  p.grains.position[k] = {x, y};
  p.grains.radius[k] = radius;
  p.grains.material[k] = material;
  return k;
}

/// Disks of two materials, radii 4-8 mm, on a jittered lattice a little overlapping at random; caller's order shuffled
/// against the places.
inline Packing crowd(int columns, int rows, std::uint64_t seed, double pitch = 0.0135) {
  Packing p = empty_container(columns * pitch, rows * pitch);
  RandomStream random(seed, Purpose::test);
  const int n = columns * rows;
  for (int q = 0; q < n; ++q) {
    const int cell = static_cast<int>((static_cast<std::int64_t>(q) * 7919) % n);
    const double x = (cell % columns + 0.5 + random.uniform(-0.1, 0.1)) * pitch;
    const double y = (cell / columns + 0.5 + random.uniform(-0.1, 0.1)) * pitch;
    const int material = static_cast<int>(random.below(2));
    add_grain(p, x, y, random.uniform(0.004, 0.008), material);
    p.grains.id[p.grains.size() - 1] = 1000 + q;
  }
  return p;
}

/// The right and the upper wall close in at half a metre a second.
inline void squeeze(Engine& engine, std::int64_t steps) {
  WallDrives drives;
  drives[right] = {WallDrive::Kind::velocity, -0.5};
  drives[top] = {WallDrive::Kind::velocity, 0.5};
  set_drives(engine, drives);
  engine.advance(steps);
}

inline StageRun to_its_end(Engine& engine, const Stage& stage) {
  StageRun run = begin_stage(engine, stage);
  while (!run.finished) continue_stage(engine, stage, run);
  return run;
}

}  // namespace arenite::dem::testing
