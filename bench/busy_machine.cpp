// Whether two threads hold up what one would have done, beside other programs: the same sample is advanced by one
// thread and by two, in turn, while `loops` processes do nothing but run. Counter: gain, the speed of two threads over
// that of one. Below 0.9 the pool waits for members that have lost their processor.
#include <benchmark/benchmark.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>

#include "samples.hpp"

namespace {

using namespace arenite;

class BusyLoops {
 public:
  explicit BusyLoops(std::int64_t count) {
    for (std::int64_t n = 0; n < count; ++n) {
      const pid_t process = fork();
      if (process == 0) {
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        for (volatile std::uint64_t turn = 0;;) { turn = turn + 1; }
      }
      if (process > 0) running_.push_back(process);
    }
  }
  ~BusyLoops() {
    for (const pid_t process : running_) {
      kill(process, SIGKILL);
      waitpid(process, nullptr, 0);
    }
  }
  BusyLoops(const BusyLoops&) = delete;
  BusyLoops& operator=(const BusyLoops&) = delete;

 private:
  std::vector<pid_t> running_;
};

/// Steps a second during about a fifth of a second.
double speed(dem::Engine& engine) {
  const auto now = [] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  };
  const auto first = engine.step;
  const double start = now();
  while (now() < start + 0.2) engine.advance(20);
  return static_cast<double>(engine.step - first) / (now() - start);
}

void beside(benchmark::State& state) {
  const BusyLoops loops(state.range(0));
  const auto engine_of = [](int threads) {
    dem::IntegrationParameters integration;
    integration.threads = threads;
    integration.safety = 0.05;
    return dem::Engine(bench::walls_4000(), bench::contact_parameters(), integration);
  };
  dem::Engine one = engine_of(1), two = engine_of(2);
  double alone = 0, together = 0;
  for (auto _ : state) {
    alone += speed(one);
    together += speed(two);
  }
  state.counters["gain"] = together / alone;
}

BENCHMARK(beside)
    ->ArgName("loops")
    ->Arg(0)
    ->Arg(1)
    ->Arg(2)
    ->Arg(4)
    ->Iterations(10)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace

BENCHMARK_MAIN();
