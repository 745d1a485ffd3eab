#include <benchmark/benchmark.h>

#include "../tests/support/cemented_sample.hpp"
#include "process_use.hpp"
#include "solid/peridynamics/kernels/kernels.hpp"

namespace {

using namespace arenite;
using namespace arenite::peridynamics;
using bench::cpu_seconds;

/// Size ratio times 100 and bridge width times 100 as arguments; 1000 and more fills all pores.
PhaseMap sample(const benchmark::State& state) {
  test::CementedSample s;
  s.size_ratio = static_cast<double>(state.range(0)) / 100;
  s.bridge = static_cast<double>(state.range(1)) / 100;
  return test::cemented_sample(s);
}

template <class T> Field<T> ramp(const Grid& grid) {
  Field<T> u(grid.padded_size());
  for (int y = 0; y < grid.height; ++y)
    for (int x = 0; x < grid.width; ++x) {
      u.x[grid.index(x, y)] = static_cast<T>(1e-3 * ((x * 37 + y * 11) % 101));
      u.y[grid.index(x, y)] = static_cast<T>(1e-3 * y);
    }
  return u;
}

template <class Pass> void measure(benchmark::State& state, const PhaseMap& map, const Pass& pass) {
  const double start = cpu_seconds();
  for (auto _ : state) pass();
  const double seconds = cpu_seconds() - start;
  state.counters["ns_per_node"] =
      1e9 * seconds / static_cast<double>(state.iterations()) / static_cast<double>(map.size());
  state.counters["S_m"] = test::matrix_saturation(map);
}

template <class T> void force_of_bonds(benchmark::State& state) {
  const PhaseMap map = sample(state);
  const Bonds bonds = make_bonds(map, {});
  const std::vector<std::uint8_t> prescribed(static_cast<std::size_t>(map.height), 0);
  const Field<T> u = ramp<T>(bonds.grid);
  Field<T> f(bonds.grid.padded_size());
  const Kernels& k = kernels();
  measure(state, map, [&] {
    if constexpr (std::is_same_v<T, double>)
      benchmark::DoNotOptimize(k.force(bonds, prescribed.data(), plane(u), plane(f)));
    else benchmark::DoNotOptimize(k.force_float(bonds, prescribed.data(), plane(u), plane(f)));
  });
  state.SetLabel(k.name);
}

void chebyshev_step(benchmark::State& state) {
  const PhaseMap map = sample(state);
  const Bonds bonds = make_bonds(map, {});
  const auto n = bonds.grid.padded_size();
  const Field<float> z = ramp<float>(bonds.grid), r = ramp<float>(bonds.grid);
  Field<float> older(n);
  Buffer<float> xx(n), xy(n), yy(n);
  measure(state, map, [&] {
    kernels().chebyshev(bonds, plane(z), plane(older), plane(r), {xx.data(), xy.data(), yy.data()}, 0.3f, 0.2f);
  });
}

void explicit_step(benchmark::State& state) {
  const PhaseMap map = sample(state);
  const Bonds bonds = make_bonds(map, {});
  const std::vector<std::uint8_t> prescribed(static_cast<std::size_t>(map.height), 0);
  Field<double> u = ramp<double>(bonds.grid), older = ramp<double>(bonds.grid);
  measure(state, map, [&] {
    benchmark::DoNotOptimize(kernels().stormer(bonds, prescribed.data(), plane(u), plane(older), 0.9, 0.01));
    std::swap(u, older);
  });
}

void make_all_bonds(benchmark::State& state) {
  const PhaseMap map = sample(state);
  measure(state, map, [&] { benchmark::DoNotOptimize(make_bonds(map, {}).scale); });
}

void samples(benchmark::internal::Benchmark* b) {
  for (const int gamma : {100, 250, 500})
    for (const int bridge : {20, 1000}) b->Args({gamma, bridge});
  b->Unit(benchmark::kMillisecond);
}

}  // namespace

BENCHMARK(force_of_bonds<double>)->Apply(samples);
BENCHMARK(force_of_bonds<float>)->Apply(samples);
BENCHMARK(chebyshev_step)->Apply(samples);
BENCHMARK(explicit_step)->Apply(samples);
BENCHMARK(make_all_bonds)->Args({250, 20});

BENCHMARK_MAIN();
