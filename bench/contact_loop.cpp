// Speed of the engine that `arenite run` uses, its list checked every step. Counters: Mps, million particle-steps per
// second of user time and core; steps_per_build of the contact list. The label is the hash of the state reached.
#include <benchmark/benchmark.h>
#include <fmt/core.h>

#include "core/threads.hpp"
#include "process_use.hpp"
#include "samples.hpp"

namespace {

using namespace arenite;

template <int D>
dem::EngineIn<D> engine_of(const PackingIn<D>& packing, dem::IntegratorKind integrator, int threads = 1,
                           const dem::ContactParameters& contact = bench::contact_parameters()) {
  dem::IntegrationParameters integration;
  integration.integrator = integrator;
  integration.threads = threads;
  integration.safety = 0.05;
  return dem::EngineIn<D>(packing, contact, integration);
}

/// Advances by `steps` an iteration, calling `before_each` first.
template <int D, class Prepare>
void measure(benchmark::State& state, dem::EngineIn<D>& engine, std::int64_t steps, Prepare&& before_each) {
  engine.advance(100);
  const auto builds = engine.builds;
  const auto first = engine.step;
  double seconds = 0;
  std::uint64_t hash = 0;  // after the first iteration: how many follow depends on the machine
  for (auto _ : state) {
    before_each();
    const double start = bench::user_seconds();
    engine.advance(steps);
    seconds += bench::user_seconds() - start;
    if (hash == 0) hash = state_hash(engine);
  }
  const auto done = static_cast<double>(engine.step - first);
  state.counters["Mps"] = 1e-6 * done * static_cast<double>(grain_count(engine)) / seconds;
  const auto built = static_cast<double>(engine.builds - builds);
  state.counters["steps_per_build"] = built > 0 ? done / built : 0;
  state.SetLabel(fmt::format("{} {:016x}", engine.kernel->name, hash));
}

template <int D>
void at_rest(benchmark::State& state, const PackingIn<D>& (*packing)(), dem::IntegratorKind integrator, int threads) {
  dem::EngineIn<D> engine = engine_of(packing(), integrator, threads);
  measure(state, engine, 2'000'000 / static_cast<std::int64_t>(grain_count(engine)), [] {});
}

/// Springs of friction at every contact of spheres, as LAMMPS's gran/hooke/history has them.
void history(benchmark::State& state, const PackingIn<3>& (*packing)()) {
  dem::ContactParameters contact = bench::contact_parameters();
  contact.friction_law = dem::CundallStrack{};
  dem::EngineIn<3> engine = engine_of(packing(), dem::IntegratorKind::velocity_verlet, 1, contact);
  measure(state, engine, 2'000'000 / static_cast<std::int64_t>(grain_count(engine)), [] {});
}

/// Springs of friction and rolling resistance at every contact, of spheres also against twisting, as LAMMPS's granular
/// style with linear_history and sds has them.
template <int D>
void rolling(benchmark::State& state, const PackingIn<D>& (*packing)(), dem::IntegratorKind integrator) {
  dem::ContactParameters contact = bench::contact_parameters();
  contact.friction_law = dem::CundallStrack{};
  dem::ElasticPlasticRolling law{0.1};
  if (D == 3) law.twisting = 0.1;
  contact.rolling = law;
  dem::EngineIn<D> engine = engine_of(packing(), integrator, 1, contact);
  measure(state, engine, 500, [] {});
}

/// Springs of friction at every contact, of disks also rolling resistance, and bonds between all neighbours.
template <int D>
void bonded(benchmark::State& state, const PackingIn<D>& (*packing)(), dem::IntegratorKind integrator) {
  dem::ContactParameters contact = bench::contact_parameters();
  contact.friction_law = dem::CundallStrack{};
  if (D == 2) contact.rolling = dem::ElasticPlasticRolling{0.1};
  contact.bonds = bench::bond();
  dem::EngineIn<D> engine = engine_of(packing(), integrator, 1, contact);
  make_bonds(engine);
  measure(state, engine, 500, [] {});
}

/// Walls that open and close again on the jammed sample so fast that the list is rebuilt about every 20 steps.
void compaction(benchmark::State& state, dem::IntegratorKind integrator) {
  dem::Engine engine = engine_of(bench::walls_4000(), integrator);
  double speed = -0.5 * engine.skin / (21 * engine.dt);
  measure(state, engine, 200, [&] {
    using Kind = dem::WallDrive::Kind;
    set_drives(
        engine,
        {{{Kind::velocity, speed}, {Kind::velocity, -speed}, {Kind::velocity, speed}, {Kind::velocity, -speed}}});
    speed = -speed;
  });
}

constexpr auto verlet = dem::IntegratorKind::velocity_verlet, gear = dem::IntegratorKind::gear5;
#define ARENITE_CASE(name, ...) \
  BENCHMARK_CAPTURE(__VA_ARGS__)->Name(name)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()
ARENITE_CASE("walls_4000/verlet", at_rest, a, bench::walls_4000, verlet, 1);
ARENITE_CASE("walls_4000/gear", at_rest, b, bench::walls_4000, gear, 1);
ARENITE_CASE("walls_4000/verlet/two_threads", at_rest, c, bench::walls_4000, verlet, 2)->UseRealTime();
ARENITE_CASE("walls_4000/gear/two_threads", at_rest, d, bench::walls_4000, gear, 2)->UseRealTime();
ARENITE_CASE("periodic_100000/verlet", at_rest, e, bench::periodic_100000, verlet, 1);
ARENITE_CASE("periodic_100000/gear", at_rest, f, bench::periodic_100000, gear, 1);
ARENITE_CASE("periodic_100000/verlet/two_threads", at_rest, l, bench::periodic_100000, verlet, 2)->UseRealTime();
ARENITE_CASE("compaction_4000/verlet", compaction, g, verlet);
ARENITE_CASE("compaction_4000/gear", compaction, h, gear);
ARENITE_CASE("clumps_4000/verlet", at_rest, m, bench::clumps_4000, verlet, 1);
ARENITE_CASE("polygons_4000/verlet", at_rest, n, bench::polygons_4000, verlet, 1);
ARENITE_CASE("rolling_4000/verlet", rolling, i, bench::walls_4000, verlet);
ARENITE_CASE("rolling_4000/gear", rolling, j, bench::walls_4000, gear);
ARENITE_CASE("bonded_4000/verlet", bonded, k, bench::walls_4000, verlet);
ARENITE_CASE("spheres_4000/verlet", at_rest, o, bench::spheres_4000, verlet, 1);
ARENITE_CASE("spheres_4000/gear", at_rest, p, bench::spheres_4000, gear, 1);
ARENITE_CASE("spheres_4000/history", history, q, bench::spheres_4000);
ARENITE_CASE("spheres_4000/rolling", rolling, u, bench::spheres_4000, verlet);
ARENITE_CASE("spheres_4000/bonded", bonded, v, bench::spheres_4000, verlet);
ARENITE_CASE("spheres_100000/verlet", at_rest, r, bench::spheres_100000, verlet, 1);
ARENITE_CASE("spheres_100000/history", history, s, bench::spheres_100000);
ARENITE_CASE("spheres_1000000/verlet", at_rest, t, bench::spheres_1000000, verlet, 1);

/// Two meetings of two threads with nothing to do, as a step has them: what a step of two threads pays beside its own
/// work.
void meetings(benchmark::State& state) {
  const ThreadPool pool(2);
  for (auto _ : state)
    for (int meeting = 0; meeting < 2; ++meeting)
      pool.for_ranges(4000, [](std::size_t begin, std::size_t) { benchmark::DoNotOptimize(begin); });
}
BENCHMARK(meetings)->Name("two_meetings/two_threads")->Unit(benchmark::kMicrosecond)->UseRealTime();

}  // namespace

BENCHMARK_MAIN();
