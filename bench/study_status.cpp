#include <benchmark/benchmark.h>

#include <filesystem>

#include "campaign/study_folder.hpp"
#include "core/hash.hpp"
#include "io/disk/file.hpp"

// What `arenite study status` reads: the table of runs and the journal of a study of many runs.
namespace {

using namespace arenite;

campaign::Study study_of(std::size_t runs) {
  campaign::Study study;
  study.keys = {"bidisperse.size_ratio", "cement.width", "seed"};
  const std::string hash(32, 'a');
  for (std::size_t r = 0; r < runs; ++r) {
    campaign::StudyRun run{"0123456789" + std::to_string(100'000 + r),
                           {{"bidisperse.size_ratio", "1.25"}, {"cement.width", "0.2"}, {"seed", std::to_string(r)}},
                           {}};
    for (const char* stage : {"packing", "compact", "rest", "cement", "tension"})
      run.stages.push_back({stage, hash, {}, false});
    study.runs.push_back(std::move(run));
  }
  return study;
}

void StatusOfRuns(benchmark::State& state) {
  const auto runs = static_cast<std::size_t>(state.range(0));
  const auto path = std::filesystem::temp_directory_path() / "arenite-bench-status";
  const campaign::StudyFolder folder(path);
  campaign::Study study = study_of(runs);
  {
    const io::AppendLog journal(folder.journal());
    for (const auto& run : study.runs)
      campaign::note_state(journal, run.name, {campaign::RunState::Kind::running, 0, {}});
    for (const auto& run : study.runs)
      campaign::note_state(journal, run.name, {campaign::RunState::Kind::done, 1.25, {}});
  }
  io::write_atomically(path / "recipe.toml", "seed = 1\n");
  study.file = path / "recipe.toml";
  study.inputs = {{study.file, content_hash("seed = 1\n")}};
  campaign::write_runs(path / "runs.tsv", study);
  for (auto _ : state) {
    campaign::Study read;
    read.file = study.file;
    if (!campaign::read_runs(path / "runs.tsv", read)) state.SkipWithError("the table of runs is not read");
    benchmark::DoNotOptimize(campaign::read_states(folder).size());
  }
  std::filesystem::remove_all(path);
}
BENCHMARK(StatusOfRuns)->Arg(1000)->Arg(20000)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
