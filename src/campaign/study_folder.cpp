#include "campaign/study_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>

#include "io/atomic_file.hpp"
#include "io/file_lock.hpp"
#include "io/read_file.hpp"

namespace arenite::study {

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

template <class Number>
Number number_in(std::string_view text) {
  Number value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

/// "done", seconds, reason, with tabs between them.
std::optional<RunState> state_in(std::string_view line) {
  const auto kind = kind_of(cut(line));
  if (!kind) return std::nullopt;
  RunState state{*kind, number_in<double>(cut(line)), {}};
  state.reason = line;
  return state;
}

std::string text_of(const RunState& state) {
  std::string reason = state.reason;
  std::replace_if(reason.begin(), reason.end(), [](char c) { return c == '\n' || c == '\t'; }, ' ');
  return fmt::format("{}\t{:.6g}\t{}", word_for(state.kind), state.seconds, reason);
}

}  // namespace

const char* word_for(RunState::Kind kind) { return words[static_cast<std::size_t>(kind)]; }

StudyFolder::StudyFolder(fs::path folder, fs::path shared) : out(std::move(folder)), store(shared.empty() ? out / "store" : std::move(shared)) {}

void note_state(const io::AppendLog& journal, const std::string& run, const RunState& state) {
  const auto now = std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::system_clock::now().time_since_epoch());
  journal.add(fmt::format("{}\t{}\t{}", now.count(), run, text_of(state)));
}

RunStates read_states(const StudyFolder& folder) {
  struct Dated {
    std::int64_t time = -1;
    RunState state;
  };
  std::unordered_map<std::string, Dated> latest;
  io::read_log(folder.journal(), [&](std::string_view line) {
    const auto time = number_in<std::int64_t>(cut(line));
    const std::string run(cut(line));
    auto state = state_in(line);
    Dated& known = latest[run];
    if (state && time >= known.time) known = {time, std::move(*state)};
  });
  RunStates states;
  for (auto& [run, dated] : latest) {
    if (dated.state.kind == Kind::running && !io::FileLock::is_held(folder.lock(run))) {
      // It ended between two lines of its journal, or it was killed.
      dated.state = read_status(folder, run).value_or(RunState{});
    }
    states.emplace(run, std::move(dated.state));
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

RunResult result_of(const StudyFolder& folder, const StudyRun& run) {
  RunResult result;
  result.folder = folder.run(run.name);
  result.state = read_status(folder, run.name).value_or(RunState{});
  std::error_code error;
  for (const PlannedStage& stage : run.stages)
    for (const auto& file : {result.folder / stage.file, result.folder / stage.former}) {
      if (!fs::is_regular_file(file, error)) continue;
      (stage.field ? result.fields : result.stages).push_back(file);
      break;
    }
  if (fs::exists(folder.numbers(run.name), error)) result.numbers = from_json(io::read_file(folder.numbers(run.name))).value_or(Numbers{});
  return result;
}

}  // namespace arenite::study
