#include <benchmark/benchmark.h>

#include "../tests/support/cemented_sample.hpp"
#include "process_use.hpp"
#include "solid/elements/kernels/kernels.hpp"
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

auto of_bonds(const PhaseMap& map) { return make_bonds(map, {}); }
auto of_elements(const PhaseMap& map) { return elements::make_elements<2>(map, {}); }

template <class T, auto make> void force(benchmark::State& state) {
  const PhaseMap map = sample(state);
  const auto cut = make(map);
  const std::vector<std::uint8_t> prescribed(static_cast<std::size_t>(cut.grid.height), 0);
  const Field<T> u = ramp<T>(cut.grid);
  Field<T> f(cut.grid.padded_size());
  const auto& k = kernels_of(cut);
  measure(state, map, [&] {
    if constexpr (std::is_same_v<T, double>)
      benchmark::DoNotOptimize(k.force(cut, prescribed.data(), pointers(u), pointers(f)));
    else benchmark::DoNotOptimize(k.force_float(cut, prescribed.data(), pointers(u), pointers(f)));
  });
  state.SetLabel(k.name);
}

template <auto make> void chebyshev_step(benchmark::State& state) {
  const PhaseMap map = sample(state);
  const auto cut = make(map);
  const auto n = cut.grid.padded_size();
  const Field<float> z = ramp<float>(cut.grid), r = ramp<float>(cut.grid);
  Field<float> older(n);
  Buffer<float> xx(n), xy(n), yy(n);
  measure(state, map, [&] {
    kernels_of(cut).chebyshev(cut, pointers(z), pointers(older), pointers(r), {xx.data(), xy.data(), yy.data()}, 0.3f,
                              0.2f);
  });
}

void explicit_step(benchmark::State& state) {
  const PhaseMap map = sample(state);
  const Bonds bonds = make_bonds(map, {});
  const std::vector<std::uint8_t> prescribed(static_cast<std::size_t>(map.height), 0);
  Field<double> u = ramp<double>(bonds.grid), older = ramp<double>(bonds.grid);
  measure(state, map, [&] {
    benchmark::DoNotOptimize(kernels().stormer(bonds, prescribed.data(), pointers(u), pointers(older), 0.9, 0.01));
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

BENCHMARK(force<double, of_bonds>)->Apply(samples);
BENCHMARK(force<float, of_bonds>)->Apply(samples);
BENCHMARK(chebyshev_step<of_bonds>)->Apply(samples);
BENCHMARK(force<double, of_elements>)->Apply(samples);
BENCHMARK(force<float, of_elements>)->Apply(samples);
BENCHMARK(chebyshev_step<of_elements>)->Apply(samples);
BENCHMARK(explicit_step)->Apply(samples);
BENCHMARK(make_all_bonds)->Args({250, 20});

BENCHMARK_MAIN();
