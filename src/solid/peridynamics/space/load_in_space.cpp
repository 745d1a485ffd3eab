#include "solid/peridynamics/space/load_in_space.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "solid/peridynamics/kernels/space_kernels.hpp"
#include "solid/peridynamics/space/bonds_in_space.hpp"
#include "solid/peridynamics/space/couplings_in_space.hpp"
#include "solid/statics/static_solver.hpp"

namespace arenite::peridynamics {
statics::LoadResultIn<3> load(const VoxelMap& map, const LoadOptions& options) {
  statics::check_load(options.strain, options.tolerance);
  SpaceBonds bonds = make_space_bonds(map, options.stiffness, options.horizon_in_space);
  const statics::Grid& grid = bonds.grid;
  const auto prescribed = statics::prescribed_levels<3>(grid.levels(), options.loading, options.lower);
  Buffer<statics::Tie> tie;
  statics::LoadResultIn<3> result;
  statics::LoadReportIn<3>& r = result.report;
  r.support = prune_in_space(bonds, map, prescribed, tie);
  const double gauge = (map.depth - 1) * map.dx;
  auto u = statics::uniform_strain<3>(grid, tie, options.strain * gauge * statics::direction_of<3>(options.loading));
  auto phase = map.phase.begin();
  grid.each([&](std::ptrdiff_t i, int) {
    if (*phase++ == Phase::empty) u.set(i, {});
  });
  if (r.support.carrying > 0) {
    statics::StaticSolver<SpaceBonds> solver(bonds, cut_space_bonds(map, bonds, prescribed, space_cell), prescribed);
    const int most = options.max_iterations > 0 ? options.max_iterations : statics::usual_cap(options.tolerance, 3);
    static_cast<statics::StaticReport&>(r) = solver.solve(bonds, u, options.tolerance, most, options.watch);
    r.ending = statics::ending_of(r);
  } else {
    r.ending = r.support.solid > 0 ? statics::Ending::severed : statics::Ending::empty;
  }
  result.field = node_stress(bonds, map.dx, u);
  if (r.support.carrying > 0) {
    statics::FieldIn<3, double> force(grid.padded_size());
    linear_force(bonds, u, force);
    statics::judge<3>({grid, tie, options.loading, options.strain, map.dx, gauge, section_of(map)}, u, force, result);
  }
  r.sentence = statics::sentence_of(r.ending, r, r.support, options.tolerance, "voxels");
  return result;
}

bool joined_through_voids_only(const VoxelMap& map) {
  std::vector<std::uint8_t> seen(map.size());
  std::vector<std::array<int, 3>> found;
  const auto visit = [&](int x, int y, int z) {
    const std::size_t i = map.index(x, y, z);
    if (map.phase[i] == Phase::empty || std::exchange(seen[i], 1)) return;
    found.push_back({x, y, z});
  };
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x) visit(x, y, 0);
  while (!found.empty()) {
    const auto [at_x, at_y, at_z] = found.back();
    found.pop_back();
    if (at_z == map.depth - 1) return false;
    for (int z = std::max(at_z - 1, 0); z <= at_z + 1; ++z)
      for (int y = std::max(at_y - 1, 0); y <= std::min(at_y + 1, map.height - 1); ++y)
        for (int x = std::max(at_x - 1, 0); x <= std::min(at_x + 1, map.width - 1); ++x) visit(x, y, z);
  }
  return true;
}

}  // namespace arenite::peridynamics
