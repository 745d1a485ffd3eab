#include <benchmark/benchmark.h>

#include "../tests/support/pressed_crystal.hpp"
#include "../tests/support/thermoelastic_picture.hpp"
#include "thermal/inference/contact_forces.hpp"
#include "thermal/inference/mean_forces.hpp"
#include "thermal/inference/pixel_forces.hpp"

/// Contact forces of some 700 grains from some 26 000 pixels at the thesis's pixel, lens and noise, on one core; the
/// counters hold what was solved and how well.
namespace {

using namespace arenite;
using inference::ForceOptions;

struct Sample {
  Packing truth = test::pressed_crystal(28, 28, 6.6e-3, 1), found = test::without_forces(truth);
  inference::ThermoelasticPicture picture = test::draw_thermoelastic(truth, test::factors(truth), {});
  std::vector<double> sigma, error;

  Sample() {
    RandomStream random(2, Purpose::test);
    sigma.assign(truth.grains.size(), 0);
    for (std::size_t c = 0; c < truth.contacts.size(); ++c) {
      sigma[static_cast<std::size_t>(truth.contacts.i[c])] -= truth.contacts.fn[c];
      if (!truth.contacts.is_wall(c)) sigma[static_cast<std::size_t>(truth.contacts.j[c])] -= truth.contacts.fn[c];
    }
    for (std::size_t g = 0; g < sigma.size(); ++g) {
      found.grains.position[g].x += 0.1 * picture.pixel * random.normal(),
          found.grains.position[g].y += 0.1 * picture.pixel * random.normal();
      sigma[g] /= 2 * std::numbers::pi * truth.grains.radius[g] * truth.domain.thickness;
    }
    error.assign(sigma.size(), 0.01 * std::abs(sigma[0]));
  }
};

const Sample& sample() {
  static const Sample made;
  return made;
}

void report(benchmark::State& state, const InferredForces& f) {
  state.counters["grains"] = static_cast<double>(sample().truth.grains.size());
  state.counters["contacts"] = static_cast<double>(f.contacts.size());
  state.counters["fn_error"] = test::relative_error(f.contacts.fn, sample().truth.contacts.fn);
  state.counters["ft_error"] = test::relative_error(f.contacts.ft, sample().truth.contacts.ft);
}

void pixels(benchmark::State& state) {
  ForceOptions options;
  options.inequality = state.range(0) ? inference::Inequality::cone : inference::Inequality::none;
  InferredForces f;
  const Sample& s = sample();
  for (auto _ : state) f = inference::infer_from_pixels({s.found, test::factors(s.found), {}}, s.picture, options);
  report(state, f);
}

void means(benchmark::State& state) {
  InferredForces f;
  const Sample& s = sample();
  for (auto _ : state) f = inference::infer_from_means({s.found, {}, {}}, s.sigma, s.error, {});
  report(state, f);
}

BENCHMARK(pixels)->ArgName("cone")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK(means)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
