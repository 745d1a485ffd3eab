#include <benchmark/benchmark.h>

#include <map>
#include <utility>

#include "../tests/support/element_samples.hpp"
#include "process_use.hpp"
#include "solid/elements/load.hpp"

namespace {

using namespace arenite;

/// Voxels a side; whether all pores are filled.
const VoxelMap& sample(const benchmark::State& state) {
  static std::map<std::pair<std::int64_t, std::int64_t>, VoxelMap> made;
  const std::pair key{state.range(0), state.range(2)};
  if (!made.contains(key)) {
    made.clear();
    made[key] = test::cemented_spheres(static_cast<int>(key.first), key.second != 0);
  }
  return made[key];
}

/// The whole of `load`: elements, pieces, coarse levels, iterations, stresses; at a ratio of moduli.
void voxel_solve(benchmark::State& state) {
  const VoxelMap& map = sample(state);
  elements::LoadOptions options;
  options.threads = static_cast<int>(state.range(3));
  options.material = {{1, 0.3}, {1, 0.3}, {static_cast<double>(state.range(1)), 0.25}};
  statics::LoadReportIn<3> report;
  const double start = bench::cpu_seconds();
  for (auto _ : state) report = elements::load(map, options).report;
  state.counters["cpu_seconds"] = (bench::cpu_seconds() - start) / static_cast<double>(state.iterations());
  state.counters["solver_iterations"] = report.iterations;
  state.counters["residual"] = report.residual;
  state.counters["identity"] = report.identity_defect;
  state.counters["coarse_nodes"] = static_cast<double>(report.coarse_nodes);
  state.counters["peak_MB"] = bench::peak_megabytes();
  if (report.ending != statics::Ending::solved) state.SkipWithError(report.sentence.c_str());
}

BENCHMARK(voxel_solve)
    ->ArgNames({"voxels", "ratio", "filled", "threads"})
    ->Args({32, 4, 0, 1})
    ->Args({64, 4, 0, 1})
    ->Args({64, 100, 0, 1})
    ->Args({64, 100, 1, 1})
    ->Args({128, 4, 0, 1})
    ->Args({128, 100, 0, 1})
    ->Args({128, 100, 1, 1})
    ->Args({256, 4, 0, 1})
    ->Args({256, 4, 0, 2})
    ->Args({256, 100, 0, 2})
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);

}  // namespace

BENCHMARK_MAIN();
