// Elements in space beside PETSc: the same voxels, clamps and rows as an assembled matrix, conjugate gradients with
// algebraic multigrid (GAMG) and the rigid modes as near null space, to the same residual. Prints one line of JSON.
//
//   petsc_voxels VOXELS RATIO FILLED [ROUNDS]     turn about on one core; 1 fills all pores with matrix
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>
#include <vector>

#include "../../tests/support/element_samples.hpp"
#include "gamg.hpp"
#include "solid/elements/kernels/kernels.hpp"
#include "solid/elements/load.hpp"
#include "solid/elements/support.hpp"
#include "solid/statics/residual.hpp"

namespace {

using namespace arenite;
using bench::cpu_seconds;
using bench::must;
using bench::peak_megabytes;
using statics::FieldIn;

constexpr std::size_t corners = 8;
using Square = std::array<std::array<double, 3>, 3>;

/// Rows of the free nodes in compressed form; what the strained sample pulls with stands on the right.
struct System : bench::Rows {
  elements::Voxels voxels;
  FieldIn<3, double> field;
  std::vector<std::uint8_t> prescribed;
  double reference = 0;
  std::vector<std::ptrdiff_t> node;
  std::vector<PetscInt> number;
  std::array<std::array<std::array<Square, corners>, corners>, 4> block{};

  System(const VoxelMap& map, const elements::LoadOptions& options)
      : bench::Rows{.components = 3},
        voxels(elements::make_elements<3>(map, options.material)) {
    const statics::Grid& grid = voxels.grid;
    Buffer<statics::Tie> tie;
    elements::prune(voxels, tie);
    prescribed = statics::prescribed_levels<3>(grid.levels(), options.loading, options.lower);
    field = statics::uniform_strain<3>(grid, tie, {0, 0, options.strain * map.depth * map.dx});
    FieldIn<3, double> work(grid.padded_size()), force(grid.padded_size());
    reference = statics::residual_reference(voxels, prescribed, field, work, force);
    elements::kernels_of(voxels).force(voxels, prescribed.data(), statics::pointers(std::as_const(field)),
                                       statics::pointers(force));
    for (const elements::Kind kind : elements::solid_kinds)
      for (std::size_t c = 0; c < corners; ++c)
        for (std::size_t d = 0; d < corners; ++d)
          block[kind][c][d] = elements::corner_block<3>(voxels.modes[kind], static_cast<int>(c), static_cast<int>(d));
    number_nodes();
    for (std::size_t n = 0; n < node.size(); ++n) add_row(node[n]);
    for (const std::ptrdiff_t i : node)
      for (int c = 0; c < 3; ++c) right.push_back(force[c][i]);
    u.assign(right.size(), 0.0);
  }

  void number_nodes() {
    const statics::Grid& grid = voxels.grid;
    const auto steps = voxels.steps();
    number.assign(grid.padded_size(), -1);
    for (int z = 1; z + 1 < grid.depth; ++z)
      for (int y = 0; y < grid.height; ++y)
        for (int x = 0; x < grid.width; ++x) {
          const std::ptrdiff_t i = grid.index(x, y, z);
          if (std::ranges::none_of(steps, [&](std::ptrdiff_t s) { return voxels.kind(i - s) != elements::none; }))
            continue;
          number[static_cast<std::size_t>(i)] = static_cast<PetscInt>(node.size());
          node.push_back(i);
          for (const int at : {x, y, z}) place.push_back(at);
        }
  }

  /// Three rows: the node's blocks with all neighbours, in order.
  void add_row(std::ptrdiff_t i) {
    const statics::Grid& grid = voxels.grid;
    const auto steps = voxels.steps();
    std::array<std::pair<PetscInt, Square>, 27> row;
    std::size_t count = 0;
    for (int z = -1; z <= 1; ++z)
      for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
          const std::ptrdiff_t j = i + x + y * grid.stride + z * grid.layer;
          const PetscInt m = number[static_cast<std::size_t>(j)];
          if (m < 0) continue;
          Square sum{};
          bool any = false;
          for (std::size_t c = 0; c < corners; ++c) {  // of the cell whose corner c is this node
            const int dx = static_cast<int>(c & 1) + x, dy = static_cast<int>(c >> 1 & 1) + y,
                      dz = static_cast<int>(c >> 2) + z;
            if ((dx | dy | dz) & ~1) continue;
            const elements::Kind kind = voxels.kind(i - steps[c]);
            if (kind == elements::none) continue;
            any = true;
            const Square& more = block[kind][c][static_cast<std::size_t>(dx + 2 * dy + 4 * dz)];
            for (std::size_t a = 0; a < 3; ++a)
              for (std::size_t b = 0; b < 3; ++b) sum[a][b] += more[a][b];
          }
          if (any) row[count++] = {m, sum};
        }
    for (std::size_t a = 0; a < 3; ++a) {
      for (std::size_t k = 0; k < count; ++k)
        for (std::size_t b = 0; b < 3; ++b) {
          column.push_back(3 * row[k].first + static_cast<PetscInt>(b));
          value.push_back(row[k].second[a][b]);
        }
      begin.push_back(static_cast<PetscInt>(column.size()));
    }
  }
};

struct Outcome : bench::GamgOutcome {
  double force = 0;
};

Outcome solve_with_petsc(const VoxelMap& map, const elements::LoadOptions& options) {
  const double began = cpu_seconds();
  System s(map, options);
  Outcome out{bench::solve_by_gamg(s, {options.tolerance, s.reference}, began)};
  const double* added = s.u.data();
  for (const std::ptrdiff_t i : s.node)
    for (int c = 0; c < 3; ++c) s.field[c][i] += *added++;
  const FieldIn<3, double> force = elements::forces_of(s.voxels, s.field);
  s.voxels.grid.each([&](std::ptrdiff_t i, int level) {
    if (level == s.voxels.grid.levels() - 1) out.force -= force.z[i] * map.dx;
  });
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    std::fputs("usage: petsc_voxels VOXELS RATIO FILLED [ROUNDS]\n", stderr);
    return 2;
  }
  const VoxelMap map = test::cemented_spheres(std::atoi(argv[1]), std::atoi(argv[3]) != 0);
  elements::LoadOptions options;
  options.material = {{1, 0.3}, {1, 0.3}, {std::atof(argv[2]), 0.25}};
  int none = 0;
  must(PetscInitialize(&none, nullptr, nullptr, nullptr));
  for (int round = 0; round < (argc > 4 ? std::atoi(argv[4]) : 1); ++round) {
    const double begin = cpu_seconds();
    const auto ours = elements::load(map, options).report;
    const double seconds = cpu_seconds() - begin, memory = peak_megabytes();
    if (ours.ending != statics::Ending::solved) return 3;
    const Outcome peer = solve_with_petsc(map, options);
    std::printf(
        "{\"ours_cpu_seconds\": %.2f, \"ours_iterations\": %d, \"ours_residual\": %.2e, \"ours_peak_MB\": %.0f, "
        "\"petsc_assembly_seconds\": %.2f, \"petsc_setup_seconds\": %.2f, \"petsc_solve_seconds\": %.2f, "
        "\"petsc_iterations\": %d, \"petsc_residual\": %.2e, \"petsc_peak_MB\": %.0f, \"ratio\": %.1f, "
        "\"force_difference\": %.1e}\n",
        seconds, ours.iterations, ours.residual, memory, peer.assembly, peer.setup, peer.solve,
        static_cast<int>(peer.iterations), peer.residual, peak_megabytes(),
        (peer.assembly + peer.setup + peer.solve) / seconds, peer.force / ours.top_force.z - 1);
    std::fflush(stdout);
  }
  must(PetscFinalize());
}
