#include "print.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <set>

#include "campaign/key_words.hpp"
#include "core/text.hpp"
#include "io/disk/store_file.hpp"
#include "progress.hpp"
#include "report/film_text.hpp"
#include "report/page.hpp"
#include "report/run_drawing.hpp"
#include "report/study/default_figures.hpp"
#include "report/study/study_page.hpp"
#include "report/summary/summary.hpp"
#include "study_parts.hpp"
#include "workflow/store.hpp"

namespace arenite::app {
namespace {

using campaign::RunState;

std::string counted(std::size_t n, const char* one, const char* many) {
  return fmt::format("{} {}", n, n == 1 ? one : many);
}

/// Every stage by its name, in the order of the runs.
std::string stage_lines(const campaign::Study& study, const campaign::StudyFolder& folder) {
  struct Stage {
    std::size_t wanted = 0, there = 0;
    std::set<std::string> different;
  };
  std::vector<std::string> order;
  std::map<std::string, Stage> stages;
  std::error_code error;
  for (const auto& run : study.runs)
    for (const auto& planned : run.stages) {
      Stage& stage = stages[planned.name];
      if (stage.wanted++ == 0) order.push_back(planned.name);
      if (stage.different.insert(planned.hash).second)
        stage.there += std::filesystem::exists(workflow::stored_file(folder.store, planned.hash), error);
    }
  std::string text = fmt::format("{:<16} {:>8} {:>10} {:>14}\n", "stage", "wanted", "different", "in the store");
  for (const auto& name : order) {
    const Stage& stage = stages[name];
    text += fmt::format("{:<16} {:>8} {:>10} {:>14}\n", name, stage.wanted, stage.different.size(), stage.there);
  }
  return text;
}

std::string saved_line(const campaign::StudyFolder& folder) {
  const auto account = workflow::read_account(folder.store);
  if (account.computed + account.reused == 0) return {};
  return fmt::format("store: {} computed in {} of CPU time; {} reused, which saved {} of CPU time\n",
                     counted(account.computed, "stage", "stages"), duration_text(account.seconds_computed),
                     account.reused, duration_text(account.seconds_saved));
}

}  // namespace

std::string plan_text(const campaign::Study& study, const campaign::StudyFolder& folder, std::size_t jobs) {
  std::string text = study.title.empty() ? "" : study.title + "\n\n";
  text += "run               values\n";
  for (const auto& run : study.runs) text += fmt::format("{}  {}\n", run.name, campaign::describe(run));
  const auto runs = campaign::shard_of(study, 0, 1);
  text += fmt::format("\n{}", counted(study.runs.size(), "run", "runs"));
  text += "\n\n" + stage_lines(study, folder) + "\n";
  const double seconds = campaign::seconds_of_missing(study, runs, folder);
  if (std::isnan(seconds))
    text += "time: not known until the first run has ended, because some stages have not been timed yet\n";
  else if (seconds == 0) text += "time: all stages are in the store\n";
  else
    text += fmt::format("time: about {} of CPU time left, {} with {} at a time\n", duration_text(seconds),
                        duration_text(seconds / static_cast<double>(jobs)), counted(jobs, "run", "runs"));
  return text;
}

std::string status_text(const campaign::Study& study, const campaign::StudyFolder& folder) {
  const auto states = campaign::read_states(folder);
  std::map<RunState::Kind, std::size_t> count;
  std::set<std::string> seen;
  std::string failures;
  for (const auto& run : study.runs) {
    if (!seen.insert(run.name).second) continue;
    const auto at = states.find(run.name);
    const RunState state = at == states.end() ? RunState{} : at->second;
    ++count[state.kind];
    if (state.kind == RunState::Kind::failed || state.kind == RunState::Kind::unfinished)
      failures += fmt::format("{}  {} ({}): {}\n", run.name, campaign::word_for(state.kind), campaign::describe(run),
                              state.reason);
  }
  std::string text = fmt::format("{}:", counted(seen.size(), "run", "runs"));
  const char* separator = " ";
  for (const auto kind : {RunState::Kind::done, RunState::Kind::running, RunState::Kind::waiting,
                          RunState::Kind::unfinished, RunState::Kind::failed})
    if (count[kind] > 0)
      text += fmt::format("{}{} {}", std::exchange(separator, ", "), count[kind], campaign::word_for(kind));
  text += "\n" + saved_line(folder);
  if (!failures.empty()) text += "\n" + failures + "`--retry` repeats these\n";
  return text;
}

campaign::StudyOutcome run_missing(const campaign::Study& study, const campaign::StudyFolder& folder,
                                   campaign::StudyOptions options, bool quiet) {
  options.numbers = [](const workflow::RunOutcome& outcome) { return report::Summary(outcome).numbers(); };
  options.film_numbers = report::film_numbers;
  options.asked_to_stop = [also = options.asked_to_stop] { return stop_requested() || also(); };
  options.notice = [](const std::string& sentence) { print(stderr, "{}\n", sentence); };
  StudyLine line(quiet);
  options.progress = [&](const campaign::StudyProgress& progress) { line.show(progress); };
  return campaign::run_study(study, folder, options);
}

std::filesystem::path figures_of(const campaign::Study& study) {
  return std::filesystem::path(study.file).parent_path() / "figures.toml";
}

std::vector<report::Figure> read_study_figures(const campaign::Study& study) {
  const std::filesystem::path declared = figures_of(study);
  std::ifstream in(declared, std::ios::binary);
  if (!in && !std::filesystem::exists(declared)) return {};
  if (!in)
    throw InputError(declared.string(), 0,
                     "cannot be read; it declares the figures of the study, each as one [[figures]] (docs/studies.md)");
  std::vector<std::string> notices;
  auto figures = report::read_figures({std::istreambuf_iterator<char>(in), {}}, declared.string(), &notices);
  for (const std::string& sentence : notices) print(stderr, "{}: {}\n", declared.string(), sentence);
  return figures;
}

namespace {

constexpr std::size_t most_pages = 24;  // of runs, each some megabytes

/// "Silo: D = 30 mm", by what varies.
std::string title_of_run(const campaign::Study& study, const std::string& run) {
  const auto at = std::ranges::find(study.runs, run, &campaign::StudyRun::name);
  if (at == study.runs.end() || at->values.empty()) return run;
  std::vector<std::string> said;
  for (const auto& [key, value] : at->values) {
    const recipe::Node node = recipe::parse_value(value);
    said.push_back(fmt::format("{} = {}", campaign::words_of_key(study.tree, key),
                               node.kind == recipe::Node::Kind::text ? node.text : value));
  }
  return (study.title.empty() ? "" : study.title + ": ") + list_of(said);
}

/// The page of a run, made where it is not there; relative to the study's page. Of many runs the folder, which a
/// browser lists.
std::string link_to_run(const campaign::StudyFolder& folder, const campaign::Study& study, const std::string& run,
                        bool with_page) {
  const std::filesystem::path of_run = folder.run(run), page = of_run / "report.html";
  const auto from_study = [&](const std::filesystem::path& path) {
    return path.lexically_relative(folder.out).generic_string();
  };
  if (std::filesystem::exists(page)) return from_study(page);
  if (!std::filesystem::exists(of_run)) return {};
  // Another shard may be at that run: a page of what there is by now would stay.
  const auto is_settled = [&] {
    const auto status = campaign::read_status(folder, run);
    return status && status->settled();
  };
  if (!with_page || !is_settled()) return from_study(of_run) + "/";
  try {
    report::write_page(page, io::stage_files(of_run), title_of_run(study, run));
  } catch (const InputError&) { return from_study(of_run) + "/"; }  // nothing that a page shows
  return from_study(page);
}

}  // namespace

std::filesystem::path write_study_figures(const campaign::Study& study, const campaign::StudyFolder& folder) {
  report::RunNumbers numbers;
  auto table = campaign::collect(study, folder);
  auto figures = read_study_figures(study);
  report::StudyTests tests;
  if (figures.empty()) {
    tests = report::tests_of_study(folder.out, table);
    figures = report::default_figures(table, tests.headlines());
  }
  const bool few = table.rows.size() <= most_pages;
  report::StudyPage page{study.title,
                         std::move(figures),
                         std::move(table),
                         [&](const std::string& run, const std::string& path, const report::Figure& figure) {
                           return numbers.with(folder.run(run), path, figure);
                         },
                         [&](const std::string& run, const report::Figure& figure) {
                           return report::run_drawing(folder.run(run), figure);
                         },
                         [&](const std::string& run) { return link_to_run(folder, study, run, few); },
                         std::move(tests)};
  const std::filesystem::path file = folder.out / "study.html";
  report::write_study_page(file, page);
  return file;
}

}  // namespace arenite::app
