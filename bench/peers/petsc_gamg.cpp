// The static solve beside PETSc: the same sample, bonds and clamps as an assembled matrix, conjugate gradients with
// algebraic multigrid (GAMG) and the rigid modes as near null space, to the same residual. Prints one line of JSON.
//
//   petsc_gamg NODES GAMMA BRIDGE     bridge: half-width over the radius, 10 and more fills all pores
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "../../tests/support/cemented_sample.hpp"
#include "gamg.hpp"
#include "solid/peridynamics/bonded_aggregates.hpp"
#include "solid/peridynamics/bonds.hpp"
#include "solid/peridynamics/load.hpp"
#include "solid/peridynamics/support.hpp"

namespace {

using namespace arenite;
using namespace arenite::peridynamics;
using bench::cpu_seconds;
using bench::must;
using bench::peak_megabytes;

/// Rows of the free nodes in compressed form; what the moved top row pulls with stands on the right.
struct System : bench::Rows {
  Bonds bonds;
  std::vector<std::ptrdiff_t> node;  ///< of each unknown pair
  std::vector<std::int32_t> number;  ///< unknown pair of each node, padded; -1: none
  double unit = 0;                   ///< displacement of the top row

  System(const PhaseMap& map, double strain) : bench::Rows{.components = 2}, bonds(make_bonds(map, {})) {
    const Grid& grid = bonds.grid;
    const auto rows = prescribed_levels<2>(map.height, Loading::tension, LowerEdge::fixed);
    auto aggregates = cut_into_aggregates(map, bonds, rows);
    Buffer<Tie> tie;
    prune(bonds, aggregates, rows, tie);
    unit = strain * (map.height - 1) * map.dx;
    number.assign(grid.padded_size(), -1);
    for (int y = 1; y < map.height - 1; ++y)
      for (int x = 0; x < map.width; ++x)
        if (const auto i = grid.index(x, y); tie[i] == Tie::both) {
          number[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(node.size());
          node.push_back(i);
          for (const int at : {x, y}) place.push_back(at);
        }
    fill(map);
  }

  void fill(const PhaseMap& map) {
    struct Neighbour {
      Offset e;
      int d;
      bool ahead;
    };
    std::vector<Neighbour> around;
    for (int d = 0; d < bonds_per_node; ++d) {
      const Offset e = half_bonds[static_cast<unsigned>(d)];
      around.push_back({e, d, true});
      around.push_back({{-e.x, -e.y}, d, false});
    }
    std::sort(around.begin(), around.end(),
              [](const Neighbour& a, const Neighbour& b) { return a.e.y != b.e.y ? a.e.y < b.e.y : a.e.x < b.e.x; });
    const Grid& grid = bonds.grid;
    right.assign(2 * node.size(), 0);
    u.assign(2 * node.size(), 0);
    column.reserve(2 * 58 * node.size());
    value.reserve(2 * 58 * node.size());
    for (std::size_t n = 0; n < node.size(); ++n) {
      const std::ptrdiff_t i = node[n];
      const int y = static_cast<int>((i - grid.row(0)) / grid.stride);
      u[2 * n + 1] = unit * y / (map.height - 1);
      std::array<std::array<double, 2>, 2> own{};
      struct Entry {
        PetscInt column;
        std::array<std::array<double, 2>, 2> block;
      };
      std::vector<Entry> row;
      std::size_t diagonal = 0;
      bool passed = false;  // rows are sorted: the node itself stands between those behind and those ahead of it
      for (const Neighbour& o : around) {
        if (!passed && (o.e.y > 0 || (o.e.y == 0 && o.e.x > 0))) {
          passed = true;
          diagonal = row.size();
          row.push_back({static_cast<PetscInt>(n), {}});
        }
        const std::ptrdiff_t j = i + o.e.x + o.e.y * grid.stride;
        const unsigned type = o.ahead ? bonds.type(i, o.d) : bonds.type(j, o.d);
        if (type == no_bond) continue;
        const double k = bonds.modulus(type) / std::pow(length(o.e), 3);
        const double b[2][2] = {{k * o.e.x * o.e.x, k * o.e.x * o.e.y}, {k * o.e.x * o.e.y, k * o.e.y * o.e.y}};
        for (unsigned r = 0; r < 2; ++r)
          for (unsigned c = 0; c < 2; ++c) own[r][c] += b[r][c];
        if (const auto m = number[static_cast<std::size_t>(j)]; m >= 0) {
          row.push_back({m, {{{-b[0][0], -b[0][1]}, {-b[1][0], -b[1][1]}}}});
        } else if (y + o.e.y == map.height - 1) {
          right[2 * n] += b[0][1] * unit;
          right[2 * n + 1] += b[1][1] * unit;
        }
      }
      row[diagonal].block = own;
      for (unsigned r = 0; r < 2; ++r) {
        for (const Entry& e : row)
          for (unsigned c = 0; c < 2; ++c) {
            column.push_back(2 * e.column + static_cast<PetscInt>(c));
            value.push_back(e.block[r][c]);
          }
        begin.push_back(static_cast<PetscInt>(column.size()));
      }
    }
  }

  /// Force that the top row needs, by the bonds that end in it.
  double modulus(const PhaseMap& map) const {
    const Grid& grid = bonds.grid;
    double force = 0;
    const int top = map.height - 1;
    for (int y = std::max(0, top - horizon); y < top; ++y)
      for (int x = 0; x < map.width; ++x)
        for (int d = 0; d < bonds_per_node; ++d) {
          const Offset e = half_bonds[static_cast<unsigned>(d)];
          const std::ptrdiff_t i = grid.index(x, y);
          const unsigned type = bonds.type(i, d);
          const auto n = number[static_cast<std::size_t>(i)];
          if (type == no_bond || y + e.y != top || n < 0) continue;
          const double ux = u[2 * n], uy = u[2 * n + 1];
          force += bonds.modulus(type) * e.y * (e.y * (unit - uy) - e.x * ux) / std::pow(length(e), 3);
        }
    return force / (map.width * map.dx * unit / ((map.height - 1) * map.dx));
  }
};

struct Outcome : bench::GamgOutcome {
  double modulus = 0;
};

Outcome solve_with_petsc(const PhaseMap& map) {
  const double began = cpu_seconds();
  System s(map, 1e-4);
  Outcome out{bench::solve_by_gamg(s, {.most_iterations = 500}, began)};
  out.modulus = s.modulus(map);
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    std::fputs("usage: petsc_gamg NODES GAMMA BRIDGE\n", stderr);
    return 2;
  }
  test::CementedSample sample;
  sample.nodes = std::atoi(argv[1]);
  sample.size_ratio = std::atof(argv[2]);
  sample.bridge = std::atof(argv[3]);
  const PhaseMap map = test::cemented_sample(sample);
  const double begin = cpu_seconds();
  LoadOptions options;
  options.strain = 1e-4;
  const LoadReport ours = load(map, options).report;
  const double seconds = cpu_seconds() - begin, memory = peak_megabytes();
  int none = 0;
  must(PetscInitialize(&none, nullptr, nullptr, nullptr));
  const Outcome peer = solve_with_petsc(map);
  std::printf(
      "{\"S_m\": %.3f, \"ours_seconds\": %.3f, \"ours_iterations\": %d, \"ours_residual\": %.2e, \"ours_peak_MB\": "
      "%.0f, \"petsc_assembly_seconds\": %.3f, \"petsc_setup_seconds\": %.3f, \"petsc_solve_seconds\": %.3f, "
      "\"petsc_iterations\": %d, \"petsc_residual\": %.2e, \"petsc_peak_MB\": %.0f, \"modulus_difference\": %.2e}\n",
      test::matrix_saturation(map), seconds, ours.iterations, ours.residual, memory, peer.assembly, peer.setup,
      peer.solve, static_cast<int>(peer.iterations), peer.residual, peak_megabytes(), peer.modulus / ours.modulus - 1);
  must(PetscFinalize());
  return ours.ending == Ending::solved ? 0 : 3;
}
