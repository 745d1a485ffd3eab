#include "solid/voxels/load.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/problems.hpp"
#include "solid/statics/halo.hpp"
#include "solid/statics/static_solver.hpp"
#include "solid/voxels/kernels/kernels.hpp"
#include "solid/voxels/support.hpp"

namespace arenite::voxels {
namespace {

Vec3 top_direction(statics::Loading loading) {
  constexpr Vec3 directions[] = {{0, 0, 1}, {0, 0, -1}, {1, 0, 0}};
  return directions[static_cast<std::size_t>(loading)];
}

std::vector<std::uint8_t> prescribed_layers(const Grid& grid, const LoadOptions& options) {
  if (options.loading == statics::Loading::shear && options.lower == statics::LowerEdge::sliding)
    throw InputError("a sliding lower face carries no shear; fix it, or choose tension or compression");
  std::vector<std::uint8_t> layers(static_cast<std::size_t>(grid.depth), statics::nothing_prescribed);
  layers.front() = options.lower == statics::LowerEdge::sliding ? statics::z_prescribed : statics::all_prescribed;
  layers.back() = statics::all_prescribed;
  return layers;
}

/// Images of porous matter without grains take a few times as many as packings.
int most_iterations(const SolveOptions& options) {
  return options.max_iterations > 0 ? options.max_iterations : 4 * statics::usual_cap(options.tolerance);
}

/// Uniform strain where the sample carries; the clamp's displacement where it hangs on one only.
Field<double> first_guess(const Grid& grid, const Buffer<statics::Tie>& tie, Vec3 top) {
  Field<double> u(grid.padded_size());
  grid.each([&](std::ptrdiff_t i, int level) {
    double share = static_cast<double>(level) / (grid.depth - 1);
    const bool clamped = level == 0 || level == grid.depth - 1;
    if (!clamped && tie[i] != statics::Tie::both) share = tie[i] == statics::Tie::above ? 1 : 0;
    u.set(i, share * top);
  });
  return u;
}

/// The force of every voxel on its corners, clamps or not; a voxel of side dx has dx times the stiffness of unit side.
Field<double> forces_of(const Voxels& voxels, const Field<double>& u) {
  Field<double> force(voxels.grid.padded_size());
  const std::vector<std::uint8_t> free(static_cast<std::size_t>(voxels.grid.levels()), statics::nothing_prescribed);
  kernels_of(voxels).force(voxels, free.data(), statics::pointers(u), statics::pointers(force));
  return force;
}

void judge(const Voxels& voxels, const LoadOptions& options, const Field<double>& force, LoadResult& result) {
  LoadReport& r = result.report;
  const double dx = result.field.dx;
  voxels.grid.each([&](std::ptrdiff_t i, int level) {
    if (level == 0) r.bottom_force -= dx * force.at(i);
    if (level == voxels.grid.depth - 1) r.top_force -= dx * force.at(i);
  });
  const bool shear = options.loading == statics::Loading::shear;
  const double carried = shear ? r.top_force.x : r.top_force.z;
  double sum = 0;
  for (const float stress : shear ? result.field.xz : result.field.zz) sum += static_cast<double>(stress);
  const double height = voxels.depth * dx, area = voxels.width * dx * (voxels.height * dx);
  if (carried != 0) r.identity_defect = sum * dx * dx * dx / (carried * height) - 1;
  r.modulus = std::abs(carried) / (area * options.strain);
}

elasticity::SpaceBounds bounds_of(const Voxels& voxels, const Material& material) {
  std::array<double, 4> count{};
  for (int z = 0; z < voxels.depth; ++z)
    for (int y = 0; y < voxels.height; ++y)
      for (int x = 0; x < voxels.width; ++x) count[voxels.kind(voxels.grid.index(x, y, z))] += 1;
  const double all = count[none] + count[matrix] + count[interface] + count[particle];
  std::vector<elasticity::SpaceShare> shares{{count[none] / all, 0, 0}};
  for (const auto& [kind, constants] :
       {std::pair{matrix, material.matrix}, {interface, material.interface}, {particle, material.particle}})
    shares.push_back({count[kind] / all, constants.young / (3 * (1 - 2 * constants.poisson)),
                      constants.young / (2 * (1 + constants.poisson))});
  return elasticity::space_bounds(shares);
}

/// The forces that a uniform strain itself leaves: its displacements are linear beyond the period too.
Field<double> forces_of_strain(const Voxels& voxels, const std::array<double, 6>& strain, double dx) {
  const Grid& grid = voxels.grid;
  Field<double> linear(grid.padded_size());
  for (int z = -1; z <= grid.depth; ++z)
    for (int y = -1; y <= grid.height; ++y)
      for (int x = -1; x <= grid.width; ++x) {
        const Vec3 at{x * dx, y * dx, z * dx};
        linear.set(grid.index(x, y, z),
                   {strain[voigt_xx] * at.x + 0.5 * (strain[voigt_xy] * at.y + strain[voigt_xz] * at.z),
                    strain[voigt_yy] * at.y + 0.5 * (strain[voigt_xy] * at.x + strain[voigt_yz] * at.z),
                    strain[voigt_zz] * at.z + 0.5 * (strain[voigt_xz] * at.x + strain[voigt_yz] * at.y)});
      }
  return forces_of(voxels, linear);
}

std::array<double, 6> mean_stress(const VoxelStress& field) {
  std::array<double, 6> mean{};
  std::size_t row = 0;
  for (const auto* component : {&field.xx, &field.yy, &field.zz, &field.yz, &field.xz, &field.xy}) {
    for (const float stress : *component) mean[row] += static_cast<double>(stress);
    mean[row++] /= static_cast<double>(field.size());
  }
  return mean;
}

/// Cells of the coarse space that fit a period, as near to what was asked for as there are.
int cell_of_period(const VoxelMap& map, int wanted) {
  for (const int more : {0, 1, -1, 2, -2, 3, -3, 4})
    if (const int side = wanted + more; side >= 3)
      if (map.width % side == 0 && map.height % side == 0 && map.depth % side == 0) return side;
  return wanted;
}

}  // namespace

LoadResult load(const VoxelMap& map, const LoadOptions& options) {
  statics::check_load(options.strain, options.tolerance);
  Voxels voxels = make_voxels(map, options.material);
  const auto prescribed = prescribed_layers(voxels.grid, options);
  Buffer<statics::Tie> tie;
  LoadResult result;
  LoadReport& r = result.report;
  r.support = prune(voxels, tie);
  Field<double> u =
      first_guess(voxels.grid, tie, options.strain * (map.depth * map.dx) * top_direction(options.loading));
  if (r.support.carrying > 0) {
    statics::StaticSolver<Voxels> solver(voxels, cut_into_aggregates(map, voxels, prescribed, options.cell),
                                         prescribed);
    static_cast<statics::StaticReport&>(r) =
        solver.solve(voxels, u, options.tolerance, most_iterations(options), options.watch);
    r.coarse_nodes = static_cast<std::size_t>(solver.coarse_nodes());
    r.ending = statics::ending_of(r);
  } else {
    r.ending = r.support.solid > 0 ? statics::Ending::severed : statics::Ending::empty;
  }
  result.field = voxel_stress(map, voxels, u);
  if (r.support.carrying > 0) judge(voxels, options, forces_of(voxels, u), result);
  r.sentence = statics::sentence_of(r.ending, r, r.support, options.tolerance, "voxels");
  return result;
}

EffectiveStiffness effective_stiffness(const VoxelMap& map, const SolveOptions& options) {
  statics::check_load(1e-4, options.tolerance);
  Voxels voxels = make_voxels(map, options.material, true);
  EffectiveStiffness result;
  result.bounds = bounds_of(voxels, options.material);
  result.support = prune_periodic(voxels);
  if (result.support.carrying == 0) return result;
  const Grid& grid = voxels.grid;
  const std::vector<std::uint8_t> free(static_cast<std::size_t>(grid.levels()), statics::nothing_prescribed);
  const int cell = cell_of_period(map, options.cell);
  statics::StaticSolver<Voxels> solver(voxels, cut_into_aggregates(map, voxels, free, cell), free);
  for (std::size_t k = 0; k < 6; ++k) {
    std::array<double, 6> strain{};
    strain[k] = 1;
    const Field<double> body = forces_of_strain(voxels, strain, map.dx);
    Field<double> u(grid.padded_size());
    // One material answers with itself: what is left is the rounding of the displacements.
    const double rounding =
        1e-12 * voxels.modes[particle].axial * map.dx * std::max({map.width, map.height, map.depth});
    const double left = std::sqrt(statics::square_norm(grid, body) / static_cast<double>(map.size()));
    if (left < rounding) result.solves[k].converged = true;
    else result.solves[k] = solver.solve(voxels, u, options.tolerance, most_iterations(options), options.watch, &body);
    if (result.solves[k].stopped) return result;
    const auto stress = mean_stress(voxel_stress(map, voxels, u, strain));
    for (std::size_t row = 0; row < 6; ++row) result.stiffness[row][k] = stress[row];
  }
  return result;
}

}  // namespace arenite::voxels
