// The passes of the static solver in space, a node: elements, and lattices of 32 and 122 bonds.
#include <benchmark/benchmark.h>

#include "../tests/support/element_samples.hpp"
#include "process_use.hpp"
#include "solid/elements/kernels/kernels.hpp"
#include "solid/peridynamics/kernels/space_kernels.hpp"

namespace {

using namespace arenite;
using statics::FieldIn;

auto of_elements(const VoxelMap& map) { return elements::make_elements<3>(map, {}); }
auto of_32_bonds(const VoxelMap& map) { return peridynamics::make_space_bonds(map, {}, 2); }
auto of_122_bonds(const VoxelMap& map) { return peridynamics::make_space_bonds(map, {}, 3); }

template <class T> FieldIn<3, T> ramp(const statics::Grid& grid) {
  FieldIn<3, T> u(grid.padded_size());
  grid.each([&](std::ptrdiff_t i, int level) {
    u.set(i, {1e-3 * static_cast<double>(i * 37 % 101), 1e-3 * static_cast<double>(i * 11 % 89), 1e-3 * level});
  });
  return u;
}

template <class Pass> void measure(benchmark::State& state, const VoxelMap& map, const Pass& pass) {
  const double start = bench::cpu_seconds();
  for (auto _ : state) pass();
  const double seconds = bench::cpu_seconds() - start;
  state.counters["ns_per_node"] =
      1e9 * seconds / static_cast<double>(state.iterations()) / static_cast<double>(map.size());
}

/// Voxels a side; whether all pores are filled.
VoxelMap sample(const benchmark::State& state) {
  return test::cemented_spheres(static_cast<int>(state.range(0)), state.range(1) != 0);
}

template <auto make> void chebyshev_step(benchmark::State& state) {
  const VoxelMap map = sample(state);
  const auto cut = make(map);
  const FieldIn<3, float> z = ramp<float>(cut.grid), r = ramp<float>(cut.grid);
  FieldIn<3, float> older(cut.grid.padded_size());
  const std::vector<std::uint8_t> prescribed(static_cast<std::size_t>(cut.grid.size()[2]), 0);
  const auto inverse = statics::inverse_diagonal(cut.grid, block_diagonal(cut), prescribed);
  const auto& kernels = kernels_of(cut);
  measure(state, map,
          [&] { kernels.chebyshev(cut, pointers(z), pointers(older), pointers(r), inverse.pointers(), 0.3f, 0.2f); });
  state.SetLabel(kernels.name);
}

template <auto make> void force(benchmark::State& state) {
  const VoxelMap map = sample(state);
  const auto cut = make(map);
  const std::vector<std::uint8_t> prescribed(static_cast<std::size_t>(cut.grid.size()[2]), 0);
  const FieldIn<3, double> u = ramp<double>(cut.grid);
  FieldIn<3, double> f(cut.grid.padded_size());
  const auto& kernels = kernels_of(cut);
  measure(state, map,
          [&] { benchmark::DoNotOptimize(kernels.force(cut, prescribed.data(), pointers(u), pointers(f))); });
  state.SetLabel(kernels.name);
}

void samples(benchmark::internal::Benchmark* b) {
  b->ArgNames({"voxels", "filled"});
  for (const int voxels : {32, 128})
    for (const int filled : {0, 1}) b->Args({voxels, filled});
  b->Unit(benchmark::kMillisecond);
}

}  // namespace

BENCHMARK(chebyshev_step<of_elements>)->Apply(samples);
BENCHMARK(chebyshev_step<of_32_bonds>)->Apply(samples);
BENCHMARK(chebyshev_step<of_122_bonds>)->Apply(samples);
BENCHMARK(force<of_elements>)->Apply(samples);
BENCHMARK(force<of_32_bonds>)->Apply(samples);
BENCHMARK(force<of_122_bonds>)->Apply(samples);

BENCHMARK_MAIN();
