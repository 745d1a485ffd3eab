#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

#include "campaign/study_folder.hpp"
#include "commands.hpp"
#include "film_reading.hpp"
#include "print.hpp"
#include "report/film_text.hpp"
#include "report/states_table.hpp"
#include "report/summary/summary.hpp"
#include "run_status.hpp"
#include "statistics/numbers_text.hpp"
#include "validation/studies.hpp"

namespace arenite::app {
namespace {

namespace fs = std::filesystem;

struct ShowArguments {
  std::string result;
  FilmReading reading;
  bool json = false, all = false, states = false, numbers = false;
};

constexpr const char* give_a_result =
    "give the folder that `arenite run`, `arenite film` or `arenite load --out` wrote, or a .h5 file of it";

bool is_study(const fs::path& folder) {
  std::error_code error;
  return fs::exists(folder / "runs.tsv", error) || fs::is_directory(folder / "runs", error);
}

bool holds_maps(const fs::path& folder) {
  std::error_code error;
  for (const std::string& ending : io::film_endings_to_write(true))
    for (const char* map : {"in_phase", "jump"})
      if (fs::exists(folder / (std::string(map) + ending), error) &&
          fs::exists(folder / ("standard_error" + ending), error))
        return true;
  return false;
}

/// Files of a result end in .h5; a film's frames have numbers in their names.
bool may_hold_something(const fs::path& folder) {
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (!entry->is_directory(error) &&
        (name.ends_with(".h5") || std::any_of(name.begin(), name.end(), [](char c) { return c >= '0' && c <= '9'; })))
      return true;
  }
  return static_cast<bool>(error);
}

/// Why a study's run, of this folder, failed.
std::optional<std::string> failure_of(const fs::path& folder) {
  std::error_code error;
  const fs::path run = fs::canonical(folder, error);
  const campaign::StudyFolder study(run.parent_path().parent_path());
  const auto state = campaign::read_status(study, run.filename().string());
  return state && state->kind == campaign::RunState::Kind::failed ? std::optional(state->reason) : std::nullopt;
}

void refuse(const fs::path& path, bool study_passes) {
  std::error_code error;
  const std::string name = path.string();
  if (fs::is_directory(path, error)) {
    if (is_study(path)) {
      if (study_passes) return;
      throw InputError(name, 0,
                       fmt::format("is the folder of a study, not a result; give one of its runs, {}/runs/NAME; "
                                   "`arenite study status RECIPE --out {}` reports its progress",
                                   name, name));
    }
    if (holds_maps(path))
      throw InputError(
          name, 0, fmt::format("contains the maps of a film, one image each, and is not a result; {}", give_a_result));
    if (may_hold_something(path)) return;
    if (const auto reason = failure_of(path))
      throw InputError(
          name, 0,
          fmt::format("is a run that failed, without a result: {} (`arenite study run --retry` repeats it)", *reason));
    throw InputError(name, 0, fmt::format("is not a result; {}", give_a_result));
  }
  if (fs::is_regular_file(path, error)) {
    // A recipe as text may look like a film as text.
    if (path.extension() == ".toml")
      throw InputError(name, 0, fmt::format("is a recipe, not a result; {}", give_a_result));
    return;
  }
  const auto* source = validation::find_study(name);
  if (source && source->has_runs())
    throw InputError(
        name, 0,
        "is a built-in study, not a result; `arenite verify` runs it, and the folder of each of its runs is a result");
}

std::string shown(const ShowArguments& a) {
  refuse_no_result(a.result);
  io::refuse_other_recording(a.result);
  if (a.states) return report::states_table(a.result);
  if (io::looks_like_film(a.result)) {
    const Numbers film = report::film_summary(*io::open_film(a.result, a.reading.choice()));
    return a.json ? to_json(film, 2) + "\n" : to_text(film);
  }
  const report::Summary summary(a.result);
  if (a.numbers) return to_text(summary.numbers());
  return a.json ? to_json(summary.numbers(), 2) + "\n" : a.all ? summary.all() : summary.text();
}

/// A run that has not come to its end says where it stands before what it has finished.
std::string shown_with_status(const ShowArguments& a) {
  const auto status = a.states ? std::nullopt : read_run_status(a.result);
  if (!status) return shown(a);
  const bool has_stages = may_hold_something(a.result);
  if (!a.json) return run_status_text(a.result) + (has_stages ? "\n" + shown(a) : "");
  Numbers numbers = has_stages ? report::Summary(a.result).numbers() : Numbers::tree();
  numbers["running"] = run_status_numbers(*status);
  numbers["running"]["alive"] = life_of(*status, a.result) == Life::running;
  return to_json(numbers, 2) + "\n";
}

}  // namespace

void refuse_no_result(const std::string& path) { refuse(path, false); }
void refuse_neither_result_nor_study(const std::string& path) { refuse(path, true); }

void add_show(Options& command, int&) {
  const auto a = std::make_shared<ShowArguments>();
  command
      .add("result", a->result,
           "Stage file (.h5) or folder of a run, or a film: a file, a folder of frames, or a name with *")
      .required()
      .type("RESULT");
  command.add("--json", a->json,
              "Print everything as JSON: provenance, stages, statistics of the last state; or the metadata of a film");
  command.add("--all", a->all, "Print every number, not only the headlines").not_with("--json");
  command
      .add("--numbers", a->numbers,
           "Print every number under its name in files and tables, with its error, unit and meaning")
      .not_with("--json")
      .not_with("--all")
      .not_with("--states");
  command
      .add("--states", a->states, "Print one row per stored state as CSV: strains, stress and fabric along the loading")
      .not_with("--json")
      .not_with("--all");
  a->reading.add_to(command);
  command.work = [a] { put(stdout, shown_with_status(*a)); };
}

}  // namespace arenite::app
