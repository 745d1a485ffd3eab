#include <benchmark/benchmark.h>

#include <map>

#include "../tests/support/cemented_sample.hpp"
#include "process_use.hpp"
#include "solid/elements/load.hpp"
#include "solid/peridynamics/load.hpp"

namespace {

using namespace arenite;
using namespace arenite::peridynamics;
using bench::cpu_seconds;
using bench::peak_megabytes;

/// Nodes a side, size ratio times 100, half-width of the bridges times 100 (1000 and more fills all pores).
const PhaseMap& sample(const benchmark::State& state) {
  static std::map<std::array<std::int64_t, 3>, PhaseMap> made;
  const std::array<std::int64_t, 3> key{state.range(0), state.range(1), state.range(2)};
  if (!made.contains(key)) {
    made.clear();
    test::CementedSample s;
    s.nodes = static_cast<int>(key[0]);
    s.size_ratio = static_cast<double>(key[1]) / 100;
    s.bridge = static_cast<double>(key[2]) / 100;
    made[key] = test::cemented_sample(s);
  }
  return made[key];
}

template <class Options> void run(benchmark::State& state, const Options& options) {
  const PhaseMap& map = sample(state);
  LoadReport report;
  const double start = cpu_seconds();
  for (auto _ : state) {
    const LoadResult result = load(map, options);
    report = result.report;
  }
  state.counters["cpu_seconds"] = (cpu_seconds() - start) / static_cast<double>(state.iterations());
  state.counters["solver_iterations"] = report.iterations;
  state.counters["residual"] = report.residual;
  state.counters["identity"] = report.identity_defect;
  state.counters["peak_MB"] = peak_megabytes();
  state.counters["S_m"] = test::matrix_saturation(map);
  if (report.ending != Ending::solved) state.SkipWithError(report.sentence.c_str());
}

/// The whole of `load`: bonds, pieces, coarse factor, iterations, stresses.
void static_solve(benchmark::State& state) { run(state, LoadOptions{}); }

/// The same of elements of the same moduli.
void solve_of_elements(benchmark::State& state) { run(state, elements::LoadOptions{}); }

void adaptive_relaxation(benchmark::State& state) {
  LoadOptions options;
  options.method = Method::relaxation;
  options.tolerance = 1e-8;  // leaves the error in stress of the static solve's 1e-6
  run(state, options);
}

void samples(benchmark::internal::Benchmark* b) {
  for (const int gamma : {100, 250, 500})
    for (const int bridge : {20, 40, 80, 1000}) b->Args({1024, gamma, bridge});
  b->ArgNames({"nodes", "gamma", "bridge"})->Unit(benchmark::kMillisecond)->Iterations(1);
}

}  // namespace

BENCHMARK(static_solve)->Apply(samples);
BENCHMARK(static_solve)
    ->Args({128, 250, 40})
    ->Args({2048, 250, 40})
    ->Args({4096, 250, 40})
    ->ArgNames({"nodes", "gamma", "bridge"})
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);
BENCHMARK(solve_of_elements)->Apply(samples);
BENCHMARK(adaptive_relaxation)
    ->Args({1024, 250, 40})
    ->ArgNames({"nodes", "gamma", "bridge"})
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);

BENCHMARK_MAIN();
