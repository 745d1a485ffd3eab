#include "campaign/study_folder.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <string_view>
#include <utility>

#include "core/hash.hpp"
#include "core/text.hpp"
#include "core/version.hpp"
#include "io/disk/file.hpp"
#include "io/results/results.hpp"
#include "io/table/table.hpp"
#include "workflow/result_folder.hpp"

// runs.tsv: lines of cells with tabs between them. First what it was made from, then one line a run: name, swept
// values, and for each stage its hash, "field" or "stage", and its name.

namespace arenite::campaign {

namespace fs = std::filesystem;

namespace {

using Kind = RunState::Kind;

constexpr std::array words{"waiting", "running", "done", "unfinished", "failed"};

std::optional<Kind> kind_of(std::string_view word) {
  for (std::size_t k = 0; k < words.size(); ++k)
    if (word == words[k]) return static_cast<Kind>(k);
  return std::nullopt;
}

std::string_view cut(std::string_view& line) {
  const auto end = std::min(line.find('\t'), line.size());
  const auto cell = line.substr(0, end);
  line.remove_prefix(std::min(end + 1, line.size()));
  return cell;
}

/// "done", seconds, reason, with tabs between them.
std::optional<RunState> state_in(std::string_view line) {
  const auto kind = kind_of(cut(line));
  if (!kind) return std::nullopt;
  RunState state{*kind, parse_number<double>(cut(line)).value_or(0), {}};
  state.reason = line;
  return state;
}

std::string text_of(const RunState& state) {
  std::string reason = state.reason;
  std::replace_if(
      reason.begin(), reason.end(), [](char c) { return c == '\n' || c == '\t'; }, ' ');
  return fmt::format("{}\t{:.6g}\t{}", word_for(state.kind), state.seconds, reason);
}

constexpr std::string_view first_line = "arenite runs 1";

std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  for (bool more = true; more; cells.push_back(cut(line))) more = line.find('\t') != line.npos;
  return cells;
}

/// What the runs follow from besides the inputs.
std::string made_with(const Study& study) {
  HashBuilder hash;
  hash.add("version", version).add("keys", workflow::key_versions());
  for (const auto& assignment : study.overrides) hash.add("set", assignment);
  return hash.hex();
}

std::string line_of(const StudyRun& run) {
  std::string line = fmt::format("run\t{}\t{}", run.name, run.values.size());
  for (const auto& [key, value] : run.values) line += fmt::format("\t{}\t{}", key, value);
  for (const workflow::PlannedStage& stage : run.stages)
    line += fmt::format("\t{}\t{}\t{}", stage.hash, stage.field ? "field" : "stage", stage.name);
  return line + "\n";
}

StudyRun run_in(const std::vector<std::string_view>& cells) {
  StudyRun run;
  run.name = cells[1];
  const auto values = parse_number<std::size_t>(cells[2]).value_or(0);
  for (std::size_t v = 0; v < values; ++v) run.values.emplace_back(cells[3 + 2 * v], cells[4 + 2 * v]);
  for (std::size_t at = 3 + 2 * values; at + 2 < cells.size(); at += 3) {
    run.stages.push_back(workflow::planned_stage(static_cast<int>(run.stages.size()) + 1, std::string(cells[at + 2]),
                                                 std::string(cells[at]), cells[at + 1] == "field"));
  }
  return run;
}

bool is_as_it_was(const std::string& file, std::string_view hash) {
  try {
    return content_hash(io::read_file(file)) == hash;
  } catch (const InputError&) { return false; }
}

}  // namespace

const char* word_for(RunState::Kind kind) { return words[static_cast<std::size_t>(kind)]; }

StudyFolder::StudyFolder(fs::path folder, fs::path shared)
    : out(std::move(folder)),
      store(shared.empty() ? out / "store" : std::move(shared)) {}

void note_state(const io::AppendLog& journal, const std::string& run, const RunState& state) {
  const auto now =
      std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::system_clock::now().time_since_epoch());
  journal.add(fmt::format("{}\t{}\t{}", now.count(), run, text_of(state)));
}

namespace {

/// Of a run that was begun more than once, or has not ended by its journal: its lock says whether it runs, its own file
/// how it ended, and the journal what that cost.
RunState state_now(const StudyFolder& folder, const std::string& run, const std::vector<RunState>& ended) {
  if (io::FileLock::is_held(folder.lock(run))) return {Kind::running, 0, {}};
  RunState state = read_status(folder, run).value_or(RunState{});
  for (const RunState& attempt : ended)
    if (attempt.kind == state.kind && attempt.reason == state.reason) state.seconds = attempt.seconds;
  return state;
}

}  // namespace

RunStates read_states(const StudyFolder& folder) {
  struct Attempts {
    int begun = 0;
    std::vector<RunState> ended;
  };
  std::unordered_map<std::string, Attempts> known;
  io::read_log(folder.journal(), [&](std::string_view line) {
    cut(line);  // when: clocks of several machines do not say which of two lines came last
    const std::string run(cut(line));
    auto state = state_in(line);
    if (!state) return;
    if (state->kind == Kind::running) ++known[run].begun;
    else known[run].ended.push_back(std::move(*state));
  });
  RunStates states;
  for (auto& [run, attempts] : known) {
    const bool once = attempts.begun <= 1 && attempts.ended.size() == 1;
    states.emplace(run, once ? std::move(attempts.ended.front()) : state_now(folder, run, attempts.ended));
  }
  return states;
}

void write_status(const StudyFolder& folder, const std::string& run, const RunState& state) {
  RunState timeless = state;  // so that the same run leaves the same bytes
  timeless.seconds = 0;
  io::write_atomically(folder.status(run), text_of(timeless) + "\n");
}

std::optional<RunState> read_status(const StudyFolder& folder, const std::string& run) {
  std::error_code error;
  if (!fs::exists(folder.status(run), error)) return std::nullopt;
  std::string text = io::read_file(folder.status(run));
  while (text.ends_with('\n')) text.pop_back();
  return state_in(text);
}

void keep_numbers(const fs::path& run, const Numbers& numbers) {
  io::write_atomically(run / "numbers.json", to_json(numbers, 2) + "\n");
  io::write_numbers_file(run / "numbers.hdf5", numbers);
}

Numbers numbers_of(const fs::path& run) { return io::read_numbers_file(run / "numbers.hdf5"); }

RunResult result_of(const StudyFolder& folder, const StudyRun& run) {
  RunResult result;
  result.folder = folder.run(run.name);
  result.state = read_status(folder, run.name).value_or(RunState{});
  std::error_code error;
  for (const workflow::PlannedStage& stage : run.stages)
    if (const fs::path file = result.folder / stage.file; fs::is_regular_file(file, error))
      (stage.field ? result.fields : result.stages).push_back(file);
  result.numbers = numbers_of(result.folder);
  return result;
}

void note_runs_of_version_0_1(const fs::path& out, Study& study) {
  std::error_code error;
  std::size_t count = 0;
  for (const auto& entry : fs::directory_iterator(out / "runs", error))
    count += fs::exists(entry.path() / "numbers.json", error) && !fs::exists(entry.path() / "numbers.hdf5", error);
  if (count == 0) return;
  study.notices.push_back(
      fmt::format("runs of version 0.1 in {} ({}) are not reused; all runs are computed again beside them",
                  (out / "runs").string(), count));
}

void write_runs(const std::filesystem::path& file, const Study& study) {
  std::string text = fmt::format("{}\nmade\t{}\n", first_line, made_with(study));
  for (const auto& [path, hash] : study.inputs) text += fmt::format("input\t{}\t{}\n", path, hash);
  text += fmt::format("title\t{}\n", recipe::toml_text(study.title));
  for (const auto& key : study.keys) text += fmt::format("key\t{}\n", key);
  for (const auto& run : study.runs) text += line_of(run);
  io::write_atomically(file, text + "end\n");
}

bool read_runs(const std::filesystem::path& file, Study& study) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return false;
  const std::string text = io::read_file(file);
  Study read;
  read.file = study.file;
  read.overrides = study.overrides;
  io::Lines lines(text);
  std::string_view line;
  if (!text.ends_with("\nend\n") || !lines.next(line) || line != first_line) return false;
  bool has_recipe = false;
  while (lines.next(line)) {
    const auto cells = cells_of(line);
    if (cells[0] == "made" && cells[1] != made_with(study)) return false;
    if (cells[0] == "input") {
      if (!is_as_it_was(std::string(cells[1]), cells[2])) return false;
      has_recipe = has_recipe || cells[1] == study.file;
      read.inputs.emplace_back(cells[1], cells[2]);
    }
    if (cells[0] == "title") read.title = recipe::parse_value(std::string(cells[1])).text;
    if (cells[0] == "key") read.keys.emplace_back(cells[1]);
    if (cells[0] == "run") read.runs.push_back(run_in(cells));
  }
  if (!has_recipe) return false;
  study = std::move(read);
  return true;
}

}  // namespace arenite::campaign
