// Lock-in of a film in memory beside a plain reading of the same memory, with the same team of threads, turn about.
#include "thermal/thermography/lockin.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <numbers>
#include <vector>

#include "core/random.hpp"
#include "process_use.hpp"

namespace {

using namespace arenite;
using namespace arenite::thermography;
using Clock = std::chrono::steady_clock;

constexpr double rate = 148, load = 3;

/// 320 x 240 x 8880 levels of 14 bit, unless fewer frames are asked for: an oscillation, drift and noise, written once.
const Film& film(std::size_t frames) {
  static Film f;
  if (f.about.frames == static_cast<std::int64_t>(frames)) return f;
  f.about.width = 320;
  f.about.height = 240;
  f.about.frames = static_cast<std::int64_t>(frames);
  f.about.frame_rate = rate;
  const std::size_t pixels = f.about.pixels();
  f.level.resize(pixels * frames);
  std::vector<float> noise(1 << 20);
  RandomStream random(1, Purpose::test);
  for (float& v : noise) v = static_cast<float>(4 * random.normal());
  for (std::size_t n = 0; n < frames; ++n) {
    const double t = static_cast<double>(n) / rate, signal = 10 * std::cos(2 * std::numbers::pi * load * 1.0003 * t),
                 drift = 8000 + 2 * t;
    const std::size_t from = static_cast<std::size_t>(random.below(noise.size() - pixels));
    for (std::size_t p = 0; p < pixels; ++p)
      f.level[n * pixels + p] =
          static_cast<std::uint16_t>(drift + static_cast<double>(p % 320) + signal * static_cast<double>(p % 7) / 7 +
                                     static_cast<double>(noise[from + p]));
  }
  return f;
}

/// Sum of the film's bytes as 64-bit words: as fast as this team reads memory.
double read_memory(const Film& f, const ThreadPool& pool) {
  const std::size_t words = f.level.size() / 4;
  std::vector<std::uint64_t> sums(64, 0);
  const auto begin = Clock::now();
  pool.for_ranges(words, [&](std::size_t from, std::size_t to) {
    typedef std::uint64_t Wide __attribute__((vector_size(64), aligned(2), may_alias));
    Wide a{}, b{}, c{}, d{};
    const auto* at = reinterpret_cast<const char*>(f.level.data());
    for (std::size_t w = from; w + 32 <= to; w += 32) {
      const auto* wide = reinterpret_cast<const Wide*>(at + 8 * w);
      a += wide[0], b += wide[1], c += wide[2], d += wide[3];
    }
    a += b + c + d;
    sums[from % 61] += a[0] + a[1] + a[2] + a[3] + a[4] + a[5] + a[6] + a[7];
  });
  const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  benchmark::DoNotOptimize(sums.data());
  return seconds;
}

double checksum(const LockinMaps& maps) {
  double sum = 0;
  for (const float v : maps.in_phase) sum += static_cast<double>(v);
  return sum;
}

/// Threads, frames. Rates are those of the fastest turn, as memory is shared with whoever else is on the machine; by
/// CPU time also, which says what the machine gives when nobody else is.
void lock_in_film(benchmark::State& state) {
  Film& f = const_cast<Film&>(film(static_cast<std::size_t>(state.range(1))));
  LockinOptions o;
  o.frequency = load;
  o.threads = static_cast<int>(state.range(0));
  const ThreadPool pool(o.threads);
  const double gigabytes = 2e-9 * static_cast<double>(f.level.size());
  double best = 1e9, best_read = 1e9, cpu = 1e9, read_cpu = 1e9, sum = 0;
  for (auto _ : state) {
    double before = bench::cpu_seconds();
    best_read = std::min(best_read, read_memory(f, pool));
    read_cpu = std::min(read_cpu, bench::cpu_seconds() - before);
    before = bench::cpu_seconds();
    const auto begin = Clock::now();
    const LockinMaps maps = lock_in(f, o);
    const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    cpu = std::min(cpu, bench::cpu_seconds() - before);
    best = std::min(best, seconds);
    sum = checksum(maps);
    state.SetIterationTime(seconds);
  }
  state.counters["GB_per_s"] = gigabytes / best;
  state.counters["memory_GB_per_s"] = gigabytes / best_read;
  state.counters["of_memory_speed"] = best_read / best;
  state.counters["of_memory_speed_cpu"] = read_cpu / cpu;
  state.counters["checksum"] = sum;
  state.SetLabel(kernels().name);
}

}  // namespace

BENCHMARK(lock_in_film)
    ->Args({2, 8880})
    ->Args({1, 8880})
    ->Iterations(7)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

BENCHMARK_MAIN();
